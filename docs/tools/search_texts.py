#!/usr/bin/env python3
"""Write what the site's search box looks into: search_texts.js, the sections of the texts and the names in the code.

    docs/tools/search_texts.py HTML_FOLDER TAG_FILE

The texts are taken from the finished pages (chapters, in depth, primer, notation, …), a section at a time, without
code, figures' inside and formulas; the names from Doxygen's tag file: types and functions of the namespace rigid.
"""
import argparse
import json
import pathlib
import re
import xml.etree.ElementTree as xml
from html.parser import HTMLParser

from booktext import TextError, run_tool

# Pages of Doxygen's own about files, types and folders: their names are found, not their tables.
REFERENCE = re.compile(r"^(class|struct|union|namespace|dir_|files|annotated|classes|functions|globals|hierarchy|citelist|"
                       r"namespacemembers|pages|examples|modules|concept|usergroup|graph_legend|.*_(8hpp|8cpp)|.*_source|"
                       r".*members)")
FORMULA = re.compile(r"\\\((.*?)\\\)|\\\[(.*?)\\\]", re.S)
LETTERS = {"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "Delta": "Δ", "varepsilon": "ε", "epsilon": "ε", "zeta": "ζ",
           "eta": "η", "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ",
           "sigma": "σ", "tau": "τ", "varphi": "φ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "Omega": "Ω",
           "le": "≤", "leq": "≤", "ge": "≥", "geq": "≥", "ne": "≠", "cdot": "·", "times": "×", "to": "→", "infty": "∞",
           "pm": "±", "approx": "≈", "perp": "⊥", "in": "∈", "sum": "Σ", "top": "ᵀ", "sqrt": "√"}
TABLES = {"results.html", "stability.html", "stability_in_depth.html"}  # mostly numbers: their sentences are found, not their tables
UNSEEN = {"script", "style", "svg", "nav", "button", "select"}
UNSEEN_CLASSES = {"fragment", "origin", "demo", "toc", "header", "footer", "ttc"}
EMPTY = {"br", "img", "hr", "input", "meta", "link", "source", "col", "wbr"}


def in_letters(formula):
    """A short formula as a line of text: its letters; a long one is left out."""
    tex = next(part for part in formula.groups() if part is not None)
    plain = re.sub(r"\\([a-zA-Z]+)", lambda m: LETTERS.get(m[1], ""), tex)
    plain = re.sub(r"[{}_^\\&$~]|\s+", "", plain)
    return plain if 0 < len(plain) <= 12 else "…"


class Page(HTMLParser):
    """Title and sections of one page: sections is a list of [anchor, title, words]."""

    def __init__(self, with_tables=True):
        super().__init__(convert_charrefs=True)
        self.unwanted = UNSEEN if with_tables else UNSEEN | {"table"}
        self.title, self.sections = "", []
        self.open, self.unseen, self.inside, self.heading, self.in_title, self.anchor = [], 0, 0, 0, 0, ""

    def handle_starttag(self, tag, attributes):
        if tag in EMPTY:
            return
        given = dict(attributes)
        classes = set((given.get("class") or "").split())
        hidden = tag in self.unwanted or bool(classes & UNSEEN_CLASSES)
        self.open.append((tag, hidden))
        depth = len(self.open)
        if hidden:
            self.unseen += 1
        if "contents" in classes and not self.inside:
            self.inside = depth
            self.sections.append(["", "", []])
        if "title" in classes and not self.title:
            self.in_title = depth
        if self.inside and not self.unseen and tag in ("h1", "h2"):
            self.heading = depth
            self.sections.append(["", "", []])
        if self.heading and tag == "a" and given.get("id"):
            self.sections[-1][0] = given["id"]

    def handle_endtag(self, tag):
        if tag in EMPTY or all(name != tag for name, _ in self.open):
            return
        while self.open:
            depth = len(self.open)
            name, hidden = self.open.pop()
            self.unseen -= hidden
            self.inside = 0 if depth == self.inside else self.inside
            self.heading = 0 if depth == self.heading else self.heading
            self.in_title = 0 if depth == self.in_title else self.in_title
            if name == tag:
                break

    def handle_data(self, words):
        if self.in_title:
            self.title += words
        if self.unseen or not self.inside:
            return
        if self.heading:
            self.sections[-1][1] += words
        else:
            self.sections[-1][2].append(words)


def entries_of_page(name, content):
    """[{address, title, page, text}] of one page of the site."""
    page = Page(with_tables=name not in TABLES)
    page.feed(content)
    title = " ".join(page.title.split())
    found = []
    for anchor, heading, words in page.sections:
        text = " ".join(FORMULA.sub(in_letters, "".join(words)).split())
        heading = " ".join(FORMULA.sub(in_letters, heading).split())
        if text or heading:
            found.append({"address": name + ("#" + anchor if anchor else ""), "title": heading or title,
                          "page": title if heading else "", "text": text})
    return found


def entries_of_names(tag_file):
    """[{address, title, page, text: ""}]: types and functions, each once, with what it is a part of."""
    found, seen = [], set()

    def add(name, address, owner):
        if (name, owner) not in seen:
            seen.add((name, owner))
            found.append({"address": address, "title": name, "page": owner, "text": ""})

    for compound in xml.parse(tag_file).getroot().iter("compound"):
        name = compound.findtext("name", "")
        if compound.get("kind") not in ("struct", "class", "namespace") or not name.startswith("rigid"):
            continue
        if compound.get("kind") != "namespace":
            add(name.split("::", 1)[-1], compound.findtext("filename", ""), "type")
        for member in compound.iter("member"):
            if member.get("kind") in ("function", "enumeration", "typedef"):
                short = member.findtext("name", "")
                if short != name.rsplit("::", 1)[-1] and not short.startswith(("~", "operator")):
                    add(short, f"{member.findtext('anchorfile')}#{member.findtext('anchor')}", name)
    return found


def write_texts(folder, tag_file):
    found = []
    for path in sorted(folder.glob("*.html")):
        if not REFERENCE.match(path.stem):
            found += entries_of_page(path.name, path.read_text(encoding="utf-8"))
    if not found:
        raise TextError(f"{folder} has no page with text")
    found += entries_of_names(tag_file)
    words = json.dumps(found, ensure_ascii=False, separators=(",", ":"))
    (folder / "search_texts.js").write_text(f"window.book_search_texts={words};\n", encoding="utf-8")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("html_folder", type=pathlib.Path, help="the finished site")
    parser.add_argument("tag_file", type=pathlib.Path, help="Doxygen's list of names")
    options = parser.parse_args()
    found = write_texts(options.html_folder, options.tag_file)
    sections = sum(1 for entry in found if entry["text"])
    print(f"search: {sections} sections, {len(found) - sections} names")


if __name__ == "__main__":
    run_tool(main)
