#!/usr/bin/env python3
"""Check the finished site: it is whole, and it asks for nothing from elsewhere.

    docs/tools/check_html.py HTML_FOLDER

Faults: a link or an anchor that leads nowhere, a missing picture, script or style
sheet, anything that a browser would fetch from another place, and raw \\f[, $…$,
\\cite and the like in the words of a page. Exit code 1 if there is any.
"""
import argparse
import html.parser
import pathlib
import re
import sys
import urllib.parse

from booktext import TextError, run_tool

FETCHED = {("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("video", "src"),
           ("audio", "src"), ("object", "data"), ("embed", "src"), ("image", "href")}
LOADING_RELS = {"stylesheet", "icon", "preload", "prefetch", "preconnect", "dns-prefetch", "modulepreload"}
RAW = [(re.compile(p), what) for p, what in (
    (r"\\f[\[\]${}]|packq[0-9a-f]{2}|href=.book:", "a raw mark of the filter"),
    (r"(?<![\w$])\$(?=[^\s$\d])[^$\n]*[^\s$]\$(?![\w$])", "maths that was not turned into maths"),
    (r"\\(cite|ref|subpage|anchor|snippet|htmlonly|endhtmlonly|page|param|return|f)\b", "a raw command"),
    (r"\]\([^)\s]*\.(md|svg|png|bib)", "a raw link"),
    (r"```|<!--\s*/?snippet", "a raw fence or snippet mark"))]
MATHS = re.compile(r"\\\(.*?\\\)|\\\[.*?\\\]", re.S)


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.ids, self.links, self.fetched, self.words = set(), [], [], []
        self.skip = 0
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        line = self.getpos()[0]
        for name in ("id", "name"):
            if attrs.get(name):
                self.ids.add(attrs[name])
        if tag in ("a", "area") and attrs.get("href"):
            self.links.append((line, attrs["href"]))
        if tag == "link" and attrs.get("href"):
            if LOADING_RELS & set((attrs.get("rel") or "").lower().split()):
                self.fetched.append((line, attrs["href"]))
        for name, value in attrs.items():
            if (tag, name) in FETCHED and value:
                self.fetched.append((line, value))
            if name == "srcset" and value:
                self.fetched += [(line, part.split()[0]) for part in value.split(",") if part.split()]
            if name == "style" and value:
                self.fetched += [(line, u) for u in re.findall(r"url\(['\"]?([^'\")]+)", value)]
        if tag == "img" and not (attrs.get("alt") or "").strip():
            self.words.append((line, None))
        if tag in ("script", "style", "pre", "code", "tt") or "fragment" in (attrs.get("class") or "").split():
            self.skip += tag in ("script", "style", "pre", "code", "tt")
        if "fragment" in (attrs.get("class") or "").split() and tag == "div":
            self.fragment = True

    def handle_endtag(self, tag):
        if tag in ("script", "style", "pre", "code", "tt"):
            self.skip = max(0, self.skip - 1)

    def handle_data(self, data):
        if not self.skip:
            self.words.append((self.getpos()[0], data))


def check(folder):
    faults = []
    pages = {}
    for file in sorted(folder.rglob("*.html")):
        text = file.read_text(encoding="utf-8", errors="replace")
        # a line of quoted code is a <div class="line">: code, not words
        pages[file] = Page(re.sub(r'<div class="line">.*?</div>', lambda m: re.sub(r">[^<]+<", "><", m.group(0)),
                                  text, flags=re.S))
    def outside(address):
        return re.match(r"^(?:[a-z][a-z0-9+.-]*:)?//", address, re.I)

    for file, page in pages.items():
        name = file.relative_to(folder)
        for line, address in page.links:
            if outside(address) or re.match(r"^(mailto|javascript|data):", address):
                continue
            path, _, anchor = address.partition("#")
            target = (file.parent / urllib.parse.unquote(path)).resolve() if path else file
            if not target.exists():
                faults.append(f"{name}:{line}: the link {address} leads to nothing.")
            elif anchor and target in pages and urllib.parse.unquote(anchor) not in pages[target].ids:
                faults.append(f"{name}:{line}: {target.name} has no anchor #{anchor}.")
        for line, address in page.fetched:
            if address.startswith(("data:", "javascript:")):
                continue
            if outside(address):
                faults.append(f"{name}:{line}: {address} would be fetched from elsewhere.")
            elif not (file.parent / urllib.parse.unquote(re.split(r"[?#]", address)[0])).exists():
                faults.append(f"{name}:{line}: {address} is missing.")
        for line, words in page.words:
            if words is None:
                faults.append(f"{name}:{line}: a picture without alternative text.")
                continue
            words = MATHS.sub("", words)
            for raw, what in RAW:
                m = raw.search(words)
                if m:
                    around = " ".join(words[max(0, m.start() - 20):m.end() + 20].split())
                    faults.append(f"{name}:{line + words.count(chr(10), 0, m.start())}: {what}: «{around}».")
    for sheet in sorted(folder.glob("*.css")):
        text = re.sub(r"/\*.*?\*/", "", sheet.read_text(encoding="utf-8"), flags=re.S)
        for address in re.findall(r"url\(\s*['\"]?([^'\")]+)", text) + re.findall(r"@import\s+['\"]([^'\"]+)", text):
            if outside(address):
                faults.append(f"{sheet.name}: {address} would be fetched from elsewhere.")
    if not (folder / "index.html").is_file():
        faults.append("there is no index.html.")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("html_folder", type=pathlib.Path, help="the site")
    folder = parser.parse_args().html_folder.resolve()
    if not folder.is_dir():
        raise TextError(f"{folder} is no folder")
    found = check(folder)
    for fault in found:
        print(fault, file=sys.stderr)
    if found:
        print(f"{len(found)} fault{'s' if len(found) > 1 else ''} in the site.", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    run_tool(main)
