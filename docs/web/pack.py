#!/usr/bin/env python3
"""Packs the code of a program for a page: wasm → streams of like bytes → LZMA → base64 → a script for machine.js.

    docs/web/pack.py PROGRAM.wasm PROGRAM.js

A script can be loaded from a page that was opened as a file; a .wasm can't. The same code gives the same script.

The code of functions is taken apart first (docs/web/join.js puts it together again): instructions here, names of
variables there, constants elsewhere. Beside its like each byte is foretold better, and a variable that is read is named by
how many others were used since it was used last. That is worth its lines: a program for a page has 200 kB in gzip at most.
By gzip alone 13 of the 30 programs are heavier than that, by LZMA alone 7; in streams none is, when also the most
frequent instructions have a byte of their own and an alignment is written only where it is unlike the others of its kind.
"""
import base64
import lzma
import pathlib
import sys

FILTER = {"id": lzma.FILTER_LZMA1, "dict_size": 1 << 23, "lc": 1, "lp": 0, "pb": 0, "mode": lzma.MODE_NORMAL,
          "mf": lzma.MF_BT4, "nice_len": 273, "depth": 1000}

# Bytes that are no instruction of wasm, for the most frequent ones: the variable that was used last is read, or the one
# before it; the whole number zero.
LATEST, ZERO = 0xC8, 0xCA

# What is loaded and stored, 0x28 to 0x3E, is nearly always aligned as its kind is (2^n bytes): then only the instruction is
# written; with another alignment it is one of these.
NATURAL, UNLIKE = bytes([2, 3, 2, 3, 0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 2, 3, 2, 3, 0, 1, 0, 1, 2]), 0xCB


def leb(number):
    """A number as wasm writes it: seven bits to a byte, the lowest first."""
    written = bytearray()
    while number > 127:
        written.append(number & 127 | 128)
        number >>= 7
    return bytes(written + bytes([number]))


class Module:
    """wasm that is read from its beginning to its end."""

    def __init__(self, wasm):
        self.wasm, self.place = wasm, 0
        # In the order of join.js: what is no function, instructions with what is unlike the others, variables that are
        # read, and that are written, offsets in memory, small whole numbers, other constants, functions that are called,
        # kinds of variables.
        self.streams = [bytearray() for _ in range(9)]
        self.rest, self.code, self.read, self.written, self.offsets, self.whole, self.other, self.calls, self.kinds = self.streams

    def number(self):
        value = shift = 0
        while True:
            byte = self.wasm[self.place]
            self.place += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def bytes_to(self, stream, count):
        stream += self.wasm[self.place:self.place + count]
        self.place += count

    def numbers_to(self, stream, count=1):
        for _ in range(count):
            start = self.place
            self.number()
            stream += self.wasm[start:self.place]

    def peek(self):
        start = self.place
        value = self.number()
        self.place = start
        return value

    def take_apart(self):
        self.bytes_to(self.rest, 8)
        while self.place < len(self.wasm):
            section = self.wasm[self.place]
            self.bytes_to(self.rest, 1)
            size = self.peek()
            self.numbers_to(self.rest)
            if section != 10:
                self.bytes_to(self.rest, size)
                continue
            count = self.peek()
            self.numbers_to(self.rest)
            for _ in range(count):
                self.function()
        return self.streams

    def function(self):
        start = self.place
        size = self.number()
        if self.wasm[start:self.place] != leb(size):
            raise SystemExit("a function's size is not written as short as it can be: join.js would write another file")
        end = self.place + size
        groups = self.peek()
        self.numbers_to(self.kinds)
        for _ in range(groups):
            self.numbers_to(self.kinds)
            self.bytes_to(self.kinds, 1)
        self.recent, self.depth = [], 1
        while self.depth > 0:
            self.instruction()
        if self.place != end:
            raise SystemExit(f"a function ends at byte {self.place}, not at {end} as it says")

    def variable(self):
        """The number of a variable, and how many others were used since it was used last."""
        start = self.place
        index = self.number()
        if self.wasm[start:self.place] != leb(index):
            raise SystemExit("a variable's number is not written as short as it can be: join.js would write another file")
        while len(self.recent) <= index:
            self.recent.append(len(self.recent))
        rank = self.recent.index(index)
        self.recent.insert(0, self.recent.pop(rank))
        return index, rank

    def instruction(self):
        op = self.wasm[self.place]
        if op == 0x20:  # a variable is read
            self.place += 1
            rank = self.variable()[1]
            self.code.append(LATEST + rank if rank < 2 else op)
            if rank >= 2:
                self.read += leb(rank)
            return
        if op == 0x41 and self.wasm[self.place + 1] == 0:
            self.code.append(ZERO)
            self.place += 2
            return
        self.bytes_to(self.code, 1)
        if op in (0x02, 0x03, 0x04, 0x06):  # block, loop, if, try
            self.depth += 1
            self.numbers_to(self.code)
        elif op in (0x0B, 0x18):  # end, delegate
            self.depth -= 1
            if op == 0x18:
                self.numbers_to(self.code)
        elif op in (0x07, 0x08, 0x09, 0x0C, 0x0D, 0x23, 0x24, 0x3F, 0x40):  # one number: tag, label, global
            self.numbers_to(self.code)
        elif op == 0x0E:  # a table of branches
            self.numbers_to(self.code, self.peek() + 2)
        elif op in (0x10, 0x11):
            self.numbers_to(self.calls, op - 0x0F)
        elif op in (0x21, 0x22):
            self.written += leb(self.variable()[0])
        elif 0x28 <= op <= 0x3E:  # load, store: alignment and offset
            if self.peek() == NATURAL[op - 0x28]:
                self.number()
            else:
                self.code[-1] += UNLIKE - 0x28
                self.numbers_to(self.code)
            self.numbers_to(self.offsets)
        elif op == 0x41:
            self.numbers_to(self.whole)
        elif op == 0x42:
            self.numbers_to(self.other)
        elif op in (0x43, 0x44):
            self.bytes_to(self.other, 4 if op == 0x43 else 8)
        elif op == 0xFC and self.peek() < 8:  # conversions that saturate
            self.numbers_to(self.code)
        elif op == 0xFD:
            vector = self.peek()
            self.numbers_to(self.code)
            if vector <= 11 or 84 <= vector <= 93:  # load, store
                self.numbers_to(self.code)
                self.numbers_to(self.offsets)
            if vector in (12, 13):
                self.bytes_to(self.other, 16)
            if 21 <= vector <= 34 or 84 <= vector <= 91:  # one lane
                self.bytes_to(self.code, 1)
        elif op not in (0x00, 0x01, 0x05, 0x0F, 0x19, 0x1A, 0x1B) and not 0x45 <= op <= 0xC4:
            raise SystemExit(f"pack.py and join.js do not know the instruction {op:#x} {self.peek()}")


def main():
    code, script = map(pathlib.Path, sys.argv[1:3])
    wasm = code.read_bytes()
    streams = Module(wasm).take_apart()
    packed = base64.b64encode(lzma.compress(b"".join(streams), format=lzma.FORMAT_RAW, filters=[FILTER])).decode()
    script.parent.mkdir(parents=True, exist_ok=True)
    sizes = ", ".join(str(size) for size in [len(wasm), *map(len, streams)])
    script.write_text(f'rigid_code("{code.stem}", [{sizes}], "{packed}");\n')


if __name__ == "__main__":
    main()
