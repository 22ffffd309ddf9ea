#!/usr/bin/env python3
"""Put in what Doxygen could not know, after it has written the site.

    docs/tools/finish_html.py HTML_FOLDER TAG_FILE

  book:common/bodies.hpp#12   becomes the address of that file's page (with a line: of its
                              source); where the site has no such page the words stay
  (4.7) in a comment of code  becomes a link to the equation
  pictures/chapters/…         are copied from the book
  [1] for a citation          becomes its key, as in the texts
  packed words of the filter  are unpacked; a formula and its comma stay on one line
  chapters on the front page  are cards; they show the first frame of their first demo, where the demos were built, and
                              run it under the pointer (docs/web/cards.js)
  Play, Read and Use          are three doors beside each other
  the links to the neighbours are bars above and below a chapter
  the sidebar                 has each chapter before what goes deeper
  Doxygen 1.9.4's own faults  a link #nested-classes without the part it names; a script
                              whose variable starts with a digit, as 01_euler_integration.cpp does
"""
import argparse
import html
import json
import os
import pathlib
import re
import shutil
import xml.etree.ElementTree as xml

from booktext import EQUATION, ROOT, TextError, chapter_texts, chapters, equation_tags, page_id, run_tool
from demos import demos_of
from doxygen_filter import label, unpacked


def addresses(tag_file, root):
    """{path in the book: page of the site} from Doxygen's tag file."""
    found = {}
    for compound in xml.parse(tag_file).getroot().iter("compound"):
        if compound.get("kind") == "file":
            path, name = compound.findtext("path", ""), compound.findtext("name", "")
            page = compound.findtext("filename", "")
            full = os.path.join(path, name)
            if full.endswith(".md"):
                continue
            if os.path.isabs(full):
                full = os.path.relpath(full, root)
            found[os.path.normpath(full)] = page if page.endswith(".html") else page + ".html"
        elif compound.get("kind") == "dir":
            path = compound.findtext("path", "")
            path = os.path.relpath(path, root) if os.path.isabs(path) else os.path.normpath(path)
            found[path] = compound.findtext("filename", "")
    return found


def equation_pages(root):
    found = {}
    for folder in chapters(root).values():
        for text in chapter_texts(folder):
            page = page_id(root, text) + ".html"
            for number, _ in equation_tags(text.read_text(encoding="utf-8")):
                found[number] = f"{page}#eq_{label(number)}"
    return found


def in_order(sidebar):
    """Doxygen sorts in_depth.md before README.md: the main road of a chapter comes first."""
    entry = r'(    \[ "Chapter %s[^\n]*\n(?:(?!    \[ ")[^\n]*\n)*)'
    return re.sub(entry % r"(?P<n>\d+) in depth" + entry % r"(?P=n)\. ", r"\3\1", sidebar)


def places_in_order(index, deeper):
    """The same in the table that says at which place of the sidebar a page is."""
    def moved(m):
        deep = m.group(1).endswith("_in_depth")
        name = m.group(1)[:-len("_in_depth")] if deep else m.group(1)
        step = (1 if deep else -1) if name in deeper else 0
        return f'"{m.group(1)}.html{m.group(2)}":[{int(m.group(3)) + step}'

    return re.sub(r'"(ch\d\d_\w+)\.html((?:#[^"]*)?)":\[(\d+)', moved, index)


def thumbnails(page, root):
    """The front page with a demo's still picture in place of the figure of each chapter that has a demo."""
    stills = root / "build/docs/demos/demos.json"
    told = json.loads(stills.read_text(encoding="utf-8")) if stills.is_file() else {}

    def frame(m):
        text = root / "chapters" / m.group(1) / "README.md"
        still = next((demo["still"] for demo in demos_of(root, text) if demo["still"] in told), None) if text.is_file() else None
        if not still:
            return m.group(0)
        return f'<img src="demos/{still}" alt="First frame of a demo: {html.escape(told[still]["summary"])}"'

    return re.sub(r'<img src="pictures/chapters/([\w-]+)/figures/[^"]*" alt="[^"]*"', frame, page)


ROW = re.compile(r'<tr class="markdownTableRow[^>]*>\s*<td[^>]*>(<img\b[^>]*>)\s*</td><td[^>]*>(<a\b[^>]*>.*?</a>)\s*</td><td[^>]*>(.*?)</td>\s*</tr>', re.S)


def cards(page, root):
    """The front page with the tables of the chapters as cards."""
    moves = False

    def card(m):
        nonlocal moves
        picture, link, words = m.groups()
        still, data = re.search(r'src="demos/([^"]*)"', picture), ""
        text = root / "chapters" / re.search(r'href="ch([\w-]+)\.html', link)[1] / "README.md"
        demo = still and next((one for one in demos_of(root, text) if one["still"] == still[1]), None)
        if demo:
            moves = True
            settings = " ".join(f"{name}={value:.17g}" for name, value in demo["settings"].items())
            data = "".join(f' data-{name}="{html.escape(value)}"' for name, value in (
                ("program", demo["program"]), ("scene", demo["scene"]), ("methods", " ".join(demo["methods"])), ("settings", settings)))
        return f'<li class="card"{data}><div class="card-picture">{picture}</div>{link}<p>{words.strip()}</p></li>'

    def table(m):
        rows = ROW.findall(m.group(0))
        return f'<ul class="cards">{"".join(card(one) for one in ROW.finditer(m.group(0)))}</ul>' if rows else m.group(0)

    page = re.sub(r'<table class="markdownTable">.*?</table>', table, page, flags=re.S)
    return page.replace("</head>", '<script src="cards.js" defer="defer"></script>\n</head>', 1) if moves else page


DOORS = re.compile(r'((?:<p\s*><b><a class="el" href="[^"]*">(?:Play|Read|Use)</a></b>:.*?</p>\s*){3})', re.S)


def doors(page):
    """Play, Read and Use beside each other. Whoever is on the site plays here: at the film, where the demos were built."""
    def three(m):
        ways = m.group(1)
        if 'class="demo"' in page[:m.start()]:
            ways = re.sub(r'<a class="el" href="[^"]*">Play</a></b>:.*?</p>',
                          '<a class="el" href="ch01_euler_integration.html">Play</a></b>: Pull at the film above. '
                          "Each chapter's programs run in its page, with sliders and something to pull at.</p>", ways, count=1, flags=re.S)
        # as headings: without the colon of a sentence
        ways = re.sub(r"</b>: (\w)", lambda letter: f"</b> {letter.group(1).upper()}", ways)
        return f'<div class="doors">{ways}</div>'

    return DOORS.sub(three, page, count=1)


WAYS_ON = re.compile(r'<p\s*>((?:<a class="anchor" id="[^"]*"></a>)?)\s*(<a class="el" href="index\.html">Contents</a>(?: · <a\b[^>]*>[^<]*</a>)+)\s*</p>')


def ways_on(page):
    """The line of links to the neighbours as a bar."""
    def bar(m):
        links = m.group(2).replace(" · ", "")
        for word, rel in (("Back: ", "prev"), ("Next: ", "next")):
            links = re.sub(rf'<a class="el"([^>]*)>{word}', rf'<a class="el" rel="{rel}"\1>', links)
        return f'{m.group(1)}<nav class="ways-on" aria-label="Chapters">{links}</nav>'
    return WAYS_ON.sub(bar, page)


def finish(folder, tag_file, root):
    pages, equations = addresses(tag_file, root), equation_pages(root)
    pictures = set()

    def inner(text):
        return re.sub(r"</?a\b[^>]*>", "", text)

    def book_link(m):
        file, _, line = html.unescape(m.group(2)).partition("#")
        page = pages.get(os.path.normpath(file))
        if page and line:
            source = page[:-len(".html")] + "_source.html"
            page = f"{source}#l{int(line):05d}" if (folder / source).is_file() else page
        return f'<a{m.group(1)}href="{page}"{m.group(3)}>{inner(m.group(4))}</a>' if page else inner(m.group(4))

    def comment(m):
        def link(e):
            address = equations.get(e.group(0)[1:-1])
            return f'<a class="equation" href="{address}">{e.group(0)}</a>' if address else e.group(0)
        return m.group(1) + EQUATION.sub(link, m.group(2)) + m.group(3)

    for page in sorted(folder.glob("*.html")):
        old = page.read_text(encoding="utf-8")
        new = unpacked(old)
        new = re.sub(r'<a([^>]*?)href="book:([^"]*)"([^>]*)>(.*?)<!--/book--></a>', book_link, new, flags=re.S)
        new = re.sub(r'(<span class="comment">)([^<]*)(</span>)', comment, new)
        new = re.sub(r"\( (?=\\\()", "(", new)  # Doxygen sets formulas of doc comments apart
        new = re.sub(r'(CITEREF_([\w-]+)"[^>]*>(?:</a>)?)\[\d+\]', r"\1[\2]", new)
        new = re.sub(r"<p\s*>(<a class=\"anchor\" id=\"[^\"]*\"></a>\s*)</p>", r'<p class="anchorline">\1</p>', new)

        new = re.sub(r"(?<![\w])(\(?\\\((?:(?!\\[()]).)+\\\)(?:&zwnj;)?[.,;:!?)’]+)", r'<span class="nobreak">\1</span>', new)
        if 'id="nested-classes"' not in new and 'name="nested-classes"' not in new:
            new = re.sub(r'<a href="#nested-classes">[^<]*</a>(?:\s*&#124;\s*)?', "", new)
        if page.name == "index.html":
            new = doors(cards(thumbnails(new, root), root))
        new = ways_on(new)
        pictures.update(html.unescape(p) for p in re.findall(r'src(?:set)?="pictures/([^"]+)"', new))
        if new != old:
            page.write_text(new, encoding="utf-8")
    sidebar = folder / "navtreedata.js"
    if sidebar.is_file():
        old = sidebar.read_text(encoding="utf-8")
        new = in_order(old)
        if new != old:
            sidebar.write_text(new, encoding="utf-8")
            deeper = {page.name[:-len("_in_depth.html")] for page in folder.glob("ch*_in_depth.html")}
            for index in folder.glob("navtreeindex*.js"):
                index.write_text(places_in_order(index.read_text(encoding="utf-8"), deeper), encoding="utf-8")
    digits = [f for f in folder.glob("[0-9]*.js")]
    for script in folder.glob("*.js"):
        if digits and script.name not in {f.name for f in digits}:
            old = script.read_text(encoding="utf-8", errors="surrogateescape")
            new = re.sub(r', "[0-9]\w*" \]', ", null ]", old) if script.name != "tex-svg.js" else old
            if new != old:
                script.write_text(new, encoding="utf-8", errors="surrogateescape")
    for script in digits:
        script.unlink()
    for picture in sorted(pictures):
        if (root / picture).is_file():
            (folder / "pictures" / picture).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(root / picture, folder / "pictures" / picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("html_folder", type=pathlib.Path, help="what Doxygen wrote")
    parser.add_argument("tag_file", type=pathlib.Path, help="Doxygen's list of pages")
    options = parser.parse_args()
    if not (options.html_folder / "index.html").is_file():
        raise TextError(f"{options.html_folder} is no site: it has no index.html")
    finish(options.html_folder, options.tag_file, ROOT)


if __name__ == "__main__":
    run_tool(main)
