#!/usr/bin/env python3
"""The reader's own solver: the headers of a chapter with the bodies of their functions emptied.

    mine.py N            put those of chapter N into mine/, where they come before the book's own (./book mine N)
    mine.py              say what has been begun, and how many of the [idea] tests passed last (./book mine)
    mine.py --check      only say whether each function of each list is in its header
    mine.py N --own      put the book's own headers of chapter N into mine/
    mine.py N --wrong    put them there with the fault that the list names: the [idea] tests must notice it (.ci/run mine)

tests/mine/NN.txt names them; lines that begin with # are comments:

    in     chapters/01_euler_integration/integrators.hpp
    empty  explicit_euler    return s;

    first  pgs               throw std::logic_error("not written yet");
    drop   Enumerator        what only the book's own way needs: this class is left out
    wrong  the step is late  the mutant of tests/mutants/NN.txt that --wrong takes; it is in one of these headers

The body of each definition of the function becomes the statement (after `first` that of the first definition alone; the
others only call it): the header compiles, and its tests fail.
A file that is in mine/ already is kept. Exit code 2: a chapter without a list, or a list that is wrong.
"""
import argparse
import importlib.util
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


class ListError(Exception):
    """What is wrong with a list, in one sentence."""


def read_list(path):
    """{header: [(function, statement, whether only its first definition)]} of a list."""
    found, header = {}, None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        words = line.split(None, 2)
        if not words or words[0] == "wrong" or words[0].startswith("#"):
            continue
        if words[0] == "in" and len(words) == 2:
            header = found.setdefault(words[1], [])
        elif words[0] in ("empty", "first") and len(words) == 3 and header is not None:
            header.append((words[1], words[2], words[0] == "first"))
        elif words[0] == "drop" and len(words) == 2 and header is not None:
            header.append((words[1], None, False))
        else:
            raise ListError(f"{path.name}:{number}: this line is none of 'in HEADER', 'empty FUNCTION STATEMENT', 'first FUNCTION STATEMENT' and 'drop CLASS'")
    return found


def blanked(source):
    """The source with comments and strings as blanks, so that braces can be counted."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), source)


def bodies(source, function):
    """[(begin, end)] of the bodies, braces included, of the definitions of a function."""
    plain, found = blanked(source), []
    for match in re.finditer(rf"(?<![\w.:>]){re.escape(function)}\s*\(", plain):
        before = plain[:match.start()].rstrip()
        if not re.search(r"[\w>&*]$", before) or re.search(r"\b(return|else|throw)$", before):
            continue  # a call
        at, depth = match.end(), 1
        while at < len(plain) and depth:
            depth += {"(": 1, ")": -1}.get(plain[at], 0)
            at += 1
        rest = re.match(r"\s*(const|noexcept|\s)*\{", plain[at:])
        if not rest:
            continue  # a declaration
        begin = at + rest.end() - 1
        at, depth = begin + 1, 1
        while at < len(plain) and depth:
            depth += {"{": 1, "}": -1}.get(plain[at], 0)
            at += 1
        found.append((begin, at))
    return found


def without_class(source, name, where):
    plain = blanked(source)
    found = re.search(rf"^(class|struct) {re.escape(name)}\b[^;{{]*\{{", plain, re.M)
    if not found:
        raise ListError(f"{where} has no class {name}")
    at, depth = found.end(), 1
    while at < len(plain) and depth:
        depth += {"{": 1, "}": -1}.get(plain[at], 0)
        at += 1
    before = re.sub(r"(?:^(?:///|template)[^\n]*\n)*\Z", "", source[:found.start()], flags=re.M)
    return before + source[at:].lstrip(";\n")


def emptied(source, functions, where):
    for function, statement, only_first in functions:
        if statement is None:
            source = without_class(source, function, where)
            continue
        places = bodies(source, function)
        if not places:
            raise ListError(f"{where} has no definition of {function}()")
        for begin, end in reversed(places[:1] if only_first else places):
            margin = re.search(r"[^\n]*\Z", source[:begin]).group(0)
            margin = re.match(r"\s*", margin).group(0)
            source = (source[:begin] + "{\n" + margin + "    // Yours: the text and the comment above say what it does.\n" +
                      margin + "    " + statement + "\n" + margin + "}" + source[end:])
    # What an emptied function doesn't use is not worth a warning.
    throws = any(statement and "std::logic_error" in statement for _, statement, _ in functions)
    begin = "#pragma once\n#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n" + ("#include <stdexcept>\n" if throws else "")
    return source.replace("#pragma once\n", begin, 1)


def list_of(root, number):
    path = root / "tests" / "mine" / f"{number:02d}.txt"
    if not path.is_file():
        known = [str(int(p.stem)) for p in sorted(path.parent.glob("[0-9][0-9].txt"))]
        raise ListError(f"chapter {number} has no header to write yourself; these have: {' '.join(known)}")
    return path


def faults(root):
    """The module of the mutants: their lists, and where in a file each of them is."""
    spec = importlib.util.spec_from_file_location("mutants_run", root / "tests" / "mutants" / "run.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


def wrong_header(root, path):
    """(header, its text with the fault that the list names)."""
    names = re.findall(r"^wrong +(.+?) *$", path.read_text(encoding="utf-8"), re.M)
    if len(names) != 1:
        raise ListError(f"{path.name} names {len(names)} faults for --wrong; it must be one")
    module = faults(root)
    mutants = [m for m in module.read_list(root / "tests" / "mutants" / path.name) if m.name == names[0]]
    if not mutants or mutants[0].file not in read_list(path):
        raise ListError(f"{path.name}: tests/mutants/{path.name} has no mutant '{names[0]}' in one of these headers")
    text = (root / mutants[0].file).read_text(encoding="utf-8")
    try:
        first, last = module.span(mutants[0], text)
    except module.ListError as fault:
        raise ListError(str(fault)) from fault
    now = mutants[0].now if mutants[0].fields.get("as") else f"({mutants[0].now})"
    return mutants[0].file, text[:first] + now + text[last:]


def own(root, number, wrong):
    """The book's own headers, with one fault if `wrong`."""
    path = list_of(root, number)
    spoilt, text = wrong_header(root, path) if wrong else (None, None)
    for header in read_list(path):
        target = root / "mine" / header
        if target.exists():
            raise ListError(f"mine/{header} is there already")
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text if header == spoilt else (root / header).read_text(encoding="utf-8"), encoding="utf-8")
        print(f"mine/{header}: the book's own" + (", with a fault" if header == spoilt else ""))


def begin(root, number):
    path = list_of(root, number)
    for header, functions in read_list(path).items():
        text = emptied((root / header).read_text(encoding="utf-8"), functions, header)
        target = root / "mine" / header
        if target.exists():
            print(f"mine/{header} is there already and is kept")
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
        print(f"mine/{header}: write {', '.join(name + '()' for name, statement, _ in functions if statement)}")
    print(f"then: ./book test {number} --mine")


def state(root):
    """One line for each header in mine/."""
    said = []
    for path in sorted((root / "tests" / "mine").glob("[0-9][0-9].txt")):
        for header, functions in read_list(path).items():
            mine = root / "mine" / header
            if not mine.is_file():
                continue
            empty = emptied((root / header).read_text(encoding="utf-8"), functions, header)
            functions = [entry for entry in functions if entry[1]]
            left = [name for name, _, _ in functions if unwritten(mine.read_text(encoding="utf-8"), empty, name)]
            result = root / "build" / "mine" / f"{path.stem}.result"
            tests = result.read_text(encoding="utf-8").strip() if result.is_file() else "no test was run yet"
            said.append(f"chapter {int(path.stem)}, {header}: {len(functions) - len(left)} of {len(functions)} functions "
                        f"begun; {tests}")
    return said or ["nothing is begun; ./book mine N puts the emptied headers of chapter N into mine/"]


def unwritten(mine, empty, function):
    """True if the bodies of a function are still those of the emptied header."""
    texts = [[re.sub(r"\s+", " ", text[a:b]) for a, b in bodies(text, function)] for text in (mine, empty)]
    return texts[0] == texts[1]


def main(arguments=None, root=ROOT):
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("chapter", nargs="?", type=int)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--own", action="store_true")
    parser.add_argument("--wrong", action="store_true")
    options = parser.parse_args(arguments)
    try:
        if options.check:
            for path in sorted((root / "tests" / "mine").glob("[0-9][0-9].txt")):
                for header, functions in read_list(path).items():
                    if not (root / header).is_file():
                        raise ListError(f"{path.name}: there is no {header}")
                    emptied((root / header).read_text(encoding="utf-8"), functions, header)
                wrong_header(root, path)
        elif options.chapter is not None and (options.own or options.wrong):
            own(root, options.chapter, options.wrong)
        elif options.chapter is not None:
            begin(root, options.chapter)
        else:
            print("\n".join(state(root)))
    except ListError as fault:
        print(f"mine: {fault}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
