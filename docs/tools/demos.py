#!/usr/bin/env python3
"""The demos that the texts name, as JSON for docs/web/stills.mjs.

    <!-- demo: column, gauss_seidel sor, rows=20, break five sweeps a step: gauss_seidel max_sweeps=5 -->

First the scene (of the program of the text's own chapter; elsewhere 04_pgs/column), then, each if there is any: the
methods side by side; the settings; what turns the idea off (its name, a colon, methods and settings); `opens` if it
starts by itself; last, `says:` and the line that the page shows below it.
"""
import hashlib
import json
import re

from booktext import ROOT, TextError, blocks, markdown_files, run_tool

DEMO = re.compile(r"^<!--\s*demo:(.*)-->\s*$")


def words_of(text, where):
    """(methods, settings) of 'gauss_seidel rows=20'."""
    methods, settings = [], {}
    for word in text.split():
        name, equals, value = word.partition("=")
        if not equals:
            methods.append(word)
            continue
        try:
            settings[name] = float(value)
        except ValueError:
            raise TextError(f"{where}: the demo's setting {word} is no number.") from None
    return methods, settings


def parse(text, own, where):
    """A demo from what stands behind `demo:`. `own`: the program of the text's chapter, or None."""
    what, _, says = text.partition(", says: ")
    parts = [part.strip() for part in what.split(",")]
    program, slash, scene = parts[0].rpartition("/")
    program = program if slash else own
    if not program or not re.fullmatch(r"[\w-]+", scene):
        raise TextError(f"{where}: a demo names its scene first, outside of a chapter as 04_pgs/column.")
    demo = {"program": program, "scene": scene, "methods": [], "settings": {}, "break": None, "opens": False, "says": says.strip(),
            "where": where}
    for part in parts[1:]:
        if part == "opens":
            demo["opens"] = True
        elif part.startswith("break "):
            label, colon, rest = part[len("break "):].partition(":")
            if not colon:
                raise TextError(f"{where}: 'break' names what is off, then a colon, then methods and settings.")
            methods, settings = words_of(rest, where)
            demo["break"] = {"label": label.strip(), "methods": methods, "settings": settings}
        else:
            methods, settings = words_of(part, where)
            demo["methods"] += methods
            demo["settings"].update(settings)
    digest = hashlib.sha256(text.strip().encode()).hexdigest()[:6]
    demo["still"] = f"{program}_{scene}_{digest}.svg"
    return demo


def demo_of(block, own, where):
    """The demo of a comment block, or None."""
    found = DEMO.match(" ".join(line.strip() for line in block.lines)) if block.kind == "comment" else None
    return parse(found.group(1), own, where) if found else None


def own_program(root, path):
    parts = path.relative_to(root).parts
    return parts[1] if parts[0] == "chapters" and len(parts) > 2 else None


def demos_of(root, path):
    name = path.relative_to(root).as_posix()
    found = [demo_of(block, own_program(root, path), f"{name}:{block.line}")
             for block in blocks(path.read_text(encoding="utf-8"), name)]
    return [demo for demo in found if demo]


def main():
    print(json.dumps([demo for path in markdown_files(ROOT) for demo in demos_of(ROOT, path)]))


if __name__ == "__main__":
    run_tool(main)
