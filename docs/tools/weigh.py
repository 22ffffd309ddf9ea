#!/usr/bin/env python3
"""What the pages of a site weigh: with their own scripts, styles and pictures, as a host sends them (gzip).

    docs/tools/weigh.py HTML_FOLDER

A page's code for its demos is a column of its own: it is loaded when a demo is started. The search index and the
pages of sources are not listed.
"""
import argparse
import gzip
import pathlib
import re
import urllib.parse

from booktext import TextError, run_tool

FETCHED = re.compile(r'<(?:script|img|link)\b[^>]*?\b(?:src|href)="([^"#?]+)"')
PACKED = {".html", ".js", ".css", ".svg"}


def weight(path, known):
    if path not in known:
        content = path.read_bytes() if path.is_file() else b""
        known[path] = len(gzip.compress(content, 6)) if path.suffix in PACKED else len(content)
    return known[path]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("html_folder", type=pathlib.Path, help="the site")
    folder = parser.parse_args().html_folder
    if not (folder / "index.html").is_file():
        raise TextError(f"{folder} is no site: it has no index.html")
    known = {}
    print(f"{'page':44}{'page':>8}{'with all':>10}{'demos':>8}   kB in gzip")
    for page in sorted(folder.glob("*.html")):
        if not re.fullmatch(r"index|ch\d\d_\w+|results|stability|stability_in_depth|race|primer|notation", page.stem):
            continue
        text = page.read_text(encoding="utf-8")
        parts = {folder / urllib.parse.unquote(a) for a in FETCHED.findall(text) if not re.match(r"[a-z]+:", a)}
        parts = {part for part in parts if part.suffix != ".html"}
        names = set(re.findall(r'data-program="([^"]+)"', text)) | ({"race", "box2d3_wasm"} if 'class="demo race"' in text else set())
        demos = {folder / "demos" / f"{name}.js" for name in names}
        own = weight(page, known)
        print(f"{page.name:44}{own / 1e3:8.1f}{(own + sum(weight(p, known) for p in parts)) / 1e3:10.1f}"
              f"{sum(weight(p, known) for p in demos) / 1e3:8.1f}")
    files = [file for file in folder.rglob("*") if file.is_file()]
    print(f"the whole site: {len(files)} files, {sum(file.stat().st_size for file in files) / 1e6:.1f} MB on disk, "
          f"{sum(weight(file, known) for file in files) / 1e6:.1f} MB in gzip")


if __name__ == "__main__":
    run_tool(main)
