#!/usr/bin/env python3
"""A hand-out: the small program of a chapter with the bodies of some functions left open.

    holes.py N             prints the hand-out of chapter N (./book small N --holes)
    holes.py N FUNCTION …  leaves these functions open in place of those of tests/small/holes.txt
    holes.py N --fill FILE prints FILE with the book's bodies in its holes

The heads of the functions and the comments above them stay; in a hole stand the numbers of the equations that the body had, and a
`return` that makes the program compile. Exit code 2: a chapter without a small program, or a function that it doesn't have.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "tools"))

from booktext import EQUATION, TextError, chapters, function_code, run_tool  # noqa: E402

BEGIN, END = "    // ---- yours", "    // ---- as far as here"


def program_of(root, number):
    folder = chapters(root).get(number)
    path = folder / "small.cpp" if folder else None
    if not path or not path.is_file():
        raise TextError(f"chapter {number} has no small program")
    return path


def listed(root, number):
    """The functions that tests/small/holes.txt leaves open in this chapter's program."""
    for line in (root / "tests" / "small" / "holes.txt").read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words and words[0] == f"{number:02d}":
            return words[1:]
    raise TextError(f"tests/small/holes.txt has no line for chapter {number}")


def bodies(path, functions):
    """[(number of the line behind "{", of the line "}", the lines between)], from the last to the first."""
    found = []
    for name in functions:
        first, last, lines = function_code(path, name)
        if "{" not in lines:
            raise TextError(f"{path.name} has '{name}' in one line; a hole needs a body")
        head = lines.index("{")
        found.append((first + head, last - 1, lines[head + 1:-1], lines[:head]))
    return sorted(found, reverse=True)


def hole(number, body, head):
    """What stands in place of a body."""
    cited = list(dict.fromkeys(m.group(0) for line in body for m in EQUATION.finditer(line)))
    signature = next(line for line in head if not line.startswith("//"))
    words = f"{BEGIN} {number}" + (f": {', '.join(cited)}" if cited else "")
    return [words, *([] if signature.startswith("void ") else ["    return {};"]), END]


def hand_out(path, functions):
    """The program with holes, numbered from the top."""
    lines = path.read_text(encoding="utf-8").split("\n")
    places = bodies(path, functions)
    for k, (first, last, body, head) in enumerate(places):
        lines[first:last] = hole(len(places) - k, body, head)
    return "\n".join(lines)


def filled(path, functions, text):
    """A hand-out with the book's bodies in its holes."""
    lines = text.split("\n")
    own = [body for _, _, body, _ in sorted(bodies(path, functions))]
    for number, body in reversed(list(enumerate(own, 1))):
        first = [k for k, line in enumerate(lines) if re.match(rf"{re.escape(BEGIN)} {number}(:|$)", line)]
        last = [k for k, line in enumerate(lines) if line == END and first and k > first[0]]
        if len(first) != 1 or not last:
            raise TextError(f"the hole {number} has no beginning '{BEGIN.strip()} {number}' or no end '{END.strip()}'")
        lines[first[0]:last[0] + 1] = body
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("chapter", type=int, help="its number")
    parser.add_argument("functions", nargs="*", help="what is left open")
    parser.add_argument("--fill", type=pathlib.Path, help="a hand-out")
    options = parser.parse_args()
    path = program_of(ROOT, options.chapter)
    functions = options.functions or listed(ROOT, options.chapter)
    if options.fill:
        sys.stdout.write(filled(path, functions, options.fill.read_text(encoding="utf-8")))
    else:
        sys.stdout.write(hand_out(path, functions))
    return 0


if __name__ == "__main__":
    run_tool(main)
