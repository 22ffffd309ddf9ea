#!/usr/bin/env python3
"""Write the input that Doxygen reads, from what GitHub and the compiler read.

    docs/tools/doxygen_filter.py FILE          the filtered text on stdout
    docs/tools/doxygen_filter.py --all FOLDER  all texts and sources of the book, filtered, in FOLDER

Doxygen asks for some files many times, one process each (FILTER_PATTERNS); so all are filtered once, before
it begins, and docs/tools/filtered.sh hands them over. A Markdown text: maths, quoted
code, figures, links and citations become Doxygen's own. A C++ source: an equation
number in a doc comment becomes a link; the number of lines stays what it is.
A test: each test becomes a documented function that bears its name.
"""
import argparse
import html
import json
import pathlib
import re
import sys

from booktext import (EQUATION, FIGURE, FIGURE_CAPTION, MARKER, ROOT, TAG, TextError, bib_keys,
                      blocks, chapter_texts, chapters, comments, equation_tags, figure_captions, lone_picture, markdown_files, page_id, run_tool,
                      slug, snippet_code, snippet_language, source_files, test_names, tokens)
from demos import demo_of, own_program
from sentences import place, sentence_of


def label(text):
    """Letters, digits and _ only: what a Doxygen anchor may be made of."""
    return re.sub(r"[^A-Za-z0-9]", lambda m: "_" if m.group(0) in "-_. " else f"x{ord(m.group(0)):x}", text)


def packed(markup):
    """A piece of finished HTML as one plain word, which finish_html.py unpacks again. Doxygen
    1.9.4 puts a space before a formula and stumbles over commands and code next to `**`, `(` and
    quotes; a word it leaves alone everywhere, in tables too."""
    return f"packq{markup.encode().hex()}q"


def unpacked(text):
    return re.sub(r"packq((?:[0-9a-f]{2})+)q", lambda m: bytes.fromhex(m.group(1)).decode(), text)


def section_label(page, anchor):
    return f"{page}_{label(anchor)}"


RACE = re.compile(r"^<!--\s*race\s*-->\s*$")


def loading(sheet, *scripts):
    return f'<link href="{sheet}" rel="stylesheet" type="text/css"/>' + "".join(
        f'<script src="{script}.js" defer="defer"></script>' for script in scripts)


class Book:
    """What a page must know of the others: on which page each equation and figure is."""

    def __init__(self, root):
        self.root = root
        self.equations, self.figures = {}, {}
        for folder in chapters(root).values():
            for text in chapter_texts(folder):
                page = page_id(root, text) + ".html"
                try:
                    content = text.read_text(encoding="utf-8")
                    self.equations.update((tag, page) for tag, _ in equation_tags(content))
                    self.figures.update((number, page) for number, _ in figure_captions(content))
                except TextError:
                    pass  # check_text says what is wrong with it

    def numbers(self, words, equation, figure):
        """Running text with its equation and figure numbers replaced: equation(number, text)."""
        def replace(known, make):
            def one(m):
                number = ".".join(m.groups()[:2]) + "".join(m.groups()[2:])
                return make(number, m.group(0)) if number in known else m.group(0)
            return one

        return FIGURE.sub(replace(self.figures, figure), EQUATION.sub(replace(self.equations, equation), words))

    def links(self, words):
        """For a text: packed links."""
        return self.numbers(
            words,
            lambda n, text: packed(f'<a class="el" href="{self.equations[n]}#eq_{label(n)}">{text}</a>'),
            lambda n, text: packed(f'<a class="el" href="{self.figures[n]}#fig_{label(n)}">{text}</a>'))

    def refs(self, words):
        """For a doc comment: Doxygen's own links."""
        return self.numbers(words, lambda n, text: f'\\ref eq_{label(n)} "{text}"',
                            lambda n, text: f'\\ref fig_{label(n)} "{text}"')


class Page:
    """One Markdown text on its way to Doxygen."""

    def __init__(self, book, path):
        self.book, self.path, self.root = book, path.resolve(), book.root
        self.id = page_id(self.root, self.path)
        self.has_demo = self.has_sentence = False

    # -- links

    def target(self, link):
        """(file or None for this one, anchor) of a relative link."""
        file, _, anchor = link.partition("#")
        return (self.path.parent / file).resolve() if file else self.path, anchor

    def relative(self, path):
        try:
            return path.relative_to(self.root).as_posix()
        except ValueError:
            return path.as_posix()

    def address(self, link):
        """Where a link of the text leads on the site."""
        if re.match(r"^[a-z][a-z0-9+.-]*:", link, re.I):
            return link
        file, anchor = self.target(link)
        if (file / "README.md").is_file():
            file = file / "README.md"
        if file.suffix == ".md":
            page = page_id(self.root, file)
            return f"{page}.html" + (f"#{section_label(page, anchor)}" if anchor else "")
        if file.suffix == ".bib":
            return "citelist.html"
        return f"book:{self.relative(file)}"  # finish_html.py knows the page, or keeps the words alone

    def anchor_tag(self, inside, link):
        end = "<!--/book-->" if self.address(link).startswith("book:") else ""
        return f'<a class="el" href="{html.escape(self.address(link))}">{inside}{end}</a>'

    def markup(self, text):
        """The words of a link as HTML."""
        out = []
        for token in tokens(text):
            if token.kind == "code":
                out.append(f"<code>{html.escape(token.info['code'], quote=False)}</code>")
            else:
                out.append(html.escape(token.text.lstrip("\\") if token.kind == "escape" else token.text, quote=False))
        return re.sub(r"\*([^*]+)\*", r"<em>\1</em>", re.sub(r"\*\*([^*]+)\*\*", r"<b>\1</b>", "".join(out)))

    def image(self, info):
        source = self.relative((self.path.parent / info["src"]).resolve())
        width = f' width="{html.escape(info["width"])}"' if info.get("width") else ""
        alt = html.escape(re.sub(r"\s+", " ", info["alt"]))
        tag = f'<img src="pictures/{html.escape(source)}" alt="{alt}"{width}/>'
        if "dark" in info:  # the site's switch decides, not the system's; what is not shown is not loaded
            def of(room, name):
                here, still = (html.escape(self.relative((self.path.parent / info[one]).resolve())) for one in (room, "still"))
                return (f'<picture class="room-{name}"><source media="(prefers-reduced-motion: reduce)" srcset="pictures/{still}"/>'
                        f'<img src="pictures/{here}" alt="{alt}"{width} loading="lazy"/></picture>')
            tag = of("src", "light") + of("dark", "dark")
        return self.anchor_tag(tag, info["target"]) if "target" in info else tag

    def code(self, text):
        """A code span; the name of a file of the book is a link to its page."""
        text = re.sub(r"\s*\n\s*", " ", text)
        tag = f"<code>{html.escape(text, quote=False)}</code>"
        if re.fullmatch(r"[\w.-]+(/[\w.-]+)+", text) and (self.root / text).is_file():
            return f'<a class="el" href="book:{html.escape(text)}">{tag}<!--/book--></a>'
        return tag

    # -- running text

    def words(self, text, links=True):
        text = re.sub(r"<(https?://[^\s<>]+)>",
                      lambda m: packed(f'<a href="{m.group(1)}">{m.group(1)}</a>'), text)
        if links:
            text = self.book.links(text)
        text = text.replace("@", "\\@").replace("%", "\\%")
        text = re.sub(r"(?<![-|:])--(?![-|:])", r"\\--", text)  # not the rule of a table
        text = re.sub(r"<(?=\S)", "&lt;", text)
        text = re.sub(r"#(?=\w)", r"\\#", text)
        return re.sub(r"::(?=\w)", r"\\::", text)

    def inline(self, text):
        out = []
        for token in tokens(text):
            info = token.info
            if token.kind == "math":
                tex = re.sub(r"\s+", " ", info["tex"])
                out.append(packed(f"\\({html.escape(tex, quote=False)}\\)"))
            elif token.kind == "code":
                out.append(packed(self.code(info["code"])))
            elif token.kind == "escape":
                out.append(packed(html.escape(token.text[1:])))
            elif token.kind == "image":
                out.append(packed(self.image(info)))
            elif token.kind == "cite":
                key = html.escape(info["key"])
                out.append(packed(f'<a class="el" href="citelist.html#CITEREF_{key}">[{key}]</a>'))
            elif token.kind == "link":
                out.append(packed(self.anchor_tag(self.markup(info["label"]), info["target"])))
            elif token.kind == "span":
                out.append(packed(token.text))
            elif token.kind == "words":
                out.append(self.words(token.text))
            else:
                out.append(token.text)
        return "".join(out)

    def paragraph(self, lines):
        """Lines of running text. A line that only by wrapping starts with `2. ` is no list."""
        if not re.match(r"^\s*([-*+]|\d+[.)])\s", lines[0]):
            lines = lines[:1] + [re.sub(r"^(\d+)\.(\s)", r"\1\\.\2", l) for l in lines[1:]]
        return self.inline("\n".join(lines)).split("\n")

    # -- blocks

    def heading(self, block, seen):
        level, title = block.info["level"], block.info["title"]
        anchor = slug(title, seen)
        if self.id == "index" and level > 1:  # no entries in the sidebar before the chapters
            return ["", f'\\htmlonly[block]<h{level - 1}><a class="anchor" id="{section_label("index", anchor)}"></a>'
                        f"{html.escape(title)}</h{level - 1}>\\endhtmlonly", ""]
        mark = section_label(self.id, anchor) if level > 1 else self.id
        words = self.words(title, links=False)
        return ["", f"{'#' * level} {words}" + ("" if self.id == "index" else f" {{#{mark}}}")]

    def math(self, block):
        out = [""]
        for line in block.body:
            out += [f"\\anchor eq_{label(tag.strip())}" for tag in TAG.findall(line)]
        return out + ["\\f["] + [l for l in block.body if l.strip()] + ["\\f]", ""]

    def fenced(self, code, kind, pad=""):
        """A fence that its content cannot close."""
        mark = "~~~" if any(line.lstrip().startswith("```") for line in code) else "```"
        return [f"{pad}{mark}{{.{kind}}}", *code, pad + mark]

    def fence(self, block):
        kinds = {"c++": "cpp", "cxx": "cpp", "hpp": "cpp", "cpp": "cpp", "py": "py", "python": "py"}
        kind = kinds.get(block.info["language"], "unparsed")
        return self.fenced(block.body, kind, " " * block.info["indent"])

    def snippet(self, block):
        source = (self.path.parent / block.info["source"]).resolve()
        first, last, code = snippet_code(source, block.info["name"])
        name = self.relative(source)
        kind = "cpp" if snippet_language(name, block.info["name"]) == "cpp" else "unparsed"
        return ["", *self.fenced(code, kind), "",
                f'\\htmlonly[block]<div class="origin"><a href="book:{html.escape(name)}#{first}">'
                f"{html.escape(name)}, lines {first} to {last}<!--/book--></a></div>\\endhtmlonly", ""]

    def figure(self, picture, caption, demo=None):
        """A picture that stands alone, with the caption paragraph behind it, if there is one, and the demo before it."""
        out = [""]
        if caption:
            number = FIGURE_CAPTION.match(caption.lines[0]).group(1)
            out += [f"\\anchor fig_{label(number)}", ""]
        shown = (demo and self.demo(demo, picture)) or f'<div class="figure">{self.image(picture)}</div>'
        out += [f"\\htmlonly[block]{shown}\\endhtmlonly", ""]
        if caption:
            text = FIGURE_CAPTION.sub("", "\n".join(caption.lines), count=1).strip()
            out += ['<div class="figcaption">', f"<b>Figure {number}.</b> {self.inline(text)}", "</div>", ""]
        return out

    def demo(self, block, picture=None):
        """The place of a demo, if the programs for the pages were built (docs/build.sh): a still picture, which is the
        figure where the demo stands before one, and a button. Else None."""
        demo = demo_of(block, own_program(self.root, self.path), f"{self.relative(self.path)}:{block.line}")
        stills = self.root / "build/docs/demos/demos.json"
        if not demo or not stills.is_file():
            return None
        told = json.loads(stills.read_text(encoding="utf-8")).get(demo["still"])
        if not told:  # of an older text: docs/build.sh draws all of them
            return None

        def settings(one):
            return " ".join(f"{name}={value:.17g}" for name, value in one.items())

        data = {"program": demo["program"], "scene": demo["scene"], "methods": " ".join(demo["methods"]),
                "settings": settings(demo["settings"])}
        if demo["break"]:
            off = demo["break"]
            data["break"] = f"{off['label']}|{' '.join(off['methods'])}|{settings(off['settings'])}"
        if demo["opens"]:
            data["opens"] = ""
        attributes = "".join(f' data-{name}="{html.escape(value)}"' for name, value in data.items())
        summary = html.escape(told["summary"])
        head = "" if self.has_demo else loading("demo.css", "unpack", "join", "machine", "painter", "demo")
        self.has_demo = True
        still = self.image(picture) if picture else (
            f'<img class="demo-still" src="demos/{demo["still"]}" alt="Still picture of the demo: {summary}" '
            f'width="{told["width"]}" height="{told["height"]}"/>')
        says = f'<p class="demo-says">{html.escape(demo["says"])}</p>' if demo["says"] else ""
        return (f'{head}<div class="demo"{attributes}><div class="figure">{still}</div><div class="demo-begin">'
                f'<button type="button" class="demo-start" aria-label="Run the demo: {summary}">&#9654;&#65038; Run it</button>'
                f"<span>{summary}</span></div></div>{says}")

    def race(self, block):
        """The place of the race (docs/race.md), if its program was built; with what it needs of the other engine, if that is
        installed."""
        if not RACE.match(block.lines[0]) or not (self.root / "build/docs/demos/race.js").is_file():
            return None
        peer = (self.root / "build/docs/demos/box2d3_wasm.js").is_file()
        peer_mark = ' data-peer=""' if peer else ""
        return (loading("demo.css", "unpack", "join", "machine") + loading("race.css", *(["box2d"] if peer else []), "race") +
                f'<div class="demo race"{peer_mark}><div class="demo-begin">'
                '<button type="button" class="demo-start" aria-label="Run the race">&#9654;&#65038; Run it</button>'
                "<span>The same scene on both sides, at the same time</span></div></div>")

    def sentence(self, block, paragraph):
        """A paragraph with numbers that can be dragged, or None: sentence.js puts its small figure below it."""
        sentence = sentence_of(block, paragraph, f"{self.relative(self.path)}:{block.line}")
        if not sentence:
            return None
        head = "" if self.has_sentence else loading("sentence.css", "sentence", f"sentence_{self.path.parent.name}")
        self.has_sentence = True
        return [f"\\htmlonly[block]{head}{place(sentence)}\\endhtmlonly", "", *self.paragraph(paragraph.lines), "",
                "\\htmlonly[block]</div>\\endhtmlonly", ""]

    def text(self):
        source = self.path.read_text(encoding="utf-8")
        parts = [b for b in blocks(source, str(self.path))]
        out, seen, k = [], {}, 0
        before = None  # the comment in front of a picture

        while k < len(parts):
            block = parts[k]
            if block.kind == "heading":
                out += self.heading(block, seen)
            elif block.kind == "math":
                out += self.math(block)
            elif block.kind == "fence":
                out += self.fence(block)
            elif block.kind == "snippet":
                out += self.snippet(block)
            elif block.kind == "html":  # Doxygen 1.9.4 closes <details> at a blank line
                out += [f"\\htmlonly[block]{block.lines[0].strip()}\\endhtmlonly", ""]
            elif block.kind == "comment" and (shown := self.sentence(block, parts[k + 1] if k + 1 < len(parts) else None)):
                out += shown
                k += 1
            elif block.kind == "comment":
                after = next((one for one in parts[k + 1:] if one.kind != "blank"), None)
                if after and lone_picture(after):
                    before = block
                elif shown := self.demo(block) or self.race(block):
                    out += ["", f"\\htmlonly[block]{shown}\\endhtmlonly", ""]
            elif lone_picture(block):
                after = k + 1
                while after < len(parts) and parts[after].kind == "blank":
                    after += 1
                caption = parts[after] if after < len(parts) else None
                if not (caption and caption.kind == "paragraph" and FIGURE_CAPTION.match(caption.lines[0])):
                    caption = None
                out += self.figure(lone_picture(block), caption, before)
                before = None
                if caption:
                    k = after
            elif block.kind in ("paragraph", "table"):
                out += self.paragraph(block.lines)
            else:
                out += block.lines
            k += 1
        if self.id == "index":  # the bibliography lists what is cited: all of it
            out += ["", "\\htmlonly[block]<div hidden=\"hidden\">\\endhtmlonly", ""]
            out += [f"\\cite {key}" for key in bib_keys(self.root)]
            out += ["", "\\htmlonly[block]</div>\\endhtmlonly"]
        return "\n".join(out) + "\n"


def source_text(book, source):
    """A C++ source with the equation numbers of its doc comments as links.

    The markers of snippets are left out: Doxygen would take `//! [name]` for documentation.
    """
    lines = ["" if MARKER.match(line) else line for line in source.split("\n")]
    for number, comment in comments(source):
        m = re.match(r"^(//[/!]<?)( *)(.*)$", comment)
        if not m or len(m.group(2)) >= 5:  # five spaces: a code block of the comment
            continue
        pieces = re.split(r"(`[^`]*`|\\f\$.*?\\f\$|\"[^\"]*\")", m.group(3))
        pieces[::2] = [re.sub(r"([\\\\@]cite\s+[\w-]+)(?=[:.,;])", r"\1&zwnj;", book.refs(p)) for p in pieces[::2]]
        linked = m.group(1) + m.group(2) + "".join(pieces)
        if linked != comment:
            lines[number - 1] = lines[number - 1].replace(comment, linked)
    return "\n".join(lines)


def test_text(book, path, source):
    """The tests of a file as functions, each on the line where it stands in the source."""
    lines = [""] * (source.count("\n") + 1)
    cases = [(line, name) for line, name in test_names(source)
             if re.search(r"\b(TEST_CASE|SCENARIO)\b", source.split("\n")[line - 1])]
    for count, (line, name) in enumerate(cases, 1):
        safe = re.sub(r"([@\\#<>%*`$&])", r"\\\1", name)
        lines[line - 1] = f"/** {book.refs(safe)} */ void test_{count:03d}();"
    title = f"/** \\file tests/{path.name} \\brief The tests of {path.stem}. */"
    return title + "\n".join(lines)


def filtered(book, path):
    if path.suffix == ".md":
        return Page(book, path).text()
    source = path.read_text(encoding="utf-8")
    in_tests = path.parent == ROOT / "tests" and path.suffix == ".cpp"
    return test_text(book, path, source) if in_tests else source_text(book, source)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("file", nargs="?", type=pathlib.Path, help="a text or a source of the book")
    what.add_argument("--all", metavar="FOLDER", type=pathlib.Path, help="all of them, into this folder")
    arguments = parser.parse_args()
    if arguments.all:
        book = Book(ROOT)
        for path in markdown_files(ROOT) + source_files(ROOT):
            here = arguments.all / path.relative_to(ROOT)
            here.parent.mkdir(parents=True, exist_ok=True)
            here.write_text(filtered(book, path), encoding="utf-8")
        return
    path = arguments.file.resolve()
    if not path.is_file():
        raise TextError(f"{path} is no file")
    if not path.is_relative_to(ROOT):
        raise TextError(f"{path} is not in the book, which is {ROOT}")
    sys.stdout.write(filtered(Book(ROOT), path))


if __name__ == "__main__":
    run_tool(main)
