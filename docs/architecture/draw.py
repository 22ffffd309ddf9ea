"""Draws the figure of docs/architecture.md from the includes of all sources.

    docs/architecture/draw.py FILE
    docs/architecture/draw.py --check FILE     only says whether the file is what would be drawn
"""

import html
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
INK, PHYSICS, SHELL, CHECKS = "#808080", "#268bd2", "#d9822b", "#2ca02c"
WIDTH, LEFT, RIGHT, LINE = 900, 40, 860, 330  # LINE: y of the chapters
INCLUDE = re.compile(r'^\s*#\s*include\s*"((?:chapters|common|tests|docs)/[^"]+)"', re.M)


def sources(folder):
    return [f for f in sorted((ROOT / folder).rglob("*")) if f.suffix in (".hpp", ".cpp") and f.name != "small.cpp"]


def part(path):
    """What a source belongs to: a chapter's number, "common", or what stands around the physics."""
    parts = pathlib.PurePosixPath(path).parts
    if parts[0] == "chapters":
        if "program" in parts[2:-1]:
            return "program"
        if "benchmark" in parts[2:-1]:
            return "benchmark"
        return int(parts[1][:2])
    if parts[0] == "common":
        shell = "program" in parts or re.match(r"canvas|draw_list|gl_canvas|picture|svg_canvas", parts[-1])
        return "program" if shell else "common"
    return "tests" if parts[0] == "tests" else "docs"


def uses():
    """{(part, part that it includes)} of all sources."""
    found = set()
    for folder in ("chapters", "common", "tests", "docs"):
        for source in sources(folder):
            own = part(source.relative_to(ROOT).as_posix())
            found |= {(own, part(name)) for name in INCLUDE.findall(source.read_text(encoding="utf-8"))}
    return {(a, b) for a, b in found if a != b}


def text(x, y, words, size=12, anchor="middle", fill=INK, weight="normal", turn=""):
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" text-anchor="{anchor}" fill="{fill}" '
            f'font-weight="{weight}"{turn}>{html.escape(words, quote=False)}</text>')


def rectangle(x, y, width, height, colour, dash=""):
    return (f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" rx="6" fill="none" stroke="{colour}" '
            f'stroke-width="1.5"{dash}/>')


def box(x, y, width, height, colour, title, lines):
    out = [rectangle(x, y, width, height, colour), text(x + width / 2, y + 20, title, 13, fill=colour, weight="bold")]
    return out + [text(x + width / 2, y + 38 + 16 * k, line, 11) for k, line in enumerate(lines)]


def arrow(x1, y1, x2, y2, colour):
    return f'<path d="M{x1:g} {y1:g}L{x2:g} {y2:g}" stroke="{colour}" stroke-width="1.5" marker-end="url(#tip)"/>'


def drawing():
    known = uses()
    folders = sorted(f for f in (ROOT / "chapters").glob("[0-9][0-9]_*") if f.is_dir())
    numbers = [int(f.name[:2]) for f in folders]
    step = (RIGHT - LEFT) / (len(numbers) - 1)
    place = {number: LEFT + step * k for k, number in enumerate(numbers)}
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} 560" width="{WIDTH}" height="560" font-family="sans-serif">',
           f'<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
           f'<path d="M0 0L8 4L0 8z" fill="{INK}"/></marker></defs>']
    # what stands around the physics and only reads it
    around = [("tests", CHECKS, "tests/", ["tests, stresses, mutants,", "peers, properties"]),
              ("docs", CHECKS, "docs/", ["results, race, use_it,", "the site and its tools"]),
              ("benchmark", CHECKS, "chapters/*/benchmark/", ["run time against error,", "beside other programs"]),
              ("program", SHELL, "program/ of chapters and common/", ["scenes, command line, canvas,", "window, the pages"])]
    x = 10
    for name, colour, title, lines in around:
        width = 280 if name == "program" else 190
        out += box(x, 10, width, 62, colour, title, lines)
        if any(a == name and (b == "common" or isinstance(b, int)) for a, b in known):
            out.append(arrow(x + width / 2, 74, x + width / 2, 102, colour))
        x += width + 10
    out += [rectangle(10, 106, 880, 444, PHYSICS, ' stroke-dasharray="6 4"'),
            text(450, 124, "physics: chapters/*/*.hpp and common/, the library rigid::physics", 13, fill=PHYSICS, weight="bold")]
    # an arc from each chapter to each earlier one that it includes
    for a, b in sorted((a, b) for a, b in known if isinstance(a, int) and isinstance(b, int)):
        span = place[a] - place[b]
        if span < 0:
            raise SystemExit(f"chapter {b} is later than chapter {a}, which includes it")
        height = 12 + 180 * span / (RIGHT - LEFT)
        out.append(f'<path d="M{place[a]:.1f} {LINE - 12}C{place[a]:.1f} {LINE - 12 - height * 4 / 3:.1f} {place[b]:.1f} '
                   f'{LINE - 12 - height * 4 / 3:.1f} {place[b]:.1f} {LINE - 12}" stroke="{PHYSICS}" stroke-width="1" fill="none" '
                   f'stroke-opacity="0.6"/>')
    for folder, number in zip(folders, numbers):
        x = place[number]
        out += [rectangle(x - 14, LINE - 12, 28, 24, PHYSICS), text(x, LINE + 5, str(number), 12),
                text(x + 4, LINE + 20, folder.name[3:].replace("_", " "), 11, "end", turn=f' transform="rotate(-90 {x + 4:g} {LINE + 20})"')]
        if (number, "common") in known:
            out.append(f'<path d="M{x:.1f} {LINE + 134}V{LINE + 156}" stroke="{INK}" stroke-width="1" marker-end="url(#tip)"/>')
    out += box(20, LINE + 160, 860, 50, PHYSICS, "common/", ["bodies, shapes, contacts, scenes, forces, measures, elementary functions; no chapter is included here"])
    return "\n".join(out + ["</svg>", ""])


def main():
    check = sys.argv[1:2] == ["--check"]
    files = sys.argv[1 + check:]
    if len(files) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    file = pathlib.Path(files[0])
    if check:
        if not file.is_file() or file.read_text(encoding="utf-8") != drawing():
            print(f"{file} is not what docs/architecture/draw.py draws; run docs/build.sh sync", file=sys.stderr)
            return 1
        return 0
    file.write_text(drawing(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
