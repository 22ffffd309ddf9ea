// Unpacks LZMA (lc 1, lp 0, pb 0, without header), what pack.py ends with: a quarter smaller than gzip, and no browser has it.
// The format: Igor Pavlov, "LZMA specification" (2015, public domain).
'use strict';

globalThis.rigid_unpack = function (input, size) {
    const out = new Uint8Array(size), chances = count => new Uint16Array(count).fill(1024);
    // Range and code in an array: as variables of their own, which the functions share, each change of a number of 32 bits
    // would take memory.
    const now = Uint32Array.of(0xFFFFFFFF, (input[1] << 24) | (input[2] << 16) | (input[3] << 8) | input[4]);
    let place = 5;

    function refill() {
        if (now[0] >= 0x1000000) return;
        now[0] <<= 8;
        now[1] = (now[1] << 8) | input[place++];
    }
    function bit(p, i) {
        const chance = p[i], bound = (now[0] >>> 11) * chance;
        let value = 0;
        if (now[1] < bound) {
            now[0] = bound;
            p[i] = chance + ((2048 - chance) >> 5);
        } else {
            now[0] -= bound;
            now[1] -= bound;
            p[i] = chance - (chance >> 5);
            value = 1;
        }
        refill();
        return value;
    }
    function tree(p, bits) {
        let m = 1;
        for (let i = 0; i < bits; ++i) m = (m << 1) | bit(p, m);
        return m - (1 << bits);
    }
    function backwards(p, first, bits) {
        let m = 1, value = 0;
        for (let i = 0; i < bits; ++i) {
            const one = bit(p, first + m);
            m = (m << 1) | one;
            value |= one << i;
        }
        return value;
    }
    function plain(bits) {
        let value = 0;
        for (; bits > 0; --bits) {
            now[0] >>>= 1;
            const one = now[1] >= now[0] ? 1 : 0;
            if (one) now[1] -= now[0];
            value = (value << 1) | one;
            refill();
        }
        return value;
    }
    const lengths = () => ({choice: chances(2), low: chances(8), middle: chances(8), high: chances(256)});
    function length_of(p) {
        if (!bit(p.choice, 0)) return 2 + tree(p.low, 3);
        if (!bit(p.choice, 1)) return 10 + tree(p.middle, 3);
        return 18 + tree(p.high, 8);
    }

    const literal = chances(0x300 << 1), matches = chances(12), repeats = chances(12), first = chances(12), second = chances(12),
          third = chances(12), long_first = chances(12), slots = [0, 1, 2, 3].map(() => chances(64)), special = chances(115),
          aligned = chances(16), new_length = lengths(), old_length = lengths();
    function distance_of(length) {
        const slot = tree(slots[Math.min(length - 2, 3)], 6);
        if (slot < 4) return slot;
        const bits = (slot >> 1) - 1, begin = (2 | (slot & 1)) << bits;
        if (slot < 14) return begin + backwards(special, begin - slot, bits);
        return begin + (plain(bits - 4) << 4) + backwards(aligned, 0, 4);
    }

    let state = 0, back = [0, 0, 0, 0];
    for (let n = 0; n < size;) {
        if (!bit(matches, state)) {
            const base = 0x300 * ((n ? out[n - 1] : 0) >> 7);
            let symbol = 1;
            if (state >= 7) {
                let guess = out[n - back[0] - 1];
                do {
                    const high = (guess >> 7) & 1, one = bit(literal, base + ((1 + high) << 8) + symbol);
                    guess <<= 1;
                    symbol = (symbol << 1) | one;
                    if (high !== one) break;
                } while (symbol < 0x100);
            }
            while (symbol < 0x100) symbol = (symbol << 1) | bit(literal, base + symbol);
            out[n++] = symbol;
            state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
            continue;
        }
        let length;
        if (bit(repeats, state)) {
            if (!bit(first, state)) {
                if (!bit(long_first, state)) {
                    state = state < 7 ? 9 : 11;
                    out[n] = out[n - back[0] - 1];
                    ++n;
                    continue;
                }
            } else {
                const k = !bit(second, state) ? 1 : !bit(third, state) ? 2 : 3;
                back = [back[k], ...back.filter((one, i) => i !== k)];
            }
            length = length_of(old_length);
            state = state < 7 ? 8 : 11;
        } else {
            length = length_of(new_length);
            state = state < 7 ? 7 : 10;
            back = [distance_of(length), back[0], back[1], back[2]];
        }
        for (const end = Math.min(n + length, size); n < end; ++n) out[n] = out[n - back[0] - 1];
    }
    return out;
};
