#!/usr/bin/env python3
"""Packs the code of a program for a page: wasm → LZMA → base64 → a script that hands it to machine.js.

    docs/web/pack.py PROGRAM.wasm PROGRAM.js

A script can be loaded from a page that was opened as a file; a .wasm can't. The same code gives the same script.
"""
import base64
import lzma
import pathlib
import sys

FILTER = {"id": lzma.FILTER_LZMA1, "dict_size": 1 << 23, "lc": 3, "lp": 0, "pb": 0, "mode": lzma.MODE_NORMAL,
          "mf": lzma.MF_BT4, "nice_len": 273, "depth": 1000}


def main():
    code, script = map(pathlib.Path, sys.argv[1:3])
    raw = code.read_bytes()
    packed = base64.b64encode(lzma.compress(raw, format=lzma.FORMAT_RAW, filters=[FILTER])).decode()
    script.parent.mkdir(parents=True, exist_ok=True)
    script.write_text(f'rigid_code("{code.stem}", {len(raw)}, "{packed}");\n')


if __name__ == "__main__":
    main()
