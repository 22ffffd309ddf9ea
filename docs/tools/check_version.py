#!/usr/bin/env python3
"""Is the version the same everywhere?

    docs/tools/check_version.py

The version of CMakeLists.txt is that of CITATION.cff, both vcpkg.json, the newest heading of CHANGELOG.md, and
what docs/use_it asks find_package() for. Each fault is one line.
"""
import argparse
import pathlib
import re
import sys

from booktext import ROOT, TextError, run_tool

# file: (what stands before the version, how many of its numbers stand there)
PLACES = {
    "CITATION.cff": (r"^version: ", 3),
    "vcpkg.json": (r'"version-string": "', 3),
    "cmake/vcpkg/rigid/vcpkg.json": (r'"version": "', 3),
    "CHANGELOG.md": (r"^## ", 3),
    "docs/use_it.md": (r"find_package\(rigid ", 2),
    "docs/use_it/CMakeLists.txt": (r"find_package\(rigid ", 2),
}


def faults(root):
    source = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"^project\(\w+ VERSION (\d+\.\d+\.\d+)\b", source, re.M)
    if not found:
        raise TextError("CMakeLists.txt has no line 'project(NAME VERSION 1.2.3 …'")
    version = found.group(1)
    for name, (before, numbers) in PLACES.items():
        wanted = ".".join(version.split(".")[:numbers])
        here = re.search(before + r"(\d+(?:\.\d+)*)", (root / name).read_text(encoding="utf-8"), re.M)
        if not here or here.group(1) != wanted:
            yield f"{name} has the version {here.group(1) if here else '(none)'}; CMakeLists.txt has {version}."


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the book's folder")
    said = list(faults(parser.parse_args().root))
    for sentence in said:
        print(sentence, file=sys.stderr)
    return 1 if said else 0


if __name__ == "__main__":
    run_tool(main)
