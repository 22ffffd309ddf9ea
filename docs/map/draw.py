"""Draws the figure of docs/map.md: five families of methods, each below the quantity at which it writes its constraints.

    docs/map/draw.py FILE
    docs/map/draw.py --check FILE     only says whether the file is what would be drawn
"""

import pathlib
import sys

INK = "#808080"
STATIONS = ["force", "acceleration", "velocity", "position"]
BETWEEN = ["divide by the mass", "times h", "times h"]
# Title, colour, what it writes, then what is said of it.
FAMILIES = [
    ("Penalty", "#d9822b", "f = −k C n", ["prescribes the force", "stays off by f / k", "2.1 shows its limit"]),
    ("Acceleration level", "#b58900", "J a + J′ u ≥ 0", ["computes the force", "drifts", "LCP: chapters 5, 9"]),
    ("Impulses", "#268bd2", "J u + b ≥ 0", ["computes the impulse", "drifts, b pays it back", "chapters 2 to 6, 8 to 13"]),
    ("Position based", "#2ca02c", "C(x + Δx) ≥ 0", ["computes the place", "drags the velocity along", "projection: chapter 7"]),
]
LAST = ("Reduced coordinates", "#9467bd", "x = x(θ): no other place can be written down",
        ["computes the second derivative of θ · nothing drifts · closed loops and contacts need one of the others as well",
         "references of chapters 1, 7 and 11"])
WIDTH, LEFT, STEP, BOX = 900, 20, 220, 200


def text(x, y, words, size=12, anchor="middle", fill=INK, weight="normal"):
    words = words.replace("&", "&amp;").replace("<", "&lt;")
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" text-anchor="{anchor}" fill="{fill}" '
            f'font-weight="{weight}">{words}</text>')


def rectangle(x, y, width, height, colour, dash=""):
    return (f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" rx="6" fill="none" stroke="{colour}" '
            f'stroke-width="1.5"{dash}/>')


def arrow(x1, y1, x2, y2, colour=INK):
    return f'<path d="M{x1:g} {y1:g}L{x2:g} {y2:g}" stroke="{colour}" stroke-width="1.5" marker-end="url(#tip)"/>'


def family(x, y, width, height, title, colour, formula, lines):
    middle = x + width / 2
    out = [rectangle(x, y, width, height, colour), text(middle, y + 22, title, 14, fill=colour, weight="bold"),
           text(middle, y + 46, formula, 14)]
    return out + [text(middle, y + 70 + 19 * k, line) for k, line in enumerate(lines)]


def drawing():
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -10 {WIDTH} 430" width="{WIDTH}" height="430" '
           'font-family="sans-serif">',
           f'<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
           f'<path d="M0 0L8 4L0 8z" fill="{INK}"/></marker></defs>']
    for k, station in enumerate(STATIONS):
        x = LEFT + STEP * k
        out += [rectangle(x + 35, 40, BOX - 70, 34, INK), text(x + BOX / 2, 62, station, 14)]
        if k < len(BETWEEN):
            out += [arrow(x + BOX - 35, 57, x + STEP + 35, 57), text(x + (BOX + STEP) / 2, 32, BETWEEN[k], 11)]
        colour = FAMILIES[k][1]
        out += [f'<path d="M{x + BOX / 2:g} 134L{x + BOX / 2:g} 78" stroke="{colour}" stroke-width="1.5"/>']
        out += family(x, 134, BOX, 124, *FAMILIES[k])
    right = LEFT + 3 * STEP + BOX / 2
    out += [f'<path d="M{right:g} 40V12H{LEFT + BOX / 2:g}V36" stroke="{INK}" stroke-width="1.5" fill="none" '
            'stroke-dasharray="4 3" marker-end="url(#tip)"/>',
            text(WIDTH / 2, 5, "the next step", 11)]
    out += family(LEFT, 284, 3 * STEP + BOX, 116, *LAST)
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
            print(f"{file} is not what docs/map/draw.py draws", file=sys.stderr)
            return 1
        return 0
    file.write_text(drawing(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
