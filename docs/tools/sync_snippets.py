#!/usr/bin/env python3
"""Copy the code that a text quotes from the source that is compiled.

    docs/tools/sync_snippets.py            fill in the blocks of all texts
    docs/tools/sync_snippets.py --check    change nothing, exit 1 if any is stale

A block is `<!-- snippet: FILE NAME -->` to `<!-- /snippet -->`, each on its own
line; FILE is relative to the text. The code lies in FILE between two lines
`//! [NAME]`. With `()` behind it, NAME is that of a function, which needs no such lines;
`changed:step()` shows how it differs in the small program that FILE grew from, and `changes` which functions and types do.
"""
import argparse
import pathlib
import sys

from booktext import ROOT, TextError, blocks, book_folder, markdown_files, run_tool, snippet_code, \
    snippet_language


def filled(root, path):
    """(new text, [names of the snippets that changed], [faults]) of one Markdown file."""
    where = path.relative_to(root)
    text = path.read_text(encoding="utf-8")
    out, changed, faults = [], [], []
    try:
        parts = blocks(text, str(where))
    except TextError as fault:
        return text, [], [str(fault)]
    for block in parts:
        if block.kind != "snippet":
            out += block.lines
            continue
        source, name = block.info["source"], block.info["name"]
        try:
            _, _, code = snippet_code((path.parent / source).resolve(), name)
        except TextError as fault:
            faults.append(f"{where}:{block.line}: {fault}")
            out += block.lines
            continue
        ticks = "````" if any(l.lstrip().startswith("```") for l in code) else "```"
        new = [block.lines[0], ticks + snippet_language(source, name), *code, ticks, block.lines[-1]]
        if new != block.lines:
            changed.append((block.line, source, name))
        out += new
    return "\n".join(out), changed, faults


def run(root, check):
    """All texts; returns the sentences to print and whether all is well."""
    said, well = [], True
    for path in markdown_files(root):
        where = path.relative_to(root)
        new, changed, faults = filled(root, path)
        said += faults
        well = well and not faults
        for line, source, name in changed:
            if check:
                said.append(f"{where}:{line}: the snippet '{name}' of {source} is stale or empty; "
                            "run docs/tools/sync_snippets.py.")
                well = False
            else:
                said.append(f"{where}:{line}: updated '{name}' from {source}.")
        if changed and not check:
            path.write_text(new, encoding="utf-8")
    return said, well


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--check", action="store_true", help="change nothing, fail if any is stale")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the book's folder")
    options = parser.parse_args()
    said, well = run(book_folder(options.root), options.check)
    for sentence in said:
        print(sentence, file=sys.stdout if well else sys.stderr)
    return 0 if well else 1


if __name__ == "__main__":
    run_tool(main)
