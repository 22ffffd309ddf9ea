"""Draws the heat maps of docs/stability.md from the table, and from turning.csv, joints.csv and space.csv beside it.

    docs/stability/draw.py TABLE FOLDER
"""

import pathlib
import sys

from matrix_table import COLUMNS, Table

INK = "#808080"
# Orange to blue: told apart by every eye, and by its lightness alone.
STOPS = [(0.0, (179, 88, 6)), (1 / 3, (253, 184, 99)), (2 / 3, (146, 197, 222)), (1.0, (33, 102, 172))]
CELL = 31


def colour(share):
    for (low, dark), (high, light) in zip(STOPS, STOPS[1:]):
        if share <= high:
            part = (share - low) / (high - low)
            return tuple(round(a + part * (b - a)) for a, b in zip(dark, light))
    return STOPS[-1][1]


def ink_on(rgb):
    return "#000000" if 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2] > 130 else "#ffffff"


def text(x, y, words, size=11, anchor="start", fill=INK, extra=""):
    words = words.replace("&", "&amp;").replace("<", "&lt;")
    return f'<text x="{x:g}" y="{y:g}" font-size="{size}" text-anchor="{anchor}" fill="{fill}"{extra}>{words}</text>'


def cell(x, y, height, found):
    """Mean in the middle, in per cent; the minimum of 0 … 3 small beside it; nothing where a stress does not apply."""
    if not found:
        return [f'<circle cx="{x + CELL / 2:g}" cy="{y + height / 2:g}" r="1" fill="{INK}"/>']
    share, lowest = found
    rgb = colour(share)
    ink = ink_on(rgb)
    lines = [f'<rect x="{x + 0.5:g}" y="{y + 0.5:g}" width="{CELL - 1}" height="{height - 1:g}" '
             f'fill="rgb({rgb[0]},{rgb[1]},{rgb[2]})"/>']
    lines.append(text(x + CELL - 10, y + height / 2 + 4, f"{100 * share:.0f}", 10, "end", ink))
    lines.append(text(x + CELL - 2.5, y + height / 2 + 6, str(lowest), 8, "end", ink))
    return lines


def columns(table, left, top):
    """Names of the methods, slanted, and of their chapters above a line."""
    lines, x, chapter, start = [], left, None, left
    spans = []
    for method in table.methods:
        if table.chapters[method] != chapter:
            if chapter is not None:
                spans.append((chapter, start, x))
                x += 6
            chapter, start = table.chapters[method], x
        lines.append(text(0, 0, method, 11, "start", INK, f' transform="translate({x + CELL / 2 + 4:g},{top - 6:g}) rotate(-90)"'))
        x += CELL
    spans.append((chapter, start, x))
    for number, (chapter, begin, end) in enumerate(spans):
        y = top - 168
        lines.append(f'<path d="M{begin:g} {y}H{end - 1:g}" stroke="{INK}"/>')
        wide = end - begin > max(90, 6.2 * len(COLUMNS[chapter]))
        lines.append(text(begin, y - 5, COLUMNS[chapter] if wide else f"{chapter}.", 11))
    return lines, x


def places(table, left):
    found, x, chapter = {}, left, None
    for method in table.methods:
        if chapter not in (None, table.chapters[method]):
            x += 6
        chapter = table.chapters[method]
        found[method] = x
        x += CELL
    return found


def legend(left, y, right):
    """What the colours mean, in as many lines as fit, and how far down it goes."""
    lines, x = [], left
    for share, words in ((0, "0: NaN, explosion, silent error"), (1 / 3, "33: finite, but failed"), (2 / 3, "67: holds"),
                         (1, "100: accurate")):
        if x > left and x + 20 + 6.4 * len(words) > right:
            x, y = left, y + 18
        rgb = colour(share)
        lines.append(f'<rect x="{x:g}" y="{y - 11:g}" width="14" height="14" fill="rgb({rgb[0]},{rgb[1]},{rgb[2]})"/>')
        lines.append(text(x + 20, y, words, 11))
        x += 20 + 6.4 * len(words) + 24
    for words in ("in a cell: mean of the perturbations in per cent, and the lowest score, 0 to 3;", "a dot: does not apply"):
        if x > left and x + 6.2 * len(words) > right or words.startswith("in"):
            x, y = left, y + 18
        lines.append(text(x, y, words, 11))
        x += 6.2 * len(words)
    return lines, y


def page(width, height, lines):
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" '
                      f'viewBox="0 0 {width:g} {height:g}" font-family="DejaVu Sans, sans-serif">', *lines, "</svg>", ""])


def overview(table):
    left, top, high = 126, 200, 24
    lines, right = columns(table, left, top)
    at = places(table, left)
    for number, stress in enumerate(table.stresses):
        y = top + high * number
        lines.append(text(left - 8, y + high / 2 + 4, stress, 12, "end"))
        for method in table.methods:
            lines += cell(at[method], y, high, table.row(stress, method))
    more, y = legend(left, top + high * len(table.stresses) + 26, right)
    return page(right + 10, y + 12, lines + more)


def matrix(table):
    left, top, high = 236, 200, 17
    lines, right = columns(table, left, top)
    at = places(table, left)
    y = top
    for stress in table.stresses:
        lines.append(text(126, y + 2.5 * high + 4, stress, 12, "end"))
        for level, value in table.values[stress].items():
            lines.append(text(left - 8, y + high / 2 + 4, value, 11, "end"))
            for method in table.methods:
                lines += cell(at[method], y, high, table.cell(stress, level, method))
            y += high
        y += 6
    more, y = legend(left, y + 20, right)
    return page(right + 10, y + 12, lines + more)


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    table, folder = Table(sys.argv[1]), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "stability_overview.svg").write_text(overview(table), encoding="utf-8")
    (folder / "stability_matrix.svg").write_text(matrix(table), encoding="utf-8")
    for kind in ("turning", "joints", "space"):
        other = Table(pathlib.Path(sys.argv[1]).with_name(f"{kind}.csv"))
        (folder / f"stability_{kind}.svg").write_text(matrix(other), encoding="utf-8")


main()
