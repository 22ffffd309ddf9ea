#!/usr/bin/env python3
"""Write the input that Doxygen reads, from what GitHub and the compiler read.

    docs/tools/doxygen_filter.py FILE      the filtered text on stdout

Called by Doxygen for each file (FILTER_PATTERNS). A Markdown text: maths, quoted
code, figures, links and citations become Doxygen's own. A C++ source: an equation
number in a doc comment becomes a link; the number of lines stays what it is.
A test: each test becomes a documented function that bears its name.
"""
import html
import pathlib
import re
import sys

from booktext import (EQUATION, FIGURE, FIGURE_CAPTION, MARKER, ROOT, TAG, TextError, blocks,
                      chapters, comments, equation_tags, figure_captions, page_id, slug,
                      snippet_code, test_names, tokens)


def label(text):
    """Letters, digits and _ only: what a Doxygen anchor may be made of."""
    return re.sub(r"[^A-Za-z0-9]", lambda m: "_" if m.group(0) in "-_. " else f"x{ord(m.group(0)):x}", text)


def packed(tex):
    """Inline maths as one plain word. Doxygen 1.9.4 sets its own \\f$…\\f$ apart by a space, and
    so breaks `**$x$**`, `($x$)` and quotes; finish_html.py unpacks the word."""
    return f"texq{tex.encode().hex()}q"


def unpacked(text):
    return re.sub(r"texq((?:[0-9a-f]{2})+)q",
                  lambda m: "\\(" + html.escape(bytes.fromhex(m.group(1)).decode(), quote=False) + "\\)", text)


def section_label(page, anchor):
    return f"{page}_{label(anchor)}"


class Book:
    """What a page must know of the others: which equations and figures there are."""

    def __init__(self, root):
        self.root = root
        self.equations, self.figures = set(), set()
        for folder in chapters(root).values():
            text = folder / "README.md"
            if text.is_file():
                try:
                    content = text.read_text(encoding="utf-8")
                    self.equations |= {tag for tag, _ in equation_tags(content)}
                    self.figures |= {number for number, _ in figure_captions(content)}
                except TextError:
                    pass  # check_text says what is wrong with it

    def linked(self, words):
        """Equation and figure numbers of running text, as links."""
        def equation(m):
            number = m.group(0)[1:-1]
            return f'\\ref eq_{label(number)} "({number})"' if number in self.equations else m.group(0)

        def figure(m):
            number = f"{m.group(1)}.{m.group(2)}"
            return f'\\ref fig_{label(number)} "{m.group(0)}"' if number in self.figures else m.group(0)

        return FIGURE.sub(figure, EQUATION.sub(equation, words))


class Page:
    """One Markdown text on its way to Doxygen."""

    def __init__(self, book, path):
        self.book, self.path, self.root = book, path.resolve(), book.root
        self.id = page_id(self.root, self.path)

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

    def link(self, text, link):
        if re.match(r"^[a-z]+:", link):
            return f"[{text}]({link})"
        plain = re.sub(r"[`*]", "", text).replace('"', "'")
        plain = re.sub(r"\s+", " ", plain)
        file, anchor = self.target(link)
        if file.is_dir() and (file / "README.md").is_file():
            file = file / "README.md"
        if file.suffix == ".md":
            page = page_id(self.root, file)
            if page == "index" and anchor:
                return f'<a href="index.html#{section_label(page, anchor)}">{self.inline(text)}</a>'
            return f'\\ref {section_label(page, anchor) if anchor else page} "{plain}"'
        if file.suffix == ".bib":
            return f'\\ref citelist "{plain}"'
        # finish_html.py puts the address of the page in, or leaves the words alone
        return f'<a href="book:{html.escape(self.relative(file))}">{self.inline(text)}</a>'

    def image(self, info):
        source = self.relative((self.path.parent / info["src"]).resolve())
        width = f' width="{html.escape(info["width"])}"' if info.get("width") else ""
        alt = html.escape(re.sub(r"\s+", " ", info["alt"]))
        tag = f'<img src="pictures/{html.escape(source)}" alt="{alt}"{width}/>'
        if "target" in info:
            file, anchor = self.target(info["target"])
            if file.suffix == ".md":
                page = page_id(self.root, file) + ".html"
                tag = f'<a href="{page}{"#" + section_label(page[:-5], anchor) if anchor else ""}">{tag}</a>'
            else:
                tag = f'<a href="book:{html.escape(self.relative(file))}">{tag}</a>'
        return tag

    # -- running text

    def words(self, text):
        text = text.replace("@", "\\@").replace("%", "\\%")
        text = re.sub(r"(?<![-|:])--(?![-|:])", r"\\--", text)  # not the rule of a table
        text = re.sub(r"<(https?://[^\s<>]+)>", r'<a href="\1">\1</a>', text)
        text = re.sub(r"<(?=\S)(?!/?a\b)", "&lt;", text)
        text = re.sub(r"#(?=\w)", r"\\#", text)
        text = re.sub(r"::(?=\w)", r"\\::", text)
        return self.book.linked(text)

    def inline(self, text):
        out = []
        for token in tokens(text):
            info = token.info
            if token.kind == "math":
                out.append(packed(re.sub(r"\s+", " ", info["tex"])))
            elif token.kind == "code":
                code = re.sub(r"\s*\n\s*", " ", info["code"])
                ticks = "``" if "``" not in code else "```"
                space = " " if code.startswith("`") or code.endswith("`") else ""
                out.append(f"{ticks}{space}{code}{space}{ticks}")
            elif token.kind == "image":
                out.append(f"\\htmlonly{self.image(info)}\\endhtmlonly")
            elif token.kind == "cite":
                out.append(f"\\cite {info['key']}&zwnj;")
            elif token.kind == "link":
                out.append(self.link(info["label"], info["target"]))
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
        if level == 1:
            return [f"# {self.inline(title)}" + ("" if self.id == "index" else f" {{#{self.id}}}")]
        return ["", "#" * level + f" {self.inline(title)} {{#{section_label(self.id, anchor)}}}"]

    def math(self, block):
        out = [""]
        for line in block.body:
            out += [f"\\anchor eq_{label(tag.strip())}" for tag in TAG.findall(line)]
        return out + ["\\f["] + [l for l in block.body if l.strip()] + ["\\f]", ""]

    def fence(self, block):
        pad = " " * block.info["indent"]
        language = block.info["language"]
        kind = {"c++": "cpp", "cxx": "cpp", "hpp": "cpp", "cpp": "cpp", "py": "py", "python": "py"}
        return [f"{pad}```{{.{kind.get(language, 'unparsed')}}}"] + block.body + [f"{pad}```"]

    def snippet(self, block):
        source = (self.path.parent / block.info["source"]).resolve()
        first, last, code = snippet_code(source, block.info["name"])
        name = self.relative(source)
        return ["", "```{.cpp}", *code, "```", "",
                f'\\htmlonly[block]<div class="origin"><a href="book:{html.escape(name)}#{first}">'
                f"{html.escape(name)}, lines {first} to {last}</a></div>\\endhtmlonly", ""]

    def figure(self, picture, caption):
        """A picture that stands alone, with the caption paragraph behind it, if there is one."""
        out = [""]
        if caption:
            number = FIGURE_CAPTION.match(caption.lines[0]).group(1)
            out += [f"\\anchor fig_{label(number)}", ""]
        out += [f'\\htmlonly[block]<div class="figure">{self.image(picture)}</div>\\endhtmlonly', ""]
        if caption:
            text = FIGURE_CAPTION.sub("", "\n".join(caption.lines), count=1).strip()
            out += ['<div class="figcaption">', f"<b>Figure {number}.</b> {self.inline(text)}", "</div>", ""]
        return out

    def text(self):
        source = self.path.read_text(encoding="utf-8")
        parts = [b for b in blocks(source, str(self.path))]
        out, seen, k = [], {}, 0

        def lone_picture(block):
            if block.kind != "paragraph" or len(block.lines) != 1:
                return None
            found = [t for t in tokens(block.lines[0].strip()) if t.text.strip()]
            return found[0].info if len(found) == 1 and found[0].kind == "image" else None

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
            elif block.kind == "comment":
                pass
            elif lone_picture(block):
                after = k + 1
                while after < len(parts) and parts[after].kind == "blank":
                    after += 1
                caption = parts[after] if after < len(parts) else None
                if not (caption and caption.kind == "paragraph" and FIGURE_CAPTION.match(caption.lines[0])):
                    caption = None
                out += self.figure(lone_picture(block), caption)
                if caption:
                    k = after
            elif block.kind in ("paragraph", "table"):
                out += self.paragraph(block.lines)
            else:
                out += block.lines
            k += 1
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
        pieces[::2] = [book.linked(p) for p in pieces[::2]]
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
        lines[line - 1] = f"/** {book.linked(safe)} */ void test_{count:03d}();"
    title = f"/** \\file tests/{path.name} \\brief The tests of {path.stem}. */"
    return title + "\n".join(lines)


def main():
    path = pathlib.Path(sys.argv[1]).resolve()
    book = Book(ROOT)
    if path.suffix == ".md":
        sys.stdout.write(Page(book, path).text())
    else:
        source = path.read_text(encoding="utf-8")
        in_tests = path.is_relative_to(ROOT / "tests") and path.suffix == ".cpp"
        sys.stdout.write(test_text(book, path, source) if in_tests else source_text(book, source))


if __name__ == "__main__":
    try:
        main()
    except TextError as fault:
        sys.exit(f"doxygen_filter.py: {fault}")
