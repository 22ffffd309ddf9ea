#!/usr/bin/env python3
"""Packs the code of a program for a page: wasm → gzip → base64 → a script that hands it to machine.js.

    docs/web/pack.py PROGRAM.wasm PROGRAM.js

A script can be loaded from a page that was opened as a file; a .wasm can't. The same code gives the same script.
"""
import base64
import gzip
import pathlib
import sys


def main():
    code, script = map(pathlib.Path, sys.argv[1:3])
    packed = base64.b64encode(gzip.compress(code.read_bytes(), 9, mtime=0)).decode()
    script.parent.mkdir(parents=True, exist_ok=True)
    script.write_text(f'rigid_code("{code.stem}", "{packed}");\n')


if __name__ == "__main__":
    main()
