#!/usr/bin/env python3
"""Where the site is published: fills the front page's door to it, between <!-- play --> and <!-- /play -->.

    docs/tools/site_address.py https://somebody.github.io/rigid/
    docs/tools/site_address.py none       nowhere yet: the door says how to make the site here
"""
import argparse
import pathlib
import re

from booktext import ROOT, TextError, book_folder, run_tool

DOOR = re.compile(r"(<!-- play -->\n).*?(\n<!-- /play -->)", re.S)
NOWHERE = ("**[Play](#put-it-on-the-web)**: each chapter's programs run in its page, with sliders and something to pull at. "
           "Make these pages by\n"
           "`./book web --publish site`, then open `site/index.html`.")


def door(address):
    if address == "none":
        return NOWHERE
    if not re.fullmatch(r"https?://[^\s()<>\"]+", address):
        raise TextError(f"the address of the site is '{address}'; it must be https://… without blanks and brackets, or none")
    return f"**[Play]({address})**: each chapter's programs run in its page, with sliders and something to pull at. Nothing to install."


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("address", help="https://…, or none")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the book's folder")
    options = parser.parse_args()
    page = book_folder(options.root) / "README.md"
    text = page.read_text(encoding="utf-8")
    words = door(options.address)
    new, count = DOOR.subn(lambda m: m.group(1) + words + m.group(2), text)
    if count != 1:
        raise TextError(f"{page} has {count} places between <!-- play --> and <!-- /play -->; it must have one")
    if new != text:
        page.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    run_tool(main)
