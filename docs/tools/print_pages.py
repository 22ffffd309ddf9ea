#!/usr/bin/env python3
"""Put pages of the finished site into one for paper: HTML_FOLDER/print.html, which docs/web/print.mjs prints.

    docs/tools/print_pages.py HTML_FOLDER        the whole book, with a title, and a table of contents
    docs/tools/print_pages.py HTML_FOLDER 4      chapter 4 with what goes deeper

Each page begins a new sheet, and its title is the running head. Links between the pages become links inside; links to
what is not printed keep their words. Solutions are unfolded, and what only moves on a screen is left out.
"""
import argparse
import html
import pathlib
import re

from booktext import ROOT, TextError, chapter_texts, chapters, page_id, run_tool

BEFORE = ["primer", "map"]
AFTER = ["notation", "conventions", "results", "stability", "stability_in_depth", "citelist"]
CONTENTS = re.compile(r'<div class="contents">(.*)</div><!-- contents -->', re.S)
TITLE = re.compile(r'<div class="title">(.*?)</div>', re.S)


def pages_of(folder, chapter):
    """The names of the pages, in the order of the book."""
    folders = chapters(ROOT)
    if chapter is not None and chapter not in folders:
        raise TextError(f"there is no chapter {chapter}; there are 1 to {max(folders)}")
    names = [page_id(ROOT, text) for number in ([chapter] if chapter else folders) for text in chapter_texts(folders[number])]
    names = names if chapter else BEFORE + names + AFTER
    for name in names:
        if not (folder / f"{name}.html").is_file():
            raise TextError(f"{folder} has no page {name}.html: ./book docs builds the site")
    return names


def plain(markup):
    return " ".join(html.unescape(re.sub(r"<[^>]*>", "", markup)).split())


def inside(name, page, printed):
    """(title, content, sections) of a page, its anchors and links those of the one document."""
    content = CONTENTS.search(page).group(1)
    content = re.sub(r"<script\b.*?</script>|<link\b[^>]*>|<button\b.*?</button>", "", content, flags=re.S)
    content = re.sub(r'<picture class="room-dark">.*?</picture>', "", content, flags=re.S)
    content = re.sub(r'<div class="demo-begin">.*?</div>', "", content, flags=re.S)
    content = re.sub(r'<p class="demo-says">.*?</p>', "", content, flags=re.S)
    content = content.replace("<details>", '<details open="open">').replace(' loading="lazy"', "")
    # The road signs between chapters are for a screen.
    content = re.sub(r'<nav class="ways-on".*?</nav>', "", content, flags=re.S)
    content = re.sub(r"(</?h)([1-5])\b", lambda m: f"{m.group(1)}{int(m.group(2)) + 1}", content)

    def link(m):
        target, _, anchor = html.unescape(m.group(2)).partition("#")
        page_name = target[:-len(".html")] if target.endswith(".html") else name if not target else None
        if re.match(r"[a-z]+:", target):
            return m.group(0)
        if page_name not in printed:
            return m.group(4)
        return f'<a{m.group(1)}href="#{anchor or "page_" + page_name}"{m.group(3)}>{m.group(4)}</a>'

    content = re.sub(r'<a\b([^>]*?)href="([^"]*)"([^>]*)>(.*?)</a>', link, content, flags=re.S)
    found = re.findall(r'<h2[^>]*>\s*<a class="anchor" id="([^"]*)"></a>(.*?)</h2>', content, re.S)
    return plain(TITLE.search(page).group(1)), content, [(anchor, plain(words)) for anchor, words in found]


def running_head(k, title):
    words = title.replace("\\", "\\\\").replace('"', '\\"')
    return f'@page sheet{k} {{ @top-center {{ content: "{words}"; }} }} .sheet{k} {{ page: sheet{k}; }}'


def document(folder, chapter):
    names = pages_of(folder, chapter)
    sheets, heads, table = [], [], []
    for k, name in enumerate(names):
        title, content, sections = inside(name, (folder / f"{name}.html").read_text(encoding="utf-8"), set(names))
        heads.append(running_head(k, title))
        sheets.append(f'<section class="sheet sheet{k}"><h1 id="page_{name}">{html.escape(title)}</h1>{content}</section>')
        deep = name.endswith("_in_depth")
        table.append(f'<li class="{"deep" if deep else "page"}"><a href="#page_{name}">{html.escape(title)}</a><i></i>'
                     f'<b data-page="page_{name}"></b></li>')
        if name.startswith("ch") and not deep:
            table += [f'<li class="section"><a href="#{anchor}">{html.escape(words)}</a><i></i><b data-page="{anchor}"></b></li>'
                      for anchor, words in sections]
    front = ""
    if not chapter:
        front = ('<section class="title"><h1>Rigid bodies, step by step</h1><p>A book that runs</p>'
                 '<img src="pictures/docs/front/still.svg" alt="A ball on a chain swings into a tower of bricks"/></section>'
                 f'<section class="table"><h1>Contents</h1><ul>{"".join(table)}</ul></section>')
    what = "Rigid bodies, step by step" if not chapter else plain(TITLE.search((folder / f"{names[0]}.html").read_text(encoding="utf-8")).group(1))
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<title>{html.escape(what)}</title>
<script src="book.js"></script>
<script id="MathJax-script" src="tex-svg.js" async="async"></script>
<link href="print.css" rel="stylesheet"/>
<style>{" ".join(heads)}</style>
</head>
<body>
{front}
{"".join(sheets)}
</body>
</html>
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("html_folder", type=pathlib.Path, help="the finished site")
    parser.add_argument("chapter", type=int, nargs="?", help="its number; without, the whole book")
    options = parser.parse_args()
    (options.html_folder / "print.html").write_text(document(options.html_folder, options.chapter), encoding="utf-8")


if __name__ == "__main__":
    run_tool(main)
