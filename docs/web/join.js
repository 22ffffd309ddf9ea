// Puts the code of a program together again, from the streams that pack.py took it apart into.
'use strict';

// `bytes` are the streams one after the other, `sizes` that of the whole and those of the streams.
globalThis.rigid_join = function (bytes, [size, ...sizes]) {
    let begin = 0;
    const [rest, code, read, written, offsets, whole, other, calls, kinds] = sizes.map(one => ({bytes, place: begin, end: begin += one}));
    const wasm = new Uint8Array(size), body = new Uint8Array(size);
    let into = wasm, n = 0; // where the next byte goes

    function copy(stream, count) {
        for (const end = stream.place + count; stream.place < end;) into[n++] = stream.bytes[stream.place++];
    }
    // A number goes as it is; its value, for those that fit into 28 bits.
    function number(stream) {
        let value = 0, shift = 0, byte;
        do {
            byte = stream.bytes[stream.place++];
            into[n++] = byte;
            value |= (byte & 127) << shift;
            shift += 7;
        } while (byte > 127);
        return value;
    }
    function write(value) {
        for (; value > 127; value >>= 7) into[n++] = value & 127 | 128;
        into[n++] = value;
    }
    // What pack.py writes for the most frequent instructions.
    const latest = 0xC8, zero = 0xCA, unlike = 0xCB;
    // The alignments of what is loaded and stored, 0x28 to 0x3E, where the instruction is not one of those that are unlike.
    const natural = [2, 3, 2, 3, 0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 2, 3, 2, 3, 0, 1, 0, 1, 2];
    // Variables by their last use, the latest first.
    let recent = [];
    function used(rank) {
        const index = recent[rank];
        recent.copyWithin(1, 0, rank);
        recent[0] = index;
        return index;
    }
    function known(index) {
        while (recent.length <= index) recent.push(recent.length);
    }

    function instruction() {
        const op = code.bytes[code.place++];
        if (op === latest || op === latest + 1) {
            into[n++] = 0x20;
            known(op - latest);
            write(used(op - latest));
            return 0;
        }
        if (op === zero) {
            into[n++] = 0x41;
            into[n++] = 0;
            return 0;
        }
        if (op >= unlike && op < unlike + natural.length) {
            into[n++] = op - unlike + 0x28;
            number(code);
            number(offsets);
            return 0;
        }
        into[n++] = op;
        if (op === 0x20) {
            const before = n, rank = number(read);
            n = before;
            known(rank);
            write(used(rank));
        } else if (op === 0x21 || op === 0x22) {
            const index = number(written);
            known(index);
            used(recent.indexOf(index));
        } else if (op >= 0x28 && op <= 0x3E) {
            write(natural[op - 0x28]);
            number(offsets);
        } else if (op === 0x41) number(whole);
        else if (op === 0x42) number(other);
        else if (op === 0x43 || op === 0x44) copy(other, op === 0x43 ? 4 : 8);
        else if (op === 0x10) number(calls);
        else if (op === 0x11) {
            number(calls);
            number(calls);
        } else if (op === 0x02 || op === 0x03 || op === 0x04 || op === 0x06) {
            number(code);
            return 1;
        } else if (op === 0x0B) return -1;
        else if (op === 0x18) {
            number(code);
            return -1;
        } else if (op >= 0x07 && op <= 0x09 || op === 0x0C || op === 0x0D || op === 0x23 || op === 0x24 || op === 0x3F || op === 0x40 || op === 0xFC) number(code);
        else if (op === 0x0E) for (let labels = number(code) + 1; labels > 0; --labels) number(code);
        else if (op === 0xFD) {
            const vector = number(code);
            if (vector <= 11 || vector >= 84 && vector <= 93) {
                number(code);
                number(offsets);
            }
            if (vector === 12 || vector === 13) copy(other, 16);
            if (vector >= 21 && vector <= 34 || vector >= 84 && vector <= 91) copy(code, 1);
        }
        return 0;
    }

    copy(rest, 8);
    while (rest.place < rest.end) {
        const section = rest.bytes[rest.place];
        copy(rest, 1);
        const length = number(rest);
        if (section !== 10) {
            copy(rest, length);
            continue;
        }
        for (let functions = number(rest); functions > 0; --functions) {
            const start = n;
            [into, n] = [body, 0];
            for (let groups = number(kinds); groups > 0; --groups) {
                number(kinds);
                copy(kinds, 1);
            }
            recent = [];
            for (let depth = 1; depth > 0;) depth += instruction();
            const filled = n;
            [into, n] = [wasm, start];
            write(filled);
            wasm.set(body.subarray(0, filled), n);
            n += filled;
        }
    }
    return wasm;
};
