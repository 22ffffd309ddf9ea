"""What the tools of this folder share: how the book's Markdown and its C++ are read.

A text is cut into BLOCKS (headings, paragraphs, fences, snippets), a paragraph
into TOKENS (code span, inline maths, image, citation, link, plain words). The
checks and the Doxygen filter work on the same tokens, so what is checked is
what is rendered.
"""
import difflib
import os
import pathlib
import re
import sys
import textwrap
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field


class TextError(Exception):
    """A fault in a text, said in one sentence that starts with file:line."""


ROOT = pathlib.Path(__file__).resolve().parents[2]


def book_folder(path):
    """The book's folder that was named, or a TextError: what is not there has no faults, and must not pass."""
    path = pathlib.Path(path).resolve()
    if not (path / "README.md").is_file() or not chapters(path):
        raise TextError(f"{path} is no folder of the book: it must have a README.md and chapters/01_…")
    return path


def run_tool(main):
    """Runs a tool's main() and ends with its exit code; what goes wrong is one sentence and exit code 2."""
    name = pathlib.Path(sys.argv[0]).name
    try:
        code = main()
        sys.stdout.flush()
    except KeyboardInterrupt:
        code = 130
    except (TextError, OSError, UnicodeError, xml.ParseError) as fault:
        what = " ".join(str(fault).split())
        if isinstance(fault, UnicodeError):
            what = f"a text is not UTF-8: {what}"
        if isinstance(fault, xml.ParseError):
            what = f"the tag file is not XML: {what}"
        print(f"{name}: {what}", file=sys.stderr)
        code = 2
        if isinstance(fault, OSError):  # a full disk or a closed pipe: no second complaint at the end
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    sys.exit(code)


# ------------------------------------------------------------------ the files

def chapters(root):
    """{1: folder, 2: folder, …} of chapters/NN_name."""
    found = {}
    for folder in sorted((root / "chapters").glob("[0-9][0-9]_*")):
        if folder.is_dir():
            found[int(folder.name[:2])] = folder
    return found


def chapter_texts(folder):
    """The texts of a chapter that number equations and figures: the main road, then what goes deeper."""
    return [text for text in (folder / "README.md", folder / "in_depth.md") if text.is_file()]


def markdown_files(root):
    """All texts of the book, chapters in order."""
    files = [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CODE_OF_CONDUCT.md")]
    for folder in chapters(root).values():
        files += chapter_texts(folder)
    files += sorted((root / "docs").glob("*.md"))
    known = set(files)
    for folder in ("chapters", "common", "tests"):
        files += [f for f in sorted((root / folder).rglob("*.md")) if f not in known]
    return [f for f in files if f.is_file()]


def source_files(root):
    """The C++ whose comments may cite equations."""
    files = []
    for folder in ("chapters", "common", "tests"):
        for ending in ("*.hpp", "*.cpp"):
            files += (root / folder).rglob(ending)
    return sorted(files)


def chapter_of(root, path):
    """The chapter number that a file belongs to, None for the others."""
    parts = path.relative_to(root).parts
    if parts[0] == "chapters" and len(parts) > 2 and parts[1][:2].isdigit():
        return int(parts[1][:2])
    return None


def page_id(root, path):
    """The Doxygen label of the page made from a Markdown file."""
    parts = path.relative_to(root).with_suffix("").parts
    if parts == ("README",):
        return "index"
    if parts[0] == "chapters" and len(parts) == 3 and parts[2] == "README":
        return "ch" + parts[1]
    if parts[0] == "chapters" and len(parts) == 3 and parts[2] == "in_depth":
        return "ch" + parts[1] + "_in_depth"
    if parts[0] == "docs" and len(parts) == 2:
        return parts[1]
    return re.sub(r"\W", "_", "_".join(parts))


# ------------------------------------------------------------------- the blocks

@dataclass
class Block:
    kind: str       # heading, paragraph, fence, math, snippet, comment, html, blank
    line: int       # number of its first line, from 1
    lines: list     # the lines as they are, delimiters included
    info: dict = field(default_factory=dict)

    @property
    def text(self):
        return "\n".join(self.lines)

    @property
    def body(self):
        """The lines between the delimiters of a fence."""
        return self.lines[1:-1]


FENCE = re.compile(r"^(\s*)(`{3,}|~{3,})\s*([^`]*)$")
HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*$")
SNIPPET_BEGIN = re.compile(r"^<!--\s*snippet:(.*)-->\s*$")
SNIPPET_END = re.compile(r"^<!--\s*/snippet\s*-->\s*$")
HTML_LINE = re.compile(r"^\s*</?(details|summary)\b", re.I)
TABLE_LINE = re.compile(r"^\s*\|.*\|\s*$")


def blocks(text, name="text"):
    """Cut a Markdown text into blocks; raises TextError where one has no end."""
    lines = text.split("\n")
    out, i = [], 0

    def fence_from(start):
        """Index behind the closing line of the fence that opens at start."""
        _, ticks, _ = FENCE.match(lines[start]).groups()
        j = start + 1
        while j < len(lines):
            if re.fullmatch(r"\s*" + re.escape(ticks[0]) + "{%d,}\\s*" % len(ticks), lines[j]):
                return j + 1
            j += 1
        raise TextError(f"{name}:{start + 1}: this fence is never closed.")

    while i < len(lines):
        line = lines[i]
        if not line.strip():
            out.append(Block("blank", i + 1, [line]))
            i += 1
        elif SNIPPET_BEGIN.match(line):
            end = i + 1
            while end < len(lines) and not SNIPPET_END.match(lines[end]):
                if SNIPPET_BEGIN.match(lines[end]) or HEADING.match(lines[end]):
                    break
                end = fence_from(end) if FENCE.match(lines[end]) else end + 1
            if end >= len(lines) or not SNIPPET_END.match(lines[end]):
                raise TextError(f"{name}:{i + 1}: this snippet has no end '<!-- /snippet -->'.")
            words = SNIPPET_BEGIN.match(line).group(1).split()
            if len(words) != 2:
                raise TextError(f"{name}:{i + 1}: a snippet is opened by "
                                "'<!-- snippet: FILE NAME -->', one file and one name.")
            out.append(Block("snippet", i + 1, lines[i:end + 1],
                             {"source": words[0], "name": words[1]}))
            i = end + 1
        elif SNIPPET_END.match(line):
            raise TextError(f"{name}:{i + 1}: '<!-- /snippet -->' without a beginning.")
        elif line.lstrip().startswith("<!--"):
            end = i
            while end < len(lines) and "-->" not in lines[end]:
                end += 1
            if end == len(lines):
                raise TextError(f"{name}:{i + 1}: this comment is never closed by '-->'.")
            out.append(Block("comment", i + 1, lines[i:end + 1]))
            i = end + 1
        elif FENCE.match(line):
            end = fence_from(i)
            indent, _, info = FENCE.match(line).groups()
            language = info.split()[0] if info.split() else ""
            out.append(Block("math" if language == "math" else "fence", i + 1, lines[i:end],
                             {"language": language, "indent": len(indent)}))
            i = end
        elif HEADING.match(line):
            hashes, title = HEADING.match(line).groups()
            out.append(Block("heading", i + 1, [line], {"level": len(hashes), "title": title}))
            i += 1
        elif HTML_LINE.match(line):
            out.append(Block("html", i + 1, [line]))
            i += 1
        else:
            start = i
            while (i < len(lines) and lines[i].strip() and not FENCE.match(lines[i])
                   and not HEADING.match(lines[i]) and not HTML_LINE.match(lines[i])
                   and not lines[i].lstrip().startswith("<!--")):
                i += 1
            kind = "table" if all(TABLE_LINE.match(l) for l in lines[start:i]) else "paragraph"
            out.append(Block(kind, start + 1, lines[start:i]))
    return out


def slug(title, seen=None):
    """GitHub's anchor of a heading; `seen` counts repeats within one file."""
    title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title)
    base = re.sub(r"[^\w\- ]", "", title.strip().lower()).replace(" ", "-")
    if seen is None:
        return base
    count = seen.get(base, 0)
    seen[base] = count + 1
    return base if count == 0 else f"{base}-{count}"


def anchors(text, name="text"):
    """All anchors of a text that a link may name."""
    seen = {}
    return [slug(b.info["title"], seen) for b in blocks(text, name) if b.kind == "heading"]


# ------------------------------------------------------------------- the tokens

@dataclass
class Token:
    kind: str       # code, math, image, cite, link, span, html, words
    text: str       # as written
    offset: int     # in the paragraph
    info: dict = field(default_factory=dict)


# A number of a sentence that can be dragged, or that follows (sentences.py).
SPAN = re.compile(r'<span data-(slide|value)="([^"<>]*)">([^<]*)</span>')

TOKEN = re.compile(
    r"(?P<span>" + SPAN.pattern.replace("(", "(?:") + r")"
    r"|(?P<rooms><picture>.*?</picture>)"
    r"|(?P<mathtick>(?<![\w$\\])\$`(?P<mt>[^`]+)`\$)"
    r"|(?P<code>(?<!`)(?P<ticks>`+)(?!`)(?P<inside>.*?)(?<!`)(?P=ticks)(?!`))"
    r"|(?P<escape>\\[\\`*_{}\[\]()#+\-.!$<>|~])"
    r"|(?P<math>(?<![\w$\\])\$(?![\s$])(?P<m>(?:\\.|[^$\n\\])*?(?:\\.|[^$\s\\]))\$(?![\w$]))"
    r"|(?P<linkedimage>\[!\[(?P<lalt>[^\]]*)\]\((?P<lsrc>[^()\s]+)[^()]*\)\]\((?P<ltarget>[^()\s]+)\))"
    r"|(?P<image>!\[(?P<alt>[^\]]*)\]\((?P<src>[^()\s]+)(?:\s+\"[^\"]*\")?\))"
    r"|(?P<cite>\[\[(?P<key>[^\]\s]+)\]\]\((?P<bib>[^()\s]*references\.bib)\))"
    r"|(?P<link>\[(?P<label>(?:[^\[\]`]|`[^`]*`)+)\]\((?P<target>[^()\s]+)(?:\s+\"[^\"]*\")?\))"
    r"|(?P<img><img\b[^>]*>)"
    r"|(?P<html></?[A-Za-z][A-Za-z0-9]*(?:\s[^<>]*)?/?>)",
    re.S)


def attribute(tag, name):
    found = re.search(rf"\b{name}\s*=\s*\"([^\"]*)\"", tag)
    return found.group(1) if found else None


def picture_of_rooms(markup):
    """A <picture>: what a light page shows (its <img>), a dark one, and a reader who wants nothing to move."""
    images = {kind: attribute(tag, "srcset") for tag in re.findall(r"<source\b[^>]*>", markup)
              for kind in ("dark", "reduce") if f": {kind})" in (attribute(tag, "media") or "")}
    tag = (re.findall(r"<img\b[^>]*>", markup) or [""])[0]
    return {"alt": attribute(tag, "alt") or "", "src": attribute(tag, "src") or "", "width": attribute(tag, "width"),
            "dark": images.get("dark") or "", "still": images.get("reduce") or ""}


def tokens(paragraph):
    """Cut the text of a paragraph (or table, or heading) into tokens."""
    out, last = [], 0

    def words(end):
        if end > last:
            out.append(Token("words", paragraph[last:end], last))

    for m in TOKEN.finditer(paragraph):
        words(m.start())
        at, text = m.start(), m.group(0)
        if m.group("mathtick"):
            out.append(Token("math", text, at, {"tex": m.group("mt"), "raw": True}))
        elif m.group("code"):
            out.append(Token("code", text, at, {"code": m.group("inside")}))
        elif m.group("escape"):
            out.append(Token("escape", text, at))
        elif m.group("math"):
            out.append(Token("math", text, at, {"tex": m.group("m"), "raw": False}))
        elif m.group("linkedimage"):
            out.append(Token("image", text, at, {
                "alt": m.group("lalt"), "src": m.group("lsrc"), "target": m.group("ltarget")}))
        elif m.group("image"):
            out.append(Token("image", text, at, {"alt": m.group("alt"), "src": m.group("src")}))
        elif m.group("rooms"):
            out.append(Token("image", text, at, picture_of_rooms(text)))
        elif m.group("img"):
            out.append(Token("image", text, at, {
                "alt": attribute(text, "alt") or "", "src": attribute(text, "src") or "",
                "width": attribute(text, "width")}))
        elif m.group("cite"):
            out.append(Token("cite", text, at, {"key": m.group("key"), "bib": m.group("bib")}))
        elif m.group("link"):
            out.append(Token("link", text, at, {
                "label": m.group("label"), "target": m.group("target")}))
        elif m.group("span"):
            out.append(Token("span", text, at))
        elif m.group("html"):
            out.append(Token("html", text, at))
        last = m.end()
    words(len(paragraph))
    return out


def lone_picture(block):
    """What is known of the picture that a paragraph is, or None: `![…](…)` on one line, or a <picture>."""
    if block.kind != "paragraph" or len(block.lines) != 1 and not block.lines[0].startswith("<picture>"):
        return None
    found = [t for t in tokens(block.text.strip()) if t.text.strip()]
    return found[0].info if len(found) == 1 and found[0].kind == "image" else None


# ----------------------------------------------------- equations, figures, keys

# An equation number in running text is alone in its parentheses. Not one: `f(1.5)` (a call),
# `](1.5)` (a link), `(1.5)*x` (an operator behind it), `(0.05)` and `(1.0)` (no chapter or
# equation is number zero), `(2.125)` (no chapter has a hundred equations).
EQUATION = re.compile(r"(?<![\w\])}])\(([1-9]\d?)\.([1-9]\d?)([a-z]?)\)"
                      r"(?!\s*[/^×·]\s*\w|\s*[+-]\s*\d|\s+\*\s|\*\w)")
FIGURE = re.compile(r"\bFigures?\s+([1-9]\d?)\.(0|[1-9]\d?)\b")  # N.0: what the small program draws
FIGURE_CAPTION = re.compile(r"^\*\*Figure ([1-9]\d?\.(?:0|[1-9]\d?))\.\*\*")
TAG = re.compile(r"\\tag\*?\s*\{([^}]*)\}")


def equation_tags(text, name="text"):
    """[(number, line)] of every \\tag{…} in the display maths of a text."""
    found = []
    for block in blocks(text, name):
        if block.kind == "math":
            for k, line in enumerate(block.lines):
                found += [(tag.strip(), block.line + k) for tag in TAG.findall(line)]
    return found


def figure_captions(text, name="text"):
    """[(number, line)] of every caption."""
    found = []
    for block in blocks(text, name):
        if block.kind == "paragraph":
            m = FIGURE_CAPTION.match(block.lines[0])
            if m:
                found.append((m.group(1), block.line))
    return found


def bib_keys(root):
    path = root / "docs" / "references.bib"
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    return re.findall(r"^\s*@(?!comment|string|preamble)\w+\s*\{\s*([^,\s]+)\s*,", text, re.M | re.I)


# ------------------------------------------------------------------ C++ sources

CPP = re.compile(
    r"(?P<raw>\b(?:u8|u|U|L)?R\"(?P<delim>[^()\\\s]{0,16})\(.*?\)(?P=delim)\")"
    r"|(?P<line>//(?:[^\n\\]|\\.)*)"
    r"|(?P<block>/\*.*?\*/)"
    r"|(?P<string>\"(?:\\.|[^\"\\\n])*\")"
    r"|(?P<char>(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+')",
    re.S)


def comments(source):
    """[(line, text)] of the comments of a C++ source, one entry per line."""
    found = []
    for m in CPP.finditer(source):
        if m.group("line") or m.group("block"):
            first = source.count("\n", 0, m.start()) + 1
            found += [(first + k, l) for k, l in enumerate(m.group(0).split("\n"))]
    return found


TEST_NAME = re.compile(
    r"\b(?:TEST_CASE|SCENARIO|SECTION|TEMPLATE_TEST_CASE\w*)\s*\(\s*((?:\"(?:\\.|[^\"\\])*\"\s*)+)")


def test_names(source):
    """[(line, name)] of the tests of a Catch2 source."""
    found = []
    for m in TEST_NAME.finditer(source):
        name = "".join(re.findall(r"\"((?:\\.|[^\"\\])*)\"", m.group(1)))
        name = re.sub(r"\\(.)", r"\1", name)
        found.append((source.count("\n", 0, m.start()) + 1, name))
    return found


# --------------------------------------------------------------------- snippets

MARKER = re.compile(r"^\s*//!\s*\[([\w-]+)\]\s*$")


CHANGED = "changed:"  # of a snippet's name: how a function differs from that of the small program before
CHANGES = "changes"  # a snippet's name: which functions and types a small program has beside the one before
GROWN_FROM = re.compile(r"^// Chapter \d+ in one file, grown from chapter (\d+):")
PART = re.compile(r"struct (?P<type>\w+) \{|(?!//|#|using )\S.*?\b(?P<function>\w+)\([^;]*(?:$|\{.*\}$)")


def function_code(path, name):
    """(first line number, last, lines) of the function or type `name` at the left edge of a source, with its comment."""
    lines = path.read_text(encoding="utf-8").split("\n")
    begin = re.compile(rf"(?!//|#)\S.*\b{re.escape(name)}\(.*[^;]$|struct {re.escape(name)} {{$")
    places = [k for k, l in enumerate(lines) if begin.match(l)]
    if len(places) != 1:
        raise TextError(f"{path.name} has {len(places) or 'no'} functions '{name}()' to quote, it needs one.")
    first = places[0]
    last = next((k for k in range(first, len(lines)) if lines[k] in ("}", "};")), None)
    if last is None:
        raise TextError(f"the function '{name}()' of {path.name} has no end '}}' at the left edge.")
    while first > 0 and lines[first - 1].startswith("//"):
        first -= 1
    return first + 1, last + 1, lines[first:last + 1]


def grown_from(path):
    """The small program that this one grew from."""
    match = GROWN_FROM.match(path.read_text(encoding="utf-8"))
    folder = match and chapters(path.parents[2]).get(int(match.group(1)))
    if not folder:
        raise TextError(f"{path.name} does not begin with the chapter that it grew from.")
    return folder / path.name


def parts_of(path):
    """{name: lines} of the functions and types of a small program above its main(), from the first to the last."""
    lines, parts = path.read_text(encoding="utf-8").split("\n"), {}
    for k, line in enumerate(lines):
        match = PART.match(line)
        if match and match["function"] == "main":
            return parts
        if match:
            end = k if line.endswith(("}", "};")) else next(j for j in range(k, len(lines)) if lines[j] in ("}", "};"))
            name = f"struct {match['type']}" if match["type"] else f"{match['function']}()"
            parts[name] = parts.get(name, []) + lines[k:end + 1]
    raise TextError(f"{path.name} has no main() at the left edge.")


def changes_code(path):
    """(first line number, last, lines): what is gone, new, or other in a small program beside the one that it grew from."""
    before, now = parts_of(grown_from(path)), parts_of(path)
    gone, new, other = [name for name in before if name not in now], [], []
    for name, code in now.items():
        if name not in before:
            new.append(f"{name} {len(code)}")
        elif code != before[name]:
            signs = [c[0] for c in difflib.ndiff(before[name], code)]
            counts = [f"{sign}{signs.count(mark)}" for mark, sign in (("+", "+"), ("-", "−")) if mark in signs]
            other.append(f"{name} {' '.join(counts)}")
    lines = []
    for sign, names in (("-", gone), ("+", new), (" ", other)):
        # non-breaking spaces, so that a name and its number stay on one line
        lines += [sign + line.replace("\xa0", " ") for line in
                  textwrap.wrap(", ".join(name.replace(" ", "\xa0") for name in names), 82)]
    return 1, len(path.read_text(encoding="utf-8").split("\n")), lines


def changed_code(path, name):
    """(first line number, last, lines) of what a small program changed in the function of the one that it grew from."""
    first, last, code = function_code(path, name)
    before = function_code(grown_from(path), name)[2]
    lines = [(c[0] + c[2:]).rstrip() for c in difflib.ndiff(before, code) if not c.startswith("?")]
    changes = [k for k, l in enumerate(lines) if l[:1] in ("+", "-")]
    shown = [k == 0 or any(abs(k - c) <= 2 for c in changes) for k in range(len(lines))]
    # of what stays, two lines beside each change
    return first, last, [l if shown[k] else " …" for k, l in enumerate(lines) if shown[k] or shown[k - 1]]


def snippet_language(source, name):
    """What a quoted piece is written in."""
    if name == CHANGES or name.startswith(CHANGED):
        return "diff"
    return "cpp" if source.endswith((".hpp", ".cpp", ".h")) else ""


def snippet_code(path, name):
    """(first line number, last, lines) between the two markers //! [name] of a source; of the function whose name ends
    with () and its comment; or, as `changed:step()`, of how it differs in the small program before; or, as `changes`,
    which functions differ there."""
    if not path.is_file():
        raise TextError(f"there is no file {path.name} to take the snippet '{name}' from.")
    if name == CHANGES:
        return changes_code(path)
    if name.endswith("()"):
        if name.startswith(CHANGED):
            return changed_code(path, name[len(CHANGED):-2])
        return function_code(path, name[:-2])
    lines = path.read_text(encoding="utf-8").split("\n")
    places = [k for k, l in enumerate(lines) if (m := MARKER.match(l)) and m.group(1) == name]
    if not places:
        raise TextError(f"{path.name} has no markers '//! [{name}]'.")
    if len(places) != 2:
        times = "once" if len(places) == 1 else f"{len(places)} times"
        raise TextError(f"the marker '//! [{name}]' occurs {times} in {path.name}, "
                        "it needs one beginning and one end.")
    inside = [(k + 1, l) for k, l in enumerate(lines) if places[0] < k < places[1]
              and not MARKER.match(l)]
    while inside and not inside[0][1].strip():
        inside.pop(0)
    while inside and not inside[-1][1].strip():
        inside.pop()
    if not inside:
        raise TextError(f"the snippet '{name}' of {path.name} is empty.")
    margin = min(len(l) - len(l.lstrip(" ")) for _, l in inside if l.strip())
    return inside[0][0], inside[-1][0], [l[margin:].rstrip() for _, l in inside]
