#!/usr/bin/env python3
"""Does each command of `book` install the programs that it and its tests call?

    programs.py            says which don't; exit code 1 if there are any
    programs.py --list     also says which programs each command calls, and from where
    programs.py --test     the tests of this tool

Followed are the branch of the command in `book`, the functions that it calls, and every script (sh, Python, CMake, gnuplot,
node) that these name, however deep. A program that is only called where it was found (find_program, command -v,
shutil.which) may be missing, but Python may not: tests that need it would be left out without a word.
A program belongs to a list if its package, as dpkg knows it here, is in the list, in what that depends on, or essential.
So this needs a Debian on which the programs are installed; .ci/run bare_root tries the lists themselves in a bare one.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]

# What a command of `book` goes through without naming it: CMake reads the lists of the book, and ctest runs its tests.
LISTS = ["CMakeLists.txt", "cmake/*.cmake", "docs/results/CMakeLists.txt", "tests/stress/CMakeLists.txt", "tests/properties/CMakeLists.txt",
         "chapters/*/*.cmake"]
THROUGH = {"ctest": [*LISTS, "tests/*.cmake"]}
OTHER_PRESETS = {"cmake/web.cmake": "web", "cmake/mingw.cmake": "mingw", "cmake/rigidConfig.cmake": "install"}
# What CMake calls by itself: the generator of the presets, and the compilers; for the pages what cmake/web.cmake finds, too.
BY_CMAKE = {"release": {"ninja", "g++"}, "web": {"ninja", "em++", "python3"}}
# Programs that are on few machines, and their packages.
RARE = {"ffmpeg": "ffmpeg", "em++": "emscripten", "chromium": "chromium", "doxygen": "doxygen"}

KEYWORDS = {"if", "then", "else", "elif", "fi", "while", "until", "do", "done", "!", "{", "}", "time"}
BUILTINS = set(": . [ alias break cd command continue eval exec exit export false getopts hash local printf echo pwd read readonly return set "
               "shift test times trap true type ulimit umask unset wait source shopt declare".split())


def without_comments(text):
    return re.sub(r"(^|\s)#[^\n]*", r"\1", text, flags=re.M)


def expand_quotes(text):
    """Strings as one word Q; what $( ) inside of double quotes calls, and the scripts of sh -c, on lines of their own."""
    out, extra, at = [], [], 0
    while at < len(text):
        c = text[at]
        if c == "\\":
            out.append("_")
            at += 2
        elif c == "'":
            end = text.index("'", at + 1)
            if re.search(r"\b(sh|bash) -c\s*$", "".join(out)):
                extra.append(text[at + 1:end])
            out.append("Q")
            at = end + 1
        elif c == '"':
            at += 1
            while text[at] != '"':
                if text[at] == "\\":
                    at += 2
                elif text.startswith("$(", at):
                    end = closing(text, at + 2)
                    extra.append(text[at + 2:end])
                    at = end + 1
                else:
                    at += 1
            out.append("Q")
            at += 1
        else:
            out.append(c)
            at += 1
    return "".join(out), extra


def closing(text, at):
    """Where the parenthesis is closed that was opened before `at`."""
    depth = 1
    while depth:
        if text[at] == "\\":
            at += 1
        elif text[at] == "'":
            at = text.index("'", at + 1)
        elif text[at] == '"':
            at += 1
            while text[at] != '"':
                if text.startswith("$(", at):
                    at = closing(text, at + 2)
                at += 1 if text[at] != "\\" else 2
        elif text[at] == "(":
            depth += 1
        elif text[at] == ")":
            depth -= 1
        at += 1
    return at - 1


def shell_words(text):
    """The first words of the commands of a shell script: programs, functions and builtins."""
    text = re.sub(r"<<'?(\w+)'?.*?\n\1\n", "\n", without_comments(text), flags=re.S)
    text = re.sub(r"\$\(\(.*?\)\)+", "1", text.replace("\\\n", " "))
    text, extra = expand_quotes(text)
    for script in extra:
        yield from shell_words(script + "\n")
    text = re.sub(r"\d*[<>]&\d*-?|\d*>>?\s*[^\s;|&()]+|<\s*[^\s;|&()]+", " ", text)
    text = re.sub(r"\$\{[^}]*\}", "$X", text)
    text = re.sub(r"(\bcase\s+\S+\s+in\b|;;)\s*(?!esac)\(?[^()\n;]*\)", "\n", text)  # its patterns
    text = re.sub(r"\besac\b|;;|\bfor\b[^\n;]*", "\n", text)
    for part in re.split(r"[;|&()\n`]+", text.replace("$(", "\n")):
        words = part.split()
        while words:
            word = words.pop(0)
            if word in KEYWORDS or re.match(r"\w+=", word) or word.startswith("$as_root"):
                continue
            if word == "exec":
                continue
            if word == "command" and words[:1] == ["-v"]:
                yield "?" + words[1]
            elif word == "need" and words:  # of docs/build.sh
                yield words[0]
            elif word in ("env", "nice", "timeout", "xargs"):
                yield word
                while words and (words[0].startswith("-") or "=" in words[0] or words[0].isdigit()):
                    option = words.pop(0)
                    if word == "xargs" and option in ("-I", "-n", "-P", "-L") and words:
                        words.pop(0)
                continue
            elif re.fullmatch(r"[a-z][\w.+-]*", word):
                yield word
            break


def functions_of(shell):
    """{name: body} of the functions of a shell script."""
    return {match[2]: match[3] or match[4]
            for match in re.finditer(r"^( *)(\w+)\(\) \{(?: (.*?)\}$|[^\n]*\n(.*?)^\1\}$)", without_comments(shell), re.M | re.S)}


def branches(book):
    """{command: text} of the last `case` of the script `book`."""
    tail = book[book.index('case "$command" in'):]
    return {match[1]: match[2] for match in re.finditer(r"^([a-z]+)\)\n(.*?)^    ;;$", tail, re.M | re.S)}


def packages(book, text, functions):
    """The packages that a branch, or a function that it calls, installs."""
    lists = dict(re.findall(r'^(packages_\w+)="([^"]*)"', book, re.M))

    def filled(words):
        while "$" in words:
            words, before = re.sub(r"\$\{\w+:\+([^}]*)\}", r"\1", words), words
            words = re.sub(r"\$(packages_\w+)", lambda m: lists[m[1]], words)
            if words == before:
                break
        return set(words.split())

    found = set()
    for match in re.finditer(r'\bensure (?:"([^"]*)"|([\w-]+))', without_comments(text)):
        found |= filled(match[1] or match[2])
    for name in set(shell_words(text)) & set(functions) - {"ensure", "setup_npm", "name_packages"}:
        found |= packages(book, functions[name], {k: v for k, v in functions.items() if k != name})
    return found


class Calls:
    """What a command calls: {program: the files that call it}."""

    def __init__(self, root):
        self.root, self.found, self.seen = root, {}, set()

    def add(self, program, where):
        self.found.setdefault(program, set()).add(where)

    def file(self, path):
        path = path.resolve()
        if path in self.seen or not path.is_file():
            return
        self.seen.add(path)
        text = path.read_text(encoding="utf-8")
        name = path.relative_to(self.root).as_posix()
        if path.suffix == ".sh" or text.startswith("#!/bin/sh") or text.startswith("#!/usr/bin/env bash"):
            self.shell(text, name)
        elif path.suffix == ".py":
            self.python(text, name)
        elif path.suffix in (".cmake", ".txt"):
            self.cmake(text, name)
        self.follow(text if path.suffix == ".py" else without_comments(text), path.parent, path.suffix)

    def follow(self, text, folder, suffix):
        """The scripts that a text names: from the root of the book, or beside it."""
        for mention in re.findall(r"[\w$/{}.-]+\.(?:py|sh|mjs|gp|cmake)\b", text):
            mention = re.sub(r"\$\{?(PROJECT_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR|CMAKE_CURRENT_SOURCE_DIR|folder|here|tool)\}?/", "", mention)
            if suffix == ".py" and "/" in mention:
                continue  # words for the reader; a script calls those beside it
            mention = re.sub(r"\$\{?\w+\}?|\bNAME\b", "*", mention)
            for base in {self.root, folder}:
                for path in base.glob(mention.lstrip("/")) if mention.strip("*/") else []:
                    if OTHER_PRESETS.get(path.relative_to(self.root).as_posix()) in (None, self.preset):
                        self.file(path)

    preset = "release"

    def shell(self, text, name):
        own = set(functions_of(text))
        words = set(shell_words(text))
        maybe = {w[1:] for w in words if w[0] == "?"}
        sourced = set()
        for other in re.findall(r"^\s*\. .*?([\w./]+\.sh)", text, re.M):
            for path in self.root.glob("**/" + pathlib.Path(other).name):
                sourced |= set(functions_of(path.read_text(encoding="utf-8")))
                self.file(path)
        for word in words - own - sourced - BUILTINS:
            if word[0] != "?" and word not in maybe:
                self.add(word, name)

    def python(self, text, name):
        maybe = set(re.findall(r"which\(['\"]([\w+-]+)['\"]", text))
        calls = re.findall(r"\[\s*['\"]([a-z][\w+-]*)['\"]\s*,\s*['\"]-", text)  # ["cmake", "-S", …
        calls += re.findall(r"(?:run|Popen|check_output|check_call|call)\(\s*\[\s*['\"]([\w+.-]+)['\"]", text)
        for program in set(calls) - maybe:
            self.add(program, name)

    def cmake(self, text, name):
        text = without_comments(text)
        maybe = {word for names in re.findall(r"find_program\(\s*\w+\s+(?:NAMES\s+)?([^)]*)\)", text) for word in names.split()}
        if re.search(r"find_package\(Python3", text):
            self.add("python3", name)
        for program in re.findall(r"\bCOMMAND\s+([a-z][\w+-]*)\b", text):
            if program not in maybe and not program.startswith("add_") and program not in ("solver_attack", "world_attack", "results"):
                self.add(program, name)


def calls_of(root, book, command, text):
    functions = functions_of(book)
    calls = Calls(root)
    calls.preset = "web" if command in ("web", "race") else "release"
    done, left = set(), [text]
    while left:
        part = left.pop()
        words = set(shell_words(part))
        maybe = {w[1:] for w in words if w[0] == "?"}
        for word in words - BUILTINS:
            if word[0] == "?":
                continue
            if word in functions:
                if word not in done and word not in ("ensure", "setup_npm", "name_packages"):
                    done.add(word)
                    left.append(functions[word])
            elif word not in maybe or command in ("film", "web", "race", "mine"):  # these install it where it is missing
                calls.add(word, "book")
            for pattern in THROUGH.get(word, []):
                for path in sorted(root.glob(pattern)):
                    if OTHER_PRESETS.get(path.relative_to(root).as_posix()) in (None, calls.preset):
                        calls.file(path)
            if word == "configure":
                for program in BY_CMAKE[calls.preset]:
                    calls.add(program, "CMakePresets.json")
        calls.follow(without_comments(part), root, "")
        for mention in re.findall(r"chapters/(?:\$name|NAME)/figures/draw\.sh|(?<![\w/])tests/mutants/run\.py|docs/build\.sh", part):
            for path in root.glob(mention.replace("$name", "*").replace("NAME", "*")):
                calls.file(path)
    return calls.found


class Debian:
    """What apt and dpkg know on this machine."""

    def __init__(self):
        self.needs, self.provides, self.essential, self.known = {}, {}, set(), {}
        name = None
        for line in subprocess.run(["apt-cache", "dumpavail"], capture_output=True, text=True, check=True).stdout.splitlines():
            field, _, value = line.partition(": ")
            if field == "Package":
                name = value
                self.needs.setdefault(name, [])
            elif field in ("Depends", "Pre-Depends"):
                self.needs[name] += [[re.sub(r"[\s(:].*", "", way.strip()) for way in group.split("|")] for group in value.split(",")]
            elif field == "Provides":
                for other in value.split(","):
                    self.provides.setdefault(re.sub(r"[\s(:].*", "", other.strip()), []).append(name)
            elif (field, value) in (("Essential", "yes"), ("Priority", "required")) or (field, name) == ("Priority", "apt"):
                self.essential.add(name)

    def closure(self, wanted):
        found, left = set(), list(wanted) + list(self.essential)
        while left:
            name = left.pop()
            if name in found:
                continue
            found.add(name)
            for group in self.needs.get(name, []):
                # apt takes the first that there is
                here = [way for way in group if way in self.needs] or [p for way in group for p in self.provides.get(way, [])]
                left += here[:1]
        return found

    def owners(self, program):
        """The packages of a program and of what its links lead to; empty if it isn't here."""
        if program not in self.known:
            self.known[program] = self.asked(program)
        return self.known[program]

    @staticmethod
    def asked(program):
        path = shutil.which(program, path="/usr/bin:/bin:/usr/sbin:/sbin")
        if not path:
            return {RARE[program]} if program in RARE else set()
        paths, here = {path}, pathlib.Path(path)
        while here.is_symlink():
            here = here.parent / here.readlink()
            paths.add(str(here))
        paths |= {str(pathlib.Path(path).resolve())}
        paths |= {p.replace("/usr/", "/", 1) for p in paths if p.startswith("/usr/")} | {"/usr" + p for p in paths if not p.startswith("/usr/")}
        said = subprocess.run(["dpkg-query", "-S", *paths], capture_output=True, text=True, check=False).stdout
        return {name.split(":")[0].strip() for line in said.splitlines() if not line.startswith("diversion")
                for name in line.split(": ")[0].split(",")}


def faults(root, debian, listing=False):
    book = (root / "book").read_text(encoding="utf-8")
    functions = functions_of(book)
    for command, text in branches(book).items():
        if command in ("setup", "doctor", "help"):
            continue
        installed = debian.closure(packages(book, text, functions))
        for program, callers in sorted(calls_of(root, book, command, text).items()):
            where = sorted(callers)
            owners = debian.owners(program)
            if listing:
                print(f"{command}: {program} ({', '.join(sorted(owners)) or 'not here'}) from {', '.join(where[:3])}{' …' if len(where) > 3 else ''}")
            if not owners:
                yield f"./book {command}: {program}, called by {where[0]}, is of no package that is installed here"
            elif not owners & installed:
                yield f"./book {command} installs no package with {program}, which {where[0]} calls; on this machine {' or '.join(sorted(owners))} has it"


def test():
    def words(text):
        return {w for w in shell_words(text) if w not in BUILTINS}

    assert words("a && b | c; if d; then e; else f; fi\n") == set("abcdef")
    assert words("case $x in\none | two) g ;;\n*) h ;;\nesac\n") == {"g", "h"}
    assert words('x=$(i "$(j k)") Y=1 l >m 2>&1 # n\n') == {"i", "j", "l"}
    assert words("o | xargs -P 2 -I N sh -c 'p \"$1\"'\ncat <<'END'\nq\nEND\nexec r\n") == {"o", "xargs", "sh", "p", "cat", "r"}
    assert words("command -v s >/dev/null || t\n") == {"?s", "t"}
    assert words("u \\\n  v 'w' \"x; y\"\n") == {"u"}

    class Known:
        def closure(self, wanted):
            return set(wanted) | {"base"}

        def owners(self, program):
            return {"awk": {"base"}, "cmake": {"cmake"}, "ctest": {"cmake"}, "sh": {"base"}, "ninja": {"ninja-build"}, "g++": {"g++"},
                    "python3": {"python3"}, "git": {"git"}, "gnuplot": {"gnuplot-nox"}}.get(program, set())

    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder).resolve()
        (root / "tests").mkdir()
        (root / "tests" / "a.cmake").write_text("find_program(X xvfb-run)\nadd_test(NAME b COMMAND sh ${PROJECT_SOURCE_DIR}/tests/b.sh)\n")
        (root / "tests" / "b.sh").write_text("#!/bin/sh\nawk 1\n")
        book = ('packages_run="cmake ninja-build g++"\npackages_test="$packages_run catch2"\nensure() { :; }\nconfigure() {\n    cmake --preset x\n}\n'
                'case "$command" in\ntest)\n    ensure "$packages_test"\n    configure release\n    exec ctest\n    ;;\nesac\n')
        (root / "book").write_text(book)
        assert list(faults(root, Known())) == [], list(faults(root, Known()))
        (root / "tests" / "b.sh").write_text("#!/bin/sh\npython3 -c 1\n")
        said = list(faults(root, Known()))
        assert len(said) == 1 and "installs no package with python3, which tests/b.sh calls" in said[0], said
        (root / "book").write_text(book.replace("catch2", "catch2 python3"))
        assert list(faults(root, Known())) == []
        (root / "tests" / "c.cmake").write_text("find_package(Python3 QUIET)\nadd_test(NAME d COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/c.py)\n")
        (root / "tests" / "c.py").write_text('import subprocess\nsubprocess.run(["git", "status"])\nsubprocess.run(["unheard-of"])\n')
        said = list(faults(root, Known()))
        assert len(said) == 2 and "git" in said[0] and "unheard-of" in said[1], said
    print("programs.py: its tests pass")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--test", action="store_true")
    options = parser.parse_args()
    if options.test:
        test()
        return 0
    if not shutil.which("dpkg-query") or not shutil.which("apt-cache"):
        print("programs.py: this is no Debian; which package a program is of is not known here")
        return 1
    said = list(faults(ROOT, Debian(), options.list))
    for sentence in said:
        print(sentence)
    if not said:
        print("each command of book installs the programs that it and its tests call")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
