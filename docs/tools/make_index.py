#!/usr/bin/env python3
"""Makes docs/index_of_terms.md from the chapters.

    docs/tools/make_index.py            write it
    docs/tools/make_index.py --check    change nothing, exit 1 if it is not what would be written

A term is what a paragraph of a chapter has in bold type behind its first word, at most four words without maths and without a
full stop. docs/index/terms.txt says which of them are none, which begin with a capital letter, which terms are explained without bold
type, and where words of other books are. A term is found where it is in bold type, and in each section whose title has it,
if these are few.
"""
import argparse
import pathlib
import re
import sys

from booktext import ROOT, TextError, blocks, book_folder, chapter_of, chapter_texts, chapters, run_tool, slug

BOLD = re.compile(r"\*\*(.+?)\*\*", re.S)
MOST = 10  # a word in more titles than these leads nowhere: "row"
HEAD = """# Index of terms

[Contents](../README.md) · [Back: I want …](i_want_to.md) · [Next: Notation](notation.md)

Where each term is explained, and the sections that are about it. Letters are in the [notation](notation.md). `docs/tools/make_index.py`
makes this page from the chapters; other names of a thing are in `docs/index/terms.txt`.
"""
TAIL = HEAD.split("\n")[2]


class Section:
    def __init__(self, number, title, link):
        self.number, self.title, self.link = number, title, link

    def order(self):
        chapter, _, rest = self.number.partition(".")
        return int(chapter), not rest.isdigit(), int(rest) if rest.isdigit() else 0, rest


def sections(root):
    """[(text's name such as 04_pgs or 04_pgs/in_depth, its sections with the paragraphs of each)]."""
    found = []
    for folder in chapters(root).values():
        for path in chapter_texts(folder):
            name = folder.name if path.name == "README.md" else f"{folder.name}/in_depth"
            seen, inside = {}, []
            for block in blocks(path.read_text(encoding="utf-8"), str(path.relative_to(root))):
                if block.kind == "heading":
                    anchor = slug(block.info["title"], seen)
                    split = re.match(r"(\d+\.\w+) (.*)", block.info["title"])
                    if block.info["level"] == 1:
                        here = Section(str(chapter_of(root, path)), block.info["title"], f"../{path.relative_to(root).as_posix()}")
                        inside.append((here, []))
                    elif split:
                        here = Section(split.group(1), split.group(2), f"../{path.relative_to(root).as_posix()}#{anchor}")
                        inside.append((here, []))
                elif block.kind == "paragraph" and inside:
                    inside[-1][1].append(block.text)
            found.append((name, inside))
    return found


def listed(root):
    """What docs/index/terms.txt says: names, words that are no terms, {term: (text, title)}, {other word: term}."""
    names, none, terms, other = {}, set(), {}, {}
    path = root / "docs" / "index" / "terms.txt"
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines() if path.is_file() else (), 1):
        if not line.strip() or line.startswith("#"):
            continue
        kind, _, rest = line.partition(" ")
        parts = [part.strip() for part in rest.split("|")]
        if kind == "name" and len(parts) == 1:
            names[parts[0].lower()] = parts[0]
        elif kind == "not" and len(parts) == 1:
            none.add(parts[0].lower())
        elif kind == "term" and len(parts) == 3:
            terms[parts[0]] = (parts[1], parts[2])
        elif kind == "see" and len(parts) == 2:
            other[parts[0]] = parts[1]
        else:
            raise TextError(f"docs/index/terms.txt:{number}: this line is none of 'name TERM', 'not WORDS', 'term TERM | TEXT | TITLE' and 'see WORD | TERM'")
    return names, none, terms, other


def bold_terms(paragraph, names, none):
    for m in BOLD.finditer(paragraph):
        words = " ".join(m.group(1).split())
        plain = m.start() > 0 and not re.search(r"[$`.:?!,]|\[", words) and len(words.split()) <= 4
        if plain and words.lower() not in none and (words[0].islower() or words.lower() in names):
            yield names.get(words.lower(), words)


def page(root):
    texts = sections(root)
    names, none, terms, other = listed(root)
    places = {}
    for _, inside in texts:
        for section, paragraphs in inside:
            for paragraph in paragraphs:
                for term in bold_terms(paragraph, names, none):
                    places.setdefault(term, []).append(section)
    for term, (text, title) in terms.items():
        found = [section for name, inside in texts if name == text for section, _ in inside if section.title == title]
        if len(found) != 1:
            raise TextError(f"docs/index/terms.txt: the term '{term}' is said to be in '{title}' of {text}, which has {len(found)} such sections")
        places.setdefault(term, []).append(found[0])
    for term, found in places.items():  # and where the title has it, as it is or with an s
        title = re.compile(rf"(?<![\w-]){re.escape(term)}s?\b", re.I)
        about = [section for _, inside in texts for section, _ in inside[1:] if title.search(section.title)]
        found += about if len(about) <= MOST else []
    for word, term in other.items():
        if term not in places:
            raise TextError(f"docs/index/terms.txt: '{word}' points to '{term}', which is no term")

    def entry(term):
        unique = {section.link: section for section in places[term]}
        return " · ".join(f"[{section.number}]({section.link})" for section in sorted(unique.values(), key=Section.order))

    lines = {term: f"- {term}: {entry(term)}" for term in places}
    lines |= {word: f"- {word}: see *{term}*, {entry(term)}" for word, term in other.items()}
    out, letter = [HEAD], ""
    for word in sorted(lines, key=lambda w: (w.lower(), w)):
        if word[0].upper() != letter:
            letter = word[0].upper()
            out.append(f"{'' if len(out) == 1 else chr(10)}## {letter}\n")
        out.append(lines[word])
    return "\n".join(out + ["", TAIL, ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--check", action="store_true", help="change nothing, fail if the page is stale")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the book's folder")
    options = parser.parse_args()
    root = book_folder(options.root)
    path, text = root / "docs" / "index_of_terms.md", page(root)
    if path.is_file() and path.read_text(encoding="utf-8") == text:
        return 0
    if options.check:
        print("docs/index_of_terms.md is not what the chapters give; run docs/build.sh sync.", file=sys.stderr)
        return 1
    path.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    run_tool(main)
