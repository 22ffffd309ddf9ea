#!/usr/bin/env python3
"""Do the tests notice faults? Puts small faults, mutants, into a copy of the book and runs its tests with each.

    ./book mutants            all chapters
    ./book mutants 4          those of tests/mutants/04.txt
    ./book mutants --check    only say whether each mutant has its place in the sources

A list names mutants like this; lines that begin with # are comments:

    mutant the step may grow after a rejection
    in     chapters/01_euler_integration/adaptive.hpp
    was    first_try ? 5. : 1.
    now    5.

`was` is an expression, part of one line or of several without the breaks, and occurs once in the file; where it occurs more often, a line `at` gives more of the
line around it, which occurs once. The expression becomes a choice at run time, so a chapter is compiled once for
all of its mutants. Further lines, where they are needed:

    as     statement     `was` is a whole statement (`now` may be empty: it is left out)
    equal  REASON        no test can notice: the two mean the same, and why

A mutant is killed when a test fails, crashes or exceeds its time. Exit code 0: each mutant is killed or equal;
1: one survives, or one that is said to be equal is killed; 2: a list or the build is wrong.
"""
import argparse
import dataclasses
import filecmp
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time
import xml.sax.saxutils

ROOT = pathlib.Path(__file__).resolve().parents[2]
LISTS = ROOT / "tests" / "mutants"
FOLDER = ROOT / "build" / "mutants"
FIELDS = ("in", "was", "now", "at", "as", "equal")
OUTPUT_LIMIT = 4_000_000  # bytes
MEMORY_LIMIT = 4 << 30  # bytes


class ListError(Exception):
    """A list that cannot be used, in one sentence."""


@dataclasses.dataclass
class Mutant:
    number: int  # what RIGID_MUTANT is set to
    name: str
    place: str  # file and line of the list
    fields: dict

    def __getattr__(self, field):
        if field in FIELDS or field == "file":
            return self.fields.get("in" if field == "file" else field)
        raise AttributeError(field)


def fault_of_code(code, is_statement):
    """Why this cannot be compiled where an expression, or a statement, is chosen; none if it may be."""
    if any(code.count(opening) != code.count(closing) for opening, closing in ("()", "[]", "{}")):
        return "has brackets that do not close"
    if is_statement:
        return "" if not code or code[-1] in ";}" else "is no statement"
    if code.endswith(("|", "&", "+", "-", "*", "/", "<", ">", "=", "?", ":", ",")) and not code.endswith(("++", "--")):
        return "ends in an operator"
    return "is a statement: as statement, or at and its expression" if ";" in code or code.startswith("else ") else ""


def read_list(path, first_number=1):
    """The mutants of one list."""
    mutants = []
    for count, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        key, _, value = line.strip().partition(" ")
        value = value.strip()
        place = f"{path.name}:{count}"
        if key == "mutant":
            mutants.append(Mutant(first_number + len(mutants), value, place, {}))
        elif key not in FIELDS:
            raise ListError(f"{place}: '{key}' is none of mutant, {', '.join(FIELDS)}")
        elif not mutants:
            raise ListError(f"{place}: '{key}' stands before the first mutant")
        elif key in mutants[-1].fields:
            raise ListError(f"{place}: '{mutants[-1].name}' has two lines '{key}'")
        else:
            mutants[-1].fields[key] = value
    names = set()
    for mutant in mutants:
        for key in ("in", "was", "now"):
            if key not in mutant.fields:
                raise ListError(f"{mutant.place}: '{mutant.name}' has no line '{key}'")
        if mutant.fields.get("as", "statement") != "statement":
            raise ListError(f"{mutant.place}: as can only be 'statement', not '{mutant.fields['as']}'")
        for key in ("was", "now"):
            why = fault_of_code(mutant.fields[key], mutant.fields.get("as") == "statement")
            if why:
                raise ListError(f"{mutant.place}: '{mutant.name}': '{mutant.fields[key]}' {why}")
        if mutant.name in names:
            raise ListError(f"{mutant.place}: there are two mutants '{mutant.name}'")
        names.add(mutant.name)
    return mutants


def anywhere(code):
    """A pattern that finds a line of code however it is broken into lines."""
    words = re.split(r"\s+|(?<=\()", code)
    return re.compile(r"\s*".join(re.escape(word) for word in words))


def span(mutant, text):
    """Where in the text of its file the mutant is."""
    at = mutant.at or mutant.was
    what = f"{mutant.place}: '{mutant.name}': {mutant.file} has"
    places = list(anywhere(at).finditer(text))
    if len(places) != 1:
        raise ListError(f"{what} '{at}' {len(places)} times; it must be there once")
    [place] = places
    inside = list(anywhere(mutant.was).finditer(place.group(0)))
    if len(inside) != 1:
        raise ListError(f"{mutant.place}: '{mutant.name}': '{at}' has '{mutant.was}' {len(inside)} times; "
                        "it must be there once")
    return place.start() + inside[0].start(), place.start() + inside[0].end()


def mutated(text, mutants):
    """The text of a file in which each of these mutants is a choice."""
    places = {}
    for mutant in mutants:
        places.setdefault(span(mutant, text), []).append(mutant)
    last_begin = len(text)
    for (begin, end), here in sorted(places.items(), reverse=True):
        if end > last_begin:
            raise ListError(f"{here[0].place}: '{here[0].name}' overlaps another mutant; give both the same 'was'")
        last_begin = begin
        original = text[begin:end]
        if any(mutant.fields.get("as") for mutant in here):
            if not all(mutant.fields.get("as") for mutant in here):
                raise ListError(f"{here[0].place}: '{here[0].name}' is a statement for one mutant only")
            choice = "".join(f"if (::rigid_mutant({m.number})) {{ {m.now} }} else " for m in here) + f"{{ {original} }}"
        else:
            choice = "(" + "".join(f"::rigid_mutant({m.number}) ? ({m.now}) : " for m in here) + f"({original}))"
        line = text.rfind("\n", 0, begin) + 1  # what is chosen at run time is no compile-time constant
        text = text[:line] + text[line:begin].replace("constexpr", "const") + choice + text[end:]
        last_begin = line if "constexpr" in text[line:begin] else last_begin
    return text


def mutated_files(mutants):
    """The texts of the files in which mutants are."""
    sources = {}
    for mutant in mutants:
        sources.setdefault(mutant.file, []).append(mutant)
    for name in sources:
        if not (ROOT / name).is_file():
            raise ListError(f"{sources[name][0].place}: there is no file {name}")
    return {name: mutated((ROOT / name).read_text(encoding="utf-8"), here) for name, here in sources.items()}


def copy_book(texts, tree):
    """Makes `tree` the book with these files changed. Files that stay the same keep their date."""
    wanted = set()
    for folder, folders, files in os.walk(ROOT):
        at = pathlib.Path(folder).relative_to(ROOT)
        folders[:] = [f for f in folders if not f.startswith(".") and f != "__pycache__" and (at / f).as_posix() != "build"]
        for file in files:
            name = (at / file).as_posix()
            wanted.add(name)
            target = tree / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if name in texts:
                if not target.is_file() or target.read_text(encoding="utf-8") != texts[name]:
                    target.write_text(texts[name], encoding="utf-8")
            elif not target.is_file() or not filecmp.cmp(ROOT / name, target, shallow=False):
                shutil.copyfile(ROOT / name, target)
    for path in [p for p in tree.rglob("*") if p.is_file()]:
        if path.relative_to(tree).as_posix() not in wanted:
            path.unlink()


def build(tree, binaries, targets):
    """Compiles the test executables in the copy."""
    flags = f"-include {LISTS / 'mutant.hpp'}"
    log = FOLDER / "build.log"
    with open(log, "w", encoding="utf-8") as out:
        for command in (["cmake", "-S", tree, "-B", binaries, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                         "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", f"-DCMAKE_CXX_FLAGS={flags}",
                         "-DRIGID_BENCHMARKS=OFF", "-DRIGID_WINDOW=OFF"],
                        ["cmake", "--build", binaries, "--target", *targets]):
            if subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, check=False).returncode:
                out.flush()
                lines = log.read_text(encoding="utf-8").splitlines()
                sys.stderr.write("\n".join([x for x in lines if "error" in x][:20] or lines[-20:]) + "\n")
                raise ListError(f"the copy with its mutants could not be built; see {log}")


def limits():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run_tests(program, number, seconds):
    """Runs the tests of one executable to the first that fails.
    Returns (how it ended, the test that it ended in): passed, failed, crashed, out of time."""
    command = [program, "--abort", "--reporter", "xml"]  # the one reporter that never breaks lines
    end = time.monotonic() + seconds
    out = bytearray()
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL,
                          env=os.environ | {"RIGID_MUTANT": str(number)}, preexec_fn=limits) as process:
        os.set_blocking(process.stdout.fileno(), False)
        how = None
        while how is None:
            part = process.stdout.read()
            if part:
                out += part
            elif process.poll() is not None:
                how = "passed" if process.returncode == 0 else "failed" if process.returncode > 0 else "crashed"
            elif time.monotonic() > end:
                how = "out of time"
            else:
                time.sleep(0.01)
            if len(out) > OUTPUT_LIMIT:
                how = "too much output"
        if process.poll() is None:
            process.kill()
    names = re.findall(rb'<TestCase name="([^"]*)"', bytes(out))
    name = xml.sax.saxutils.unescape(names[-1].decode("utf-8", "replace"), {"&quot;": '"'}) if names else "?"
    return how, name


def chapter_of(path):
    """The test executables that a list is for: 04.txt → test_04_pgs."""
    if path.stem == "common":
        return "test_common"
    found = sorted((ROOT / "chapters").glob(f"{path.stem}_*"))
    if not found:
        raise ListError(f"{path.name} is for no chapter: there is no chapters/{path.stem}_…")
    return "test_" + found[0].name


def judge(program, mutants, seconds, say):
    """Runs all mutants of one executable. Returns how many are not as they should be."""
    wrong = 0
    for mutant in mutants:
        how, test = run_tests(program, mutant.number, seconds)
        if how == "passed":
            verdict = f"equal: {mutant.equal}" if mutant.equal else "SURVIVED"
            wrong += not mutant.equal
        else:
            verdict = ("" if how == "failed" else how + " in ") + test
            if mutant.equal:
                verdict = f"KILLED, though it is said to be equal: {verdict}"
                wrong += 1
        say(f"  {mutant.name:<72} {verdict}")
    return wrong


def main(arguments):
    parser = argparse.ArgumentParser(prog="book mutants", description="puts faults into a copy of the book; do its tests notice?")
    parser.add_argument("chapters", nargs="*", help="numbers of chapters, or common; none = all")
    parser.add_argument("--check", action="store_true", help="only say whether each mutant has its place in the sources")
    parser.add_argument("--only", default="", help="only the mutants whose name has this in it")
    options = parser.parse_args(arguments)
    lists = sorted(LISTS.glob("*.txt"))
    if options.chapters:
        wanted = {c.zfill(2) if c.isdigit() else c for c in options.chapters}
        missing = wanted - {path.stem for path in lists}
        if missing:
            raise ListError(f"there is no list tests/mutants/{sorted(missing)[0]}.txt")
        lists = [path for path in lists if path.stem in wanted]
    mutants = {}
    for path in lists:
        here = read_list(path, 1 + sum(map(len, mutants.values())))
        mutants[path] = here
    chosen = {path: [m for m in here if options.only in m.name] for path, here in mutants.items()}
    chosen = {path: here for path, here in chosen.items() if here}
    if not chosen:
        raise ListError(f"no mutant has '{options.only}' in its name")
    if options.check:
        fewest = min(len(here) for here in mutants.values())
        mutated_files([m for here in mutants.values() for m in here])
        print(f"{sum(map(len, mutants.values()))} mutants in {len(mutants)} lists, at least {fewest} in each, have their places")
        return 0
    tree, binaries = FOLDER / "tree", FOLDER / "build"
    tree.mkdir(parents=True, exist_ok=True)
    copy_book(mutated_files([m for here in mutants.values() for m in here]), tree)
    targets = {path: chapter_of(path) for path in chosen}
    print(f"building {', '.join(targets.values())} with {sum(map(len, mutants.values()))} mutants", flush=True)
    build(tree, binaries, list(targets.values()))

    def say(line):
        print(line, flush=True)

    wrong = 0
    for path, here in chosen.items():
        program = binaries / "bin" / targets[path]
        began = time.monotonic()
        how, test = run_tests(program, 0, 600)
        took = time.monotonic() - began
        if how != "passed":
            raise ListError(f"without a mutant {targets[path]} {how} in '{test}'")
        say(f"{targets[path]} (all tests pass without a mutant, {took:.1f} s)")
        wrong += judge(program, here, max(20, 10 * took), say)
    total = sum(map(len, chosen.values()))
    print(f"{total} mutants, {total - wrong} as they should be, {wrong} not")
    return 1 if wrong else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except ListError as error:
        sys.exit((print(f"book mutants: {error}", file=sys.stderr), 2)[1])
    except KeyboardInterrupt:
        sys.exit(130)
