#!/usr/bin/env python3
"""The table of the small programs in docs/readers_guide.md, and how many lines the texts say that each has.

    programs.py              says what is wrong, and ends with 1 if anything is
    programs.py --write      counts again; a chapter without a line gets one, whose words are still to be written
    programs.py --seconds    the same, and how long each takes to compile here: alone, one after the other, the
                             shorter of two times; ${CXX:-g++} and the Eigen of ${EIGEN:-/usr/include/eigen3}
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDE = "docs/readers_guide.md"
PROGRAMS = "| chapter | grew from | lines | new in the method | new in `main()` | gone | compiles in [s] | prints |"
REASONS = "| chapter | why its method has more than 50 new lines |"
MOST_NEW = 50
UNSAID = "…"


def programs(root):
    """{number: (the number that it grew from or None, its lines, the place of `main()` in them, its file)}"""
    found = {}
    for file in sorted((root / "chapters").glob("[0-9][0-9]_*/small.cpp")):
        lines = file.read_text(encoding="utf-8").splitlines()
        parent = re.search(r"grown from chapter (\d+)", lines[0])
        main = next(i for i, line in enumerate(lines) if line.startswith("int main("))
        found[int(file.parent.name[:2])] = (int(parent[1]) if parent else None, lines, main, file)
    return found


def in_common(a, b):
    """How many lines the longest common subsequence of two lists has."""
    row = [0] * (len(b) + 1)
    for x in a:
        before = 0
        for j, y in enumerate(b):
            before, row[j + 1] = row[j + 1], before + 1 if x == y else max(row[j + 1], row[j])
    return row[-1]


def counted(all_programs, number):
    """What can be counted of a program, in the order of the table: parent, lines, new in the method and in main(), gone."""
    parent, lines, main, _ = all_programs[number]
    if parent is None:
        return ["", str(len(lines)), "", "", ""]
    _, old, old_main, _ = all_programs[parent]
    method, rest = in_common(old[:old_main], lines[:main]), in_common(old[old_main:], lines[main:])
    return [str(n) for n in (parent, len(lines), main - method, len(lines) - main - rest, len(old) - method - rest)]


def rows(text, heading):
    """The lines of the table with a heading: {number of the chapter: its other cells}, and where they stand."""
    if heading not in text:
        raise SystemExit(f"{GUIDE} has no table '{heading}'")
    begin = text.index("\n", text.index("\n", text.index(heading)) + 1) + 1
    end = re.compile(r"^(?!\|)", re.MULTILINE).search(text, begin).start()
    found = {}
    for line in text[begin:end].splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        found[int(cells[0])] = cells[1:]
    return found, begin, end


def tables(text, all_programs, seconds):
    """The text with both tables as they should be, and what of their words is not said."""
    missing = []
    for heading, wanted in ((PROGRAMS, list(all_programs)),
                            (REASONS, [n for n in all_programs if int(counted(all_programs, n)[2] or 0) > MOST_NEW])):
        old, begin, end = rows(text, heading)
        new = []
        for number in wanted:
            cells = old.get(number, ["", "", "", "", "", "–", UNSAID] if heading == PROGRAMS else [UNSAID])
            if heading == PROGRAMS:
                cells = [*counted(all_programs, number), seconds.get(number, cells[5]), cells[6]]
            if cells[-1] in ("", UNSAID):
                missing.append(f"{GUIDE} does not say of chapter {number} "
                               + ("what its small program prints" if heading == PROGRAMS else "why its method is that new"))
            new.append("| " + " | ".join([str(number), *cells]).replace("|  |", "| |") + " |\n")
        text = text[:begin] + "".join(new).replace("|  |", "| |") + text[end:]
    return text, missing


def captions(root, all_programs):
    """The texts of the chapters that say another number of lines: (file, its text as it should be)."""
    for number, (_, lines, _, file) in all_programs.items():
        page = file.with_name("README.md")
        if not page.is_file():
            continue
        text = page.read_text(encoding="utf-8")
        right = re.sub(rf"in \d+ lines(?= \(`\./book small {number}\b|; `\./book small {number}\b)", f"in {len(lines)} lines", text)
        if right != text:
            yield page, right


def compiled(all_programs):
    """{number: seconds}, with one figure behind the point"""
    command = [*os.environ.get("CXX", "g++").split(), "-std=c++20", "-O2", "-I" + os.environ.get("EIGEN", "/usr/include/eigen3")]
    took = {}
    with tempfile.TemporaryDirectory() as folder:
        for number, (*_, file) in all_programs.items():
            best = float("inf")
            for _ in range(2):
                begin = time.monotonic()
                subprocess.run([*command, str(file), "-o", "small"], cwd=folder, check=True)
                best = min(best, time.monotonic() - begin)
            took[number] = f"{best:.1f}"
            print(f"chapter {number}: {best:.1f} s", file=sys.stderr)
    return took


def main(arguments):
    if len(arguments) > 1 or any(word not in ("--write", "--seconds") for word in arguments):
        print(__doc__, file=sys.stderr)
        return 2
    all_programs = programs(ROOT)
    guide = ROOT / GUIDE
    text = guide.read_text(encoding="utf-8")
    right, wrong = tables(text, all_programs, compiled(all_programs) if arguments == ["--seconds"] else {})
    changes = [(guide, right)] if right != text else []
    changes += captions(ROOT, all_programs)
    for file, content in changes:
        if arguments:
            file.write_text(content, encoding="utf-8")
        else:
            wrong.append(f"{file.relative_to(ROOT)} has other numbers of lines than the small programs: "
                         "tests/small/programs.py --write counts again")
    for sentence in wrong:
        print(sentence)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
