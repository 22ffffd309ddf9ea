#!/usr/bin/env python3
"""Check all texts of the book, without building them.

    docs/tools/check_text.py [--root FOLDER]

Every fault is one line, `file:line: what is wrong`; any fault makes the exit code 1.

What is checked
  links      relative links, pictures, anchors of headings; a picture has alt text
  citations  [[key]](…/references.bib), \\cite key: the key is in docs/references.bib
  equations  \\tag{4.7}: unique, of its own chapter; (4.7) in text, comments and test
             names: exists
  figures    "Figure 4.2" exists and is unique; each file in figures/ is shown by its chapter
  tests      `name` in `tests/file.cpp`: the file has a test of that name
  maths      what GitHub and MathJax would not render as meant
  width      code that is quoted or typed has at most 84 columns
  demos      <!-- demo: … --> is one that docs/tools/demos.py reads, and its program is there
  sentences  <!-- sentence: … --> is one that docs/tools/sentences.py reads, and its model is there
  notation   a name in the column `code` of docs/notation.md occurs in the sources of the chapters or of common/
             a table can be set in 1,000 pixels, by the estimate of `least_width()`
  length     the README.md of a chapter has at most 6,000 words (`words_of()` says what is counted)
  layout     one title; numbered sections in order (1.1, 1.2; in in_depth.md 1.A, 1.B); details with blank lines

When `(4.7)` is an equation number
  It is alone in its parentheses, `digits . digits [letter]` without spaces; it is not
  preceded by a letter, digit or closing bracket (a call, a link) nor followed by an
  arithmetic operator; neither part is zero or has more than two digits. In Markdown only
  in running text: not in maths, code or fences. In C++ only in comments and in the names
  of tests. In a figure (svg) in its texts. And only if there is a chapter of that number:
  `(7.3)` before chapter 7 is written is left alone. A plain number in
  parentheses therefore carries its unit, `(1.5 m)`, or is maths, `($1.5$)`.
"""
import argparse
import pathlib
import re
import sys
import urllib.parse

from booktext import (CPP, EQUATION, FIGURE, FIGURE_CAPTION, HEADING, ROOT, SPAN, TABLE_LINE, TextError, anchors, book_folder,
                      bib_keys, blocks, chapter_of, chapters, comments, equation_tags,
                      figure_captions, lone_picture, markdown_files, snippet_language, source_files, run_tool, test_names, tokens)
from demos import demo_of, own_program
from sentences import sentence_of

WIDEST_CODE = 84
MOST_WORDS = 6000
WIDEST_TABLE = 1000  # pixels, of the site's page beside its sidebar in a window of 1400
PICTURES = {".svg", ".png", ".gif", ".jpg", ".jpeg", ".webp"}


class Checker:
    def __init__(self, root):
        self.root = root
        self.faults = []
        self.chapters = chapters(root)
        self.texts = {}       # path -> content
        self.parts = {}       # path -> blocks
        self.anchors = {}     # path -> set of anchors
        self.equations = {}   # number -> "file:line"
        self.figures = {}
        self.shown = set()    # (chapter, picture)
        self.keys = set()
        self.tests = {}       # path -> names

    def fault(self, path, line, sentence):
        where = path.relative_to(self.root) if path.is_relative_to(self.root) else path
        self.faults.append((str(where), line, sentence))

    # -- reading

    def read(self):
        keys = bib_keys(self.root)
        for key in sorted({k for k in keys if keys.count(k) > 1}):
            self.fault(self.root / "docs/references.bib", 1, f"the key '{key}' occurs twice.")
        self.keys = set(keys)
        for path in markdown_files(self.root):
            text = path.read_text(encoding="utf-8")
            name = str(path.relative_to(self.root))
            try:
                self.parts[path] = blocks(text, name)
            except TextError as broken:
                where, line, sentence = re.match(r"(.*?):(\d+): (.*)", str(broken)).groups()
                self.faults.append((where, int(line), sentence))
                continue
            self.texts[path] = text
            self.anchors[path] = set(anchors(text, name))
            self.numbers(path, text)

    def numbers(self, path, text):
        """Which equations and figures a text defines."""
        own = chapter_of(self.root, path)
        for tag, line in equation_tags(text):
            m = re.fullmatch(r"([1-9]\d?)\.([1-9]\d?)[a-z]?", tag)
            if not m:
                self.fault(path, line, f"\\tag{{{tag}}} is no equation number such as 4.7 or 4.7a.")
            elif own is None:
                self.fault(path, line, f"equation ({tag}) is numbered, but this is not a chapter.")
            elif int(m.group(1)) != own:
                self.fault(path, line, f"equation ({tag}) has the number of another chapter.")
            elif tag in self.equations:
                self.fault(path, line, f"equation ({tag}) exists already, at {self.equations[tag]}.")
            else:
                self.equations[tag] = f"{path.relative_to(self.root)}:{line}"
        for number, line in figure_captions(text):
            if own is None or int(number.split(".")[0]) != own:
                self.fault(path, line, f"Figure {number} does not have the number of its chapter.")
            elif number in self.figures:
                self.fault(path, line, f"Figure {number} exists already, at {self.figures[number]}.")
            else:
                self.figures[number] = f"{path.relative_to(self.root)}:{line}"

    # -- citing numbers

    def cited_numbers(self, path, line, words, figures=False):
        for m in EQUATION.finditer(words):
            number = m.group(0)[1:-1]
            if int(m.group(1)) in self.chapters and number not in self.equations:
                at = line + words.count("\n", 0, m.start())
                self.fault(path, at, f"there is no equation ({number}) in chapter {m.group(1)}.")
        for m in FIGURE.finditer(words) if figures else ():
            number = f"{m.group(1)}.{m.group(2)}"
            if int(m.group(1)) in self.chapters and number not in self.figures:
                at = line + words.count("\n", 0, m.start())
                self.fault(path, at, f"there is no Figure {number} in chapter {m.group(1)}.")

    # -- links

    def link(self, path, line, target, picture=False):
        if re.match(r"^[a-z][a-z0-9+.-]*:", target, re.I):
            if picture:
                self.fault(path, line, f"the picture {target} would be fetched from elsewhere.")
            return None
        file, _, anchor = target.partition("#")
        file = urllib.parse.unquote(file)
        what = "picture" if picture else "link"
        if file.startswith("/"):
            self.fault(path, line, f"the {what} {target} is not relative.")
            return None
        found = (path.parent / file).resolve() if file else path
        if not found.is_relative_to(self.root):
            self.fault(path, line, f"the {what} {target} leads out of the book.")
            return None
        if not found.exists():
            self.fault(path, line, f"the {what} {target} leads to nothing.")
            return None
        if anchor and found.suffix == ".md" and anchor not in self.anchors.get(found, {anchor}):
            self.fault(path, line, f"{found.relative_to(self.root)} has no heading '#{anchor}'.")
        return found

    def picture(self, path, line, info):
        if not info["alt"].strip():
            self.fault(path, line, f"the picture {info['src']} has no alternative text.")
        found = self.link(path, line, info["src"], picture=True)
        if found and found.suffix.lower() not in PICTURES:
            self.fault(path, line, f"{info['src']} is not a picture.")
        elif found:
            self.shown.add((chapter_of(self.root, path), found))
        if "target" in info:
            self.link(path, line, info["target"])
        for room, what in (("dark", "(prefers-color-scheme: dark)"), ("still", "(prefers-reduced-motion: reduce)")):
            if room in info and not info[room]:
                self.fault(path, line, f'a <picture> has a <source media="{what}" srcset="…">.')
            elif room in info:
                self.picture(path, line, {"alt": info["alt"], "src": info[room]})

    # -- maths

    def maths(self, path, line, tex, display=False):
        """What MathJax would refuse."""
        bare = re.sub(r"\\[{}]", "", tex)
        depth = 0
        for c in bare:
            depth += (c == "{") - (c == "}")
            if depth < 0:
                break
        if depth:
            self.fault(path, line, f"unbalanced braces in the maths {shorten(tex)}.")
        if len(re.findall(r"\\left(?![a-z])", tex)) != len(re.findall(r"\\right(?![a-z])", tex)):
            self.fault(path, line, f"\\left without \\right, or the reverse, in {shorten(tex)}.")
        begins = re.findall(r"\\begin\{(\w+\*?)\}", tex)
        if sorted(begins) != sorted(re.findall(r"\\end\{(\w+\*?)\}", tex)):
            self.fault(path, line, f"\\begin and \\end do not match in {shorten(tex)}.")
        for name in begins:
            if re.fullmatch(r"(align|gather|equation|multline|eqnarray|alignat|flalign)\*?", name):
                self.fault(path, line, f"use 'aligned' or 'cases' within the maths, not '{name}'.")
        for bad in ("\\label", "\\eqref", "\\ref", "\\newcommand", "\\def", "\\operatorname"):
            if re.search(re.escape(bad) + r"(?![a-zA-Z])", tex):
                self.fault(path, line, f"{bad} does not work on GitHub" + ("; write \\mathrm." if "oper" in bad else "."))
        if display and len(re.findall(r"\\tag\b", tex)) > 1:
            self.fault(path, line, "one \\tag to a block of maths; cut the block in two.")
        if not display and "\\tag" in tex:
            self.fault(path, line, "\\tag is for display maths only.")

    def inline_maths(self, path, line, token, in_table):
        tex = token.info["tex"]
        self.maths(path, line, tex)
        if in_table and "|" in tex:
            self.fault(path, line, f"in a table write \\lvert or \\mid for | in {token.text}.")
        if token.info["raw"]:
            return
        for bad, why in ((r"\\[^A-Za-z\s]", "a backslash before punctuation"), (r"\*", "*"), (r"<[A-Za-z/!?]", "< without a space behind it")):
            found = re.search(bad, tex)
            if found:
                self.fault(path, line, f"GitHub misreads {why} in {token.text}: write it as a word "
                           "(\\lbrace, \\lVert, \\thinspace, \\ast, \\lt) or use $`…`$.")
                return
        if re.search(r"\]\(", tex):
            self.fault(path, line, f"GitHub reads ]( in {token.text} as a link: use $`…`$.")

    def underscores(self, path, block, found):
        """Markdown's rule for _: two in one paragraph may become emphasis and break maths."""
        text = "".join(t.text if t.kind != "code" and not t.info.get("raw") else " " * len(t.text)
                       for t in found)
        inside = [(t.offset, t.offset + len(t.text), t) for t in found
                  if t.kind == "math" and not t.info["raw"]]
        opener = None
        for m in re.finditer(r"_", text):
            at = m.start()
            before, after = text[at - 1:at] or " ", text[at + 1:at + 2] or " "
            punct = lambda c: not c.isalnum() and not c.isspace()
            left = not after.isspace() and (not punct(after) or before.isspace() or punct(before))
            right = not before.isspace() and (not punct(before) or after.isspace() or punct(after))
            if opener is not None and right and (not left or punct(after)):
                for begin, end, token in inside:
                    if begin <= opener < end or begin <= at < end:
                        line = block.line + text.count("\n", 0, begin)
                        self.fault(path, line, f"GitHub may take underscores of {token.text} for "
                                   "emphasis: write it as $`…`$.")
                        break
                opener = None
            elif opener is None and left and (not right or punct(before)):
                opener = at

    # -- the texts

    def text(self, path):
        parts = self.parts[path]
        own = chapter_of(self.root, path)
        self.headings(path, parts, own)
        for k, block in enumerate(parts):
            if block.kind == "math":
                self.maths(path, block.line, "\n".join(block.body), display=True)
                if block.info["indent"]:
                    self.fault(path, block.line, "display maths starts at the margin, not inside a list.")
                for near in (parts[k - 1:k] + parts[k + 1:k + 2]):
                    if near.kind in ("paragraph", "table"):
                        self.fault(path, block.line, "display maths needs a blank line before and after.")
            elif block.kind in ("fence", "snippet"):
                self.code_width(path, block)
            elif block.kind == "html":
                self.details(path, parts, k)
            elif block.kind == "comment":
                self.demo(path, block)
                self.sentence(path, block, (parts[k + 1:] or [None])[0])
            elif block.kind in ("paragraph", "table", "heading"):
                self.running_text(path, block)
                self.figure_layout(path, parts, k)

    def demo(self, path, block):
        try:
            demo = demo_of(block, own_program(self.root, path), "")
        except TextError as fault:
            self.fault(path, block.line, str(fault).lstrip(": "))
            return
        if demo and not (self.root / "chapters" / demo["program"] / "program/main.cpp").is_file():
            self.fault(path, block.line, f"there is no program {demo['program']}.")

    def sentence(self, path, block, after):
        try:
            sentence = sentence_of(block, after, "")
        except TextError as fault:
            self.fault(path, block.line, str(fault).lstrip(": "))
            return
        models = path.parent / "sentence.js"
        if sentence and (not models.is_file() or f"rigid_sentence('{sentence['model']}'" not in models.read_text(encoding="utf-8")):
            self.fault(path, block.line, f"{models.relative_to(self.root)} has no model {sentence['model']}.")

    def code_width(self, path, block):
        """Code that a reader reads or types fits the page; what a program prints may be as wide as it is."""
        language = (snippet_language(block.info["source"], block.info["name"]) if block.kind == "snippet"
                    else block.info["language"])
        if language not in ("cpp", "sh"):
            return
        for k, line in enumerate(block.lines):
            if len(line) > WIDEST_CODE and not line.startswith("<!--"):
                self.fault(path, block.line + k, f"a line of code has {len(line)} columns; the page shows {WIDEST_CODE}.")

    def headings(self, path, parts, own):
        heads = [b for b in parts if b.kind == "heading"]
        titles = [b for b in heads if b.info["level"] == 1]
        if len(titles) != 1 or heads[0] is not titles[0]:
            self.fault(path, (titles[1:] or heads or [parts[0]])[0].line, "a text has one '# Title', at its top.")
        for b in heads:
            if re.search(r"[$`\[]|#$", b.info["title"]):
                self.fault(path, b.line, "no maths, code, link or # in a heading.")
        if own is None or path.parent != self.chapters.get(own):
            return
        if path.name == "in_depth.md":
            self.in_depth(path, titles, heads, own)
        if path.name != "README.md":
            return
        if titles and not re.match(rf"Chapter {own}\. \S", titles[0].info["title"]):
            self.fault(path, titles[0].line, f"the title starts with 'Chapter {own}. '.")
        if (words := words_of(parts)) > MOST_WORDS:
            self.fault(path, 1, f"a main road of {words} words; at most {MOST_WORDS}, the rest goes into in_depth.md.")
        self.ways_on(path, parts)
        count = 0
        for b in heads:
            if b.info["level"] == 2:
                count += 1
                if not re.match(rf"{own}\.{count} \S", b.info["title"]):
                    self.fault(path, b.line, f"this section should be '## {own}.{count} …'.")

    def ways_on(self, path, parts):
        """The line of links to the neighbours stands below the title, and once more at the end."""
        shown = [b for b in parts if b.kind not in ("blank", "comment")]
        lines = [b for b in shown if b.kind == "paragraph" and b.lines[0].startswith("[Contents](")]
        if not lines or shown[1] is not lines[0]:
            self.fault(path, 1, "below the title goes the line '[Contents](…) · [Back: …](…) · [Next: …](…)'.")
        elif shown[-1].text != lines[0].text:
            self.fault(path, parts[-1].line, "a chapter ends with the line of links with which it begins.")

    def in_depth(self, path, titles, heads, own):
        """Beside the main road: its own title, sections with letters, and a link that leads here."""
        if titles and titles[0].info["title"] != f"Chapter {own} in depth":
            self.fault(path, titles[0].line, f"the title is 'Chapter {own} in depth'.")
        sections = [b for b in heads if b.info["level"] == 2]
        for letter, b in zip("ABCDEFGHIJKLMNOPQRSTUVWXYZ", sections):
            if not re.match(rf"{own}\.{letter} \S", b.info["title"]):
                self.fault(path, b.line, f"this section should be '## {own}.{letter} …'.")
        if not re.search(r"\]\(in_depth\.md[#)]", self.texts.get(path.parent / "README.md", "")):
            self.fault(path, 1, "its chapter's README.md has no link to it.")

    def details(self, path, parts, k):
        block = parts[k]
        line = block.lines[0].strip()
        if block.lines[0] != line:
            self.fault(path, block.line, f"{line.split('>')[0]}> stands at the start of its line.")
        if re.match(r"<details", line) and "<summary" in line:
            self.fault(path, block.line, "<summary> goes on a line of its own.")
        if re.match(r"<summary", line):
            if not re.search(r"</summary>$", line):
                self.fault(path, block.line, "<summary>…</summary> is one line.")
            if re.search(r"[$`*]", line):
                self.fault(path, block.line, "a summary is plain words.")
            if k + 1 < len(parts) and parts[k + 1].kind != "blank":
                self.fault(path, block.line, "a blank line goes behind </summary>.")
        opened = sum(len(re.findall(r"<details", b.lines[0])) - len(re.findall(r"</details", b.lines[0]))
                     for b in parts[:k + 1] if b.kind == "html")
        if opened < 0:
            self.fault(path, block.line, "</details> without <details>.")
        if k == max(i for i, b in enumerate(parts) if b.kind == "html") and opened > 0:
            self.fault(path, block.line, "<details> is never closed.")

    def running_text(self, path, block):
        text = block.text
        found = tokens(text)
        in_table = block.kind == "table"
        if block.kind == "paragraph":
            rows = [k for k, l in enumerate(block.lines) if TABLE_LINE.match(l)]
            if rows and re.match(r"^\s*\|[\s:|-]+\|\s*$", block.lines[min(rows[0] + 1, len(block.lines) - 1)]):
                self.fault(path, block.line + rows[0], "a table needs a blank line before and after.")
            for k, l in enumerate(block.lines[1:], 1):
                if re.fullmatch(r"\s*(=+|-+)\s*", l):
                    self.fault(path, block.line + k, "headings are written with #, and a rule has blank lines around it.")
        if in_table:
            self.table(path, block)
        for token in found:
            line = block.line + text.count("\n", 0, token.offset)
            if token.kind == "words":
                self.cited_numbers(path, line, context(text, token), figures=True)
                for m in re.finditer(r"(?<![\\\d])\$(?!\d)", token.text):
                    at = line + token.text.count("\n", 0, m.start())
                    self.fault(path, at, "a $ that belongs to no maths (no space inside the dollars, none across lines).")
                for m in re.finditer(r"(?<!`)`(?!`)", token.text):
                    self.fault(path, line + token.text.count("\n", 0, m.start()), "a ` that is never closed.")
                for m in re.finditer(r"!\[\]|\[[^\]\n]*\]\(\s*\)", token.text):
                    self.fault(path, line + token.text.count("\n", 0, m.start()), "a link to nothing.")
                for m in re.finditer(r"\[\[([^\]]*)\]\]", token.text):
                    self.fault(path, line + token.text.count("\n", 0, m.start()),
                               f"the citation [[{m.group(1)}]] lacks its (…/references.bib).")
            elif token.kind == "math":
                self.inline_maths(path, line, token, in_table)
                self.glued(path, line, text, token)
            elif token.kind == "image":
                self.picture(path, line, token.info)
            elif token.kind == "cite":
                if token.info["key"] not in self.keys:
                    self.fault(path, line, f"docs/references.bib has no '{token.info['key']}'.")
                self.link(path, line, token.info["bib"])
            elif token.kind == "link":
                self.link(path, line, token.info["target"])
                if "$" in token.info["label"]:
                    self.fault(path, line, "GitHub shows no maths inside the words of a link.")
            elif token.kind == "html" and not re.match(r"</?(sub|sup|kbd|br)\b", token.text):
                self.fault(path, line, f"no HTML in the text: {token.text}.")
        self.underscores(path, block, found)
        self.named_tests(path, block, found)

    def glued(self, path, line, text, token):
        before = text[token.offset - 1:token.offset]
        if before and (before.isalnum() or before in "$"):
            self.fault(path, line, f"GitHub shows {token.text} only with a space before it.")

    def table(self, path, block):
        widths = []
        for l in block.lines:
            cells = re.sub(r"`+[^`]*`+", lambda m: m.group(0).replace("|", " "), l)
            if cells != re.sub(r"`+[^`]*`+", lambda m: m.group(0), l):
                self.fault(path, block.line + block.lines.index(l), "no | inside code in a table.")
            widths.append(len(re.findall(r"(?<!\\)\|", l)))
        if len(block.lines) < 2 or not re.match(r"^\s*\|[\s:|-]+\|\s*$", block.lines[1]):
            self.fault(path, block.line, "a table has a header row and a |---| row.")
        if (pixels := least_width(block)) > WIDEST_TABLE:
            self.fault(path, block.line, f"this table needs about {pixels} pixels; the page shows {WIDEST_TABLE}.")
        for k, width in enumerate(widths):
            if width != widths[0]:
                self.fault(path, block.line + k, f"this row of the table has {width - 1} cells, its header {widths[0] - 1}.")

    def figure_layout(self, path, parts, k):
        """A caption stands behind its picture, a picture of a chapter has a caption."""
        block = parts[k]
        if block.kind != "paragraph":
            return
        if FIGURE_CAPTION.match(block.lines[0]):
            before = [b for b in parts[:k] if b.kind not in ("blank", "comment")]
            if not before or not lone_picture(before[-1]):
                self.fault(path, block.line, "this caption does not stand below a picture.")
        elif lone_picture(block) and chapter_of(self.root, path):
            behind = [b for b in parts[k + 1:] if b.kind not in ("blank", "comment")]
            if not behind or behind[0].kind != "paragraph" or not FIGURE_CAPTION.match(behind[0].lines[0]):
                self.fault(path, block.line, "a picture of a chapter has a caption '**Figure N.M.** …' below it.")

    def named_tests(self, path, block, found):
        """`name` in `tests/file.cpp`: is there such a test?"""
        for name, between, place in zip(found, found[1:], found[2:]):
            if name.kind != "code" or between.text.strip() != "in":
                continue
            at = place.info.get("code") or place.info.get("label", "").strip("`")
            if not re.fullmatch(r"tests/[\w./-]+\.cpp", at):
                continue
            test, file = re.sub(r"\s+", " ", name.info["code"]), self.root / at
            line = block.line + block.text.count("\n", 0, name.offset)
            if not file.is_file():
                self.fault(path, line, f"there is no {at}.")
            elif test not in self.names(file):
                self.fault(path, line, f"{at} has no test '{test}'.")

    def names(self, file):
        if file not in self.tests:
            self.tests[file] = {name for _, name in test_names(file.read_text(encoding="utf-8"))}
        return self.tests[file]

    # -- the rest

    def notation(self):
        """Each name in the second column of the tables of letters is one of the code, not of its comments."""
        path = self.root / "docs" / "notation.md"
        if path not in self.parts:
            return
        code = "".join(CPP.sub(lambda m: m.group(0) if m.group("string") or m.group("char") else " ",
                               file.read_text(encoding="utf-8"))
                       for file in source_files(self.root) if file.relative_to(self.root).parts[0] != "tests")
        known = set(re.findall(r"[A-Za-z_]\w*", code))
        for block in self.parts[path]:
            if block.kind != "table" or "| code |" not in block.lines[0]:
                continue
            for k, line in enumerate(block.lines[2:], 2):
                for name in re.findall(r"[A-Za-z_]\w*", " ".join(re.findall(r"`([^`]+)`", line.split("|")[2]))):
                    if name not in known:
                        self.fault(path, block.line + k, f"no source has the name '{name}'.")

    def sources(self):
        for path in source_files(self.root):
            source = path.read_text(encoding="utf-8")
            for line, comment in comments(source):
                plain = re.sub(r"`[^`]*`", lambda m: " " * len(m.group(0)), comment)
                self.cited_numbers(path, line, plain, figures=True)
                for key in re.findall(r"[\\@]cite\s+([\w-]+)", comment):
                    if key not in self.keys:
                        self.fault(path, line, f"docs/references.bib has no '{key}'.")
            for line, name in test_names(source):
                self.cited_numbers(path, line, name)

    def drawings(self):
        for number, folder in self.chapters.items():
            text = folder / "README.md"
            for file in sorted((folder / "figures").glob("*")):
                if file.suffix.lower() not in PICTURES:
                    continue
                if text.is_file() and (number, file.resolve()) not in self.shown:
                    self.fault(file, 1, "this picture is not shown by its chapter.")
                if not file.name.startswith(f"ch{number:02d}_"):
                    self.fault(file, 1, f"the name of this picture does not begin with ch{number:02d}_.")
                if file.suffix.lower() == ".svg":
                    source = file.read_text(encoding="utf-8", errors="replace")
                    for m in re.finditer(r">([^<>]+)<", source):
                        if not EQUATION.search(m.group(1)):
                            continue  # to count the lines before each number of an axis takes seconds
                        self.cited_numbers(file, source.count("\n", 0, m.start()) + 1, m.group(1))

    def run(self):
        self.read()
        for path in self.texts:
            self.text(path)
        self.sources()
        self.notation()
        self.drawings()
        return [f"{where}:{line}: {sentence}" for where, line, sentence in sorted(set(self.faults))]


def context(text, token):
    """The words of a token, joined to the character before them, so that `f`(1.5) is a call."""
    before = text[token.offset - 1:token.offset]
    return ("x" if before in ("`", ")", "]") and before else "") + token.text if token.text.startswith("(") else token.text


def words_of(parts):
    """The length of a main road: the words (between blanks) of headings, paragraphs and tables, with captions,
    alternative texts, exercises and folded solutions. Code, displayed maths and quoted sources do not count."""
    return sum(len(SPAN.sub(r"\3", b.text).split()) for b in parts if b.kind in ("heading", "paragraph", "table"))


def least_width(table):
    """How narrow a table can be set [pixels], about: headers, code and maths are not broken, words are."""
    def parts(cell, whole):
        for token in tokens(cell.strip()):
            if token.kind == "math":
                tex = re.sub(r"\\text\{([^}]*)\}", r"\1", token.info["tex"])
                yield len(re.sub(r"[{}^_\\ ]", "", re.sub(r"\\[A-Za-z]+", "x", tex)))
            elif token.kind == "code":
                yield len(token.info["code"])
            else:
                words = token.info.get("label") or token.info.get("key") or ("" if token.kind == "image" else token.text)
                yield len(words) if whole else max((len(word) for word in words.split()), default=0)

    columns = {}
    for k, line in enumerate(table.lines):
        if k == 1:
            continue
        plain = re.sub(r"`[^`]*`", lambda m: m.group(0).replace("|", "/"), line.strip().strip("|"))
        for column, cell in enumerate(re.split(r"(?<!\\)\|", plain)):
            wide = sum(parts(cell, True)) if k == 0 else max(parts(cell, False), default=0)
            columns[column] = max(columns.get(column, 0), wide)
    return round(sum(7.2 * characters + 22 for characters in columns.values()))


def shorten(tex):
    tex = " ".join(tex.split())
    return tex if len(tex) < 50 else tex[:47] + "…"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the book's folder")
    faults = Checker(book_folder(parser.parse_args().root)).run()
    for sentence in faults:
        print(sentence, file=sys.stderr)
    if faults:
        print(f"{len(faults)} fault{'s' if len(faults) > 1 else ''} in the texts.", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    run_tool(main)
