#!/usr/bin/env python3
"""Gives chapters other numbers, everywhere at once: folders, files, links, sections, equations, figures, labels.

    renumber.py 15=16 16=17           chapters move; 16 moves before 15 takes its place
    renumber.py --labels moved.txt    sections, equations, figures move from one chapter to another

A line of moved.txt names a kind, the old number and the new one: `section 14.4 15.1`, `equation 14.8 15.2`, `figure 14.3 15.1`;
algorithm, table and exercise likewise. Text that moves to another chapter is moved first, with its old numbers: links follow a
section into the file that has it. Then docs/build.sh sync and docs/build.sh check, which says what dangles, stands twice or is out
of order. What is not seen: numbers that stand alone, as in a list of chapters of a script, or are words.
"""
import os
import pathlib
import re
import subprocess
import sys

import redirects
from booktext import ROOT, TextError, run_tool, slug

NO_TEXT = {".svg", ".png", ".gif", ".webp", ".mlcp", ".csv", ".bib"}
CHAPTER = r"\d{1,2}"
LABEL = rf"{CHAPTER}\.(?:\d+[a-z]?|[A-Z])"
JOINED = r"(?:,? and |,? or | to |, |–| · )"  # what stands between two numbers of a list


def tracked(root):
    names = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True, check=True).stdout
    return [root / name for name in names.split("\0") if name]


class Renumbering:
    """What each number becomes, and where it may stand."""

    def __init__(self, root, files, chapters, labels):
        self.root, self.chapters, self.labels = root, chapters, labels
        some = "|".join(str(n) for n in sorted({*chapters, *(int(old.split(".")[0]) for _, old in labels)}, reverse=True))
        padded = "|".join(f"{int(n):02}" for n in some.split("|"))
        # what folders and files are called behind their numbers; the longest first
        named = {m[0] for path in files for part in path.relative_to(root).parts
                 for m in [re.match(r"\d\d_[a-z_]+", part)] if m and int(part[:2]) in chapters}
        names = "|".join(sorted(named, key=lambda name: (-len(name), name))) or "(?!)"
        kinds = r"[Ss]ections?|[Ff]igures?|[Tt]ables?|[Aa]lgorithms?|[Ee]xercises?|[Ee]quations?"
        label = rf"(?:{some})\.(?:\d+[a-z]?|[A-Z])"
        self.pattern = re.compile("|".join([
            rf"(?P<file>(?<![\dA-Za-z])(?:{names})(?![a-z0-9]))",
            rf"(?P<listing>(?<=tests/)(?:mine|mutants)/(?:{padded})\.txt)",
            rf"(?P<equation>(?<![\w>])\((?:{some})\.\d+[a-z]?\))",
            rf"(?P<tag>\\tag\{{(?:{some})\.\d+[a-z]?\}})",
            rf"(?P<listed>\b(?:{kinds})[ \u00a0]{LABEL}(?:{JOINED}{LABEL})*)",
            rf"(?P<heading>^#+ (?:{label})(?= ))",
            rf"(?P<letter>(?<![\w.])(?:{some})\.[A-Z](?!\w))",
            rf"(?P<linked>\[(?:{label})\](?=\())",
            rf"(?P<card>\[(?:{some})(?=\. [A-Z][^\]]*\]\())",
            rf"(?P<anchor>#(?:{some})(?:\d{{1,2}}|[a-z])-[\w-]+)",
            rf"(?P<chapter>\b[Cc]hapters?[ \u00a0]{CHAPTER}\b(?!\.\d)(?:{JOINED}{CHAPTER}\b(?!\.\d))*)",
            rf"(?P<short>\bch(?:{padded})(?=[_\" :)]))",
            rf"(?P<command>(?:\./)?book (?:run|test|small|mine|bench|mutants) (?:{some})\b)",
            rf"(?P<small>\bsmall(?:[ \u00a0]program[ \u00a0])?(?:{some})\b)",
            rf"(?P<part>\brigid_(?:chapter|plain|optimised)(?:_up_to)?_(?:{padded})\b)",
        ]), re.M)
        # of the anchor of each section: its number, and where it is now: links follow it
        self.section, self.place = {}, {}
        for path in files:
            if path.suffix == ".md" and path.parent.parent == root / "chapters":
                for number, title in re.findall(rf"^##+ ({LABEL}) (.*)$", path.read_text(encoding="utf-8"), re.M):
                    anchor = slug(f"{number} {title}")
                    self.section[anchor], self.place[anchor] = number, path

    def chapter(self, old):
        return self.chapters.get(int(old), int(old))

    def label(self, kind, old):
        if (kind, old) in self.labels:
            return self.labels[kind, old]
        part = re.match(r"(\d+\.\d+)([a-z])$", old)  # (17.10b) goes with (17.10)
        if part and (kind, part[1]) in self.labels:
            return self.labels[kind, part[1]] + part[2]
        of, rest = old.split(".", 1)
        return f"{self.chapter(of)}.{rest}"

    def replace(self, found):
        kind, text = found.lastgroup, found[0]
        if kind == "file":
            return f"{self.chapter(text[:2]):02}{text[2:]}"
        if kind == "listing":
            return re.sub(r"\d+", lambda m: f"{self.chapter(m[0]):02}", text)
        if kind == "equation":
            return f"({self.label('equation', text[1:-1])})"
        if kind == "tag":
            return f"\\tag{{{self.label('equation', text[5:-1])}}}"
        if kind == "listed":
            what = re.match(r"[a-z]+?(?=s?\b)", text.lower())[0]
            return re.sub(LABEL, lambda m: self.label(what, m[0]), text)
        if kind == "heading":
            hashes, old = text.split(" ")
            return f"{hashes} {self.label('section', old)}"
        if kind == "letter":
            return self.label("section", text)
        if kind == "linked":
            return f"[{self.label('section', text[1:-1])}]"
        if kind == "card":
            return f"[{self.chapter(text[1:])}"
        if kind == "anchor":
            old = self.section.get(text[1:])
            return text if old is None else f"#{slug(self.label('section', old))}{text[1 + len(slug(old)):]}"
        if kind == "chapter":
            return re.sub(rf"\b{CHAPTER}\b", lambda m: str(self.chapter(m[0])), text)
        if kind == "short":
            return f"ch{self.chapter(text[2:]):02}"
        return re.sub(r"\d+$", lambda m: f"{self.chapter(m[0]):0{len(m[0])}}", text)  # command, small, part

    def text(self, old, path):
        def followed(link):
            place = self.place.get(link[2])
            if place is None or (path.parent / link[1]).resolve() == place or (not link[1] and path == place):
                return link[0]
            return f"]({pathlib.PurePosixPath(os.path.relpath(place, path.parent))}#{link[2]})"
        if path.suffix == ".md":
            old = re.sub(r"\]\(([^()\s#]*)#([^()\s]+)\)", followed, old)
        return self.pattern.sub(self.replace, old)

    def table(self, old):
        """The column `chapter` of a CSV; what stands before it holds no comma."""
        lines = old.split("\n")
        if "chapter" not in lines[0].split(","):
            return old
        at = lines[0].split(",").index("chapter")
        for i, line in enumerate(lines[1:], 1):
            cells = line.split(",", at + 1)
            if len(cells) > at and cells[at].isdigit():
                cells[at] = str(self.chapter(cells[at]))
                lines[i] = ",".join(cells)
        return "\n".join(lines)

    def path(self, path):
        """chapters/15_name, tests/15_name.cpp, figures/ch15_name.svg, tests/mine/15.txt."""
        def part(name):
            name = re.sub(r"^(\d\d)(?=_|\.txt$)", lambda m: f"{self.chapter(m[1]):02}", name)
            return re.sub(r"^ch(\d\d)_", lambda m: f"ch{self.chapter(m[1]):02}_", name)
        return self.root.joinpath(*(part(name) for name in path.relative_to(self.root).parts))


def renumber(root, chapters, labels):
    """Returns how many files have another place."""
    if len({chapters.get(n, n) for n in range(1, 100)}) != 99:
        raise TextError("two chapters would have the same number; each that is in the way moves as well")
    files = [path for path in tracked(root) if path.is_file() and not path.is_symlink()]
    it = Renumbering(root, files, chapters, labels)
    for path in files:
        if path.suffix in NO_TEXT - {".csv"} or path == root / redirects.LIST:
            continue
        try:
            old = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        new = it.table(old) if path.suffix == ".csv" else it.text(old, path)
        if new != old:
            path.write_text(new, encoding="utf-8")
    moves = [(path, it.path(path)) for path in files if it.path(path) != path]
    for old, _ in moves:  # first aside: 15 must not meet what was 16
        old.rename(old.with_name(old.name + ".moving"))
    for old, new in moves:
        new.parent.mkdir(parents=True, exist_ok=True)
        old.with_name(old.name + ".moving").rename(new)
        folder = old.parent
        while folder != root and not any(folder.iterdir()):
            folder.rmdir()
            folder = folder.parent
    names = {old.relative_to(root).parts[1]: new.relative_to(root).parts[1] for old, new in moves
             if old.parent.parent == root / "chapters"}
    if names and (root / redirects.LIST).is_file():  # the site's old addresses lead on
        text = (root / redirects.LIST).read_text(encoding="utf-8")
        (root / redirects.LIST).write_text(redirects.followed(text, names), encoding="utf-8")
    return len(moves)


def main():
    arguments, chapters, labels = sys.argv[1:], {}, {}
    if arguments[:1] == ["--labels"] and len(arguments) == 2:
        for line in pathlib.Path(arguments[1]).read_text(encoding="utf-8").splitlines():
            words = line.split()
            if not words or line.startswith("#"):
                continue
            if len(words) != 3 or not re.fullmatch(LABEL, words[1]) or not re.fullmatch(LABEL, words[2]):
                raise TextError(f"{arguments[1]} has the line '{line}'; it must be a kind and two numbers, as 'section 14.4 15.1'")
            labels[words[0], words[1]] = words[2]
    else:
        for argument in arguments:
            if not re.fullmatch(r"\d{1,2}=\d{1,2}", argument):
                raise TextError(f"'{argument}' is no pair of chapters such as 15=16")
            old, new = argument.split("=")
            chapters[int(old)] = int(new)
    if not chapters and not labels:
        raise TextError("nothing is to move; " + " ".join(__doc__.split("\n")[2].split()[:3]) + " is an example")
    print(f"{renumber(ROOT, chapters, labels)} files have another place; now docs/build.sh sync, docs/build.sh check")
    return 0


if __name__ == "__main__":
    run_tool(main)
