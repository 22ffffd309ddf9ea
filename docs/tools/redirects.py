#!/usr/bin/env python3
"""Write a small page at each old address of a chapter, which leads on to where its text is now.

    docs/tools/redirects.py HTML_FOLDER      into the finished site, by the list docs/redirects.txt
    docs/tools/redirects.py --check          only says what is wrong with the list

A line of the list is the old name of a chapter's folder and its present one: `17_engine 19_engine`. Both pages of the chapter
get one, main road and in depth; what had a page in depth and has none now leads to the main road.
"""
import argparse
import pathlib
import re

from booktext import ROOT, TextError, book_folder, run_tool

LIST = pathlib.PurePosixPath("docs/redirects.txt")
PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="robots" content="noindex">
<meta http-equiv="refresh" content="0; url={target}">
<link rel="canonical" href="{target}">
<title>This page has another address</title>
</head>
<body><p>This page has another address: <a href="{target}">{words}</a>.</p></body>
</html>
"""


def moved(text):
    """[(old, new)] of the list's lines."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        words = line.split()
        if len(words) != 2 or not all(re.fullmatch(r"\d\d_[a-z_]+", word) for word in words):
            raise TextError(f"{LIST}:{number}: '{line}' is not the old and the present name of a chapter's folder, as '17_engine 19_engine'")
        found.append((words[0], words[1]))
    return found


def read_list(root):
    """The list, if each old name is listed once and no folder of today, and each new one is a chapter."""
    found, seen = moved((root / LIST).read_text(encoding="utf-8")), set()
    for old, new in found:
        if old in seen:
            raise TextError(f"{LIST} has {old} twice; an old address leads to one page")
        seen.add(old)
        if (root / "chapters" / old).exists():
            raise TextError(f"{LIST} has {old}, which is a chapter of today; its address can't lead elsewhere")
        if not (root / "chapters" / new / "README.md").is_file():
            raise TextError(f"{LIST} leads from {old} to {new}, and there is no such chapter")
    return found


def followed(text, names):
    """The list after chapters moved: what led to one leads to its new name, and each old name leads on.

    names: {old name of a folder: new one}
    """
    lines = []
    for line in text.splitlines():
        words = line.split()
        if len(words) == 2 and not line.startswith("#"):
            new = names.get(words[1], words[1])
            if words[0] in names.values():
                continue  # a chapter has this address again
            line = f"{words[0]} {new}"
        lines.append(line)
    here = {line.split()[0] for line in lines if line.strip() and not line.startswith("#")} | set(names.values())
    lines += [f"{old} {new}" for old, new in sorted(names.items()) if old not in here]
    return "\n".join(lines) + "\n"


def write(root, folder):
    """Returns how many pages were written."""
    count = 0
    for old, new in read_list(root):
        for part, words in (("", ""), ("_in_depth", ", in depth")):
            target = f"ch{new}{part}.html"
            if not (folder / target).is_file():
                target, words = f"ch{new}.html", ""
            if not (folder / target).is_file():
                raise TextError(f"{folder} has no {target}, to which {old} should lead")
            title = new[3:].replace("_", " ")
            (folder / f"ch{old}{part}.html").write_text(
                PAGE.format(target=target, words=f"chapter {int(new[:2])}, {title}{words}"), encoding="utf-8")
            count += 1
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("html_folder", type=pathlib.Path, nargs="?", help="the site")
    parser.add_argument("--check", action="store_true", help="only look at the list")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the book's folder")
    options = parser.parse_args()
    root = book_folder(options.root)
    if options.check == (options.html_folder is not None):
        raise TextError("either a folder of the site or --check")
    if options.check:
        read_list(root)
        return 0
    if not options.html_folder.is_dir():
        raise TextError(f"{options.html_folder} is no folder")
    write(root, options.html_folder)
    return 0


if __name__ == "__main__":
    run_tool(main)
