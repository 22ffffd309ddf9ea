"""The tables of chapter 19 from what `./book bench 19` measured.

    make_table.py RUN        writes the rows of Google Benchmark's CSV file RUN into the files beside this one, and the tables
                             into the texts; what RUN has no row of stays as it is
    make_table.py            writes the tables from these files
    make_table.py --check    changes nothing, exit 1 if another table stands in a text

    kept.csv       what is kept where things move, with 1, 4 and 16 sub-steps    Tables 19.1 and 19.2
    engines.csv    large worlds and what should stand, with 1 and 4              19.A and 19.8
    asleep.csv     a step where few or all are awake                             19.B
"""

import csv
import io
import math
import pathlib
import sys

CHAPTER = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(CHAPTER.parents[1] / "docs" / "tools"))
from put_table import benchmark_rows, put_all, stale  # noqa: E402

WHO = {"book": "this book", "box2d3": "Box2D 3", "box2d": "Box2D 2.4", "chipmunk": "Chipmunk"}
SWEEPS = "its sweeps alone"
ENGINES = {"book": "this book", "book_sweeps": SWEEPS, **WHO}
SUBSTEPS = (1, 4, 16)
HEADINGS = {"kept.csv": ["scene", "what", "reference", "engine", "sub-steps", "kept", "error", "gap", "ms"],
            "engines.csv": ["scene", "engine", "sub-steps",
                            "ms_all", "us_step", "us_last", "overlap", "gap", "crept", "sunk", "gained"],
            "asleep.csv": ["scene", "us_step", "awake", "contacts", "rows", "visits", "tested"]}

# The worlds of 19.A.
STAND = {"pyramid_10": "pyramid, 10 boxes at its foot", "pyramid_20": "pyramid, 20", "pyramid_40": "pyramid, 40",
         "pyramid_100": "pyramid, 100 (one second)", "house_4": "house of cards", "column_20": "column of 20",
         "column_40": "column of 40", "column_80": "column of 80", "heavy_1000_on_10": "1000 times as heavy on 10 boxes",
         "piles_1000": "1000 piles of five", "boxes_1mm": "pyramid of boxes of 1 mm",
         "boxes_100m": "pyramid of boxes of 100 m"}
HANG = {"chain_50_1000": "chain, 1000 rods at its end", "bridge_30": "bridge, 30 planks", "grid_20": "net of 20 × 20",
        "grid_100": "net of 100 × 100 (half a second)", "dolls_10": "10 ragdolls on stairs"}
LIE = {"rubble_40": "40 bodies of rubble", "poured_300": "300 poured", "poured_10000": "10,000 poured (two seconds)",
       "dolls_10": "10 ragdolls on stairs", "tumbler_40": "tumbler, 40 boxes"}
IN_DEPTH = {"ms_all": {**STAND, **HANG, **LIE}, "sunk": STAND, "gap": HANG, "overlap": {**LIE, "bridge_30": "bridge with balls"},
            "gained": {name: {**LIE, **HANG}[name]
                       for name in ("poured_300", "dolls_10", "chain_50_1000", "bridge_30", "grid_20")}}
ONE_STEP_ONLY = {"poured_10000"}

# Where it is behind, in 19.8: world → title, and what stands in its lines: column, times, heading.
BEHIND = {"poured_300": ("300 boxes and discs poured", [("ms_all", 1e-3, "time [s]"), ("overlap", 1, "overlap [m]")]),
          "dolls_10": ("10 ragdolls on stairs", [("ms_all", 1e-3, "time [s]"), ("gap", 1, "gap of a joint [m]"),
                                                 ("overlap", 1, "overlap [m]")]),
          "pyramid_40": ("pyramid, 40 boxes at its foot", [("ms_all", 1e-3, "time [s]")]),
          "grid_20": ("grid of 20 × 20 bodies on joints", [("ms_all", 1e-3, "time [s]"), ("gap", 1, "gap of a joint [m]")]),
          "chain_50_1000": ("chain of 50 rods, 1000 at its end", [("ms_all", 1, "time [ms]")]),
          "pyramid_10": ("pyramid, 10", [("ms_all", 1, "time [ms]")])}
# How far what should stand has moved, in 19.8: title, world, column, numbers of sub-steps.
MOVED = [("pyramid, 10 boxes at its foot", "pyramid_10", "sunk", (1, 4)), ("pyramid, 20", "pyramid_20", "sunk", (1, 4)),
         ("pyramid, 40", "pyramid_40", "sunk", (1, 4)), ("house of cards, 4 storeys", "house_4", "sunk", (1, 4)),
         ("column of 20 boxes", "column_20", "sunk", (1, 4)),
         ("1000 times as heavy on 10 boxes", "heavy_1000_on_10", "sunk", (1, 4)),
         ("chain of 50 rods with 1000 rods at its end: gap", "chain_50_1000", "gap", (1,))]


def rows_of(run):
    """file → its rows, with scenes in the order of the run."""
    kept, engines, asleep = {}, {}, []
    for row in benchmark_rows(run):
        part = [name for name in row["name"].split("/") if not name.startswith("iterations:")]
        if part[0] == "kept":
            if part[2] in WHO:
                kept[part[1], int(part[3]), part[2]] = row
        elif part[0].startswith(("asleep_", "awake_")):
            asleep.append([part[0]] + [f"{float(row[key]):.10g}" for key in HEADINGS["asleep.csv"][1:]])
        else:
            engines[part[0], int(part[2]) if len(part) > 2 else 1, part[1]] = row

    def in_order(found):
        for scene in dict.fromkeys(key[0] for key in found):
            for substeps in SUBSTEPS:
                for who, title in ENGINES.items():
                    if (scene, substeps, who) in found:
                        yield scene, substeps, title, found[scene, substeps, who]

    def numbers(row, columns):
        return [f"{float(row[key]):.6g}" for key in columns]

    return {"kept.csv": [[scene, row["label"], f"{float(row['right']):.10g}", title, substeps] +
                         numbers(row, ("kept", "error", "gap", "ms_all")) for scene, substeps, title, row in in_order(kept)],
            "engines.csv": [[scene, title, substeps] + numbers(row, HEADINGS["engines.csv"][3:])
                            for scene, substeps, title, row in in_order(engines)],
            "asleep.csv": asleep}


def line(cells):
    return "| " + " | ".join(cells) + " |"


def with_heads(heads, lines):
    return [line(heads), "|" + "---|" * len(heads), *lines]


def number(value, road=False):
    """Two digits, and no fewer than are before the point. The main road writes a 0 at the end too, and one digit of what is
    as small as errors of rounding."""
    if not math.isfinite(value):
        return "∞"
    if value == 0:
        return "0"
    if abs(value) >= 99.5:  # as two digits this would be 1e+02
        return f"{value:,.0f}" if abs(value) >= 1e4 else f"{value:.0f}"
    if abs(value) >= 1e-3:
        return f"{value:#.2g}".rstrip(".") if road else f"{value:.2g}"
    digits, power = f"{value:.{0 if road and abs(value) < 1e-6 else 1}e}".split("e")
    return rf"${digits} \cdot 10^{{{int(power)}}}$"


def figure(value):
    """Four digits, few enough to compare; what is smaller than any that counts is 0."""
    return "0" if abs(value) < 5e-6 else f"{value:.4g}" if abs(value) >= 1e-3 else f"{value:.1g}"


class Measured:
    """The rows of a file by their scene, engine and sub-steps."""

    def __init__(self, file, rows):
        self.file = file
        self.rows = {(row["scene"], row.get("engine"), row.get("sub-steps")): row for row in rows}

    def __call__(self, column, scene, engine=None, substeps=None):
        row = self.rows.get((scene, engine, substeps and str(substeps)))
        if row is None or row[column] == "":
            by = f" by {engine}, sub-steps {substeps}," if engine else ""
            raise SystemExit(f"{self.file} has no {column} of {scene}{by} that a table could show")
        return float(row[column])


def kept_tables(rows):
    scenes = {}
    for row in rows:
        scenes.setdefault((row["scene"], row["what"], float(row["reference"])), {})[row["engine"], int(row["sub-steps"])] = row
    kept, time = [], []
    for (name, what, reference), found in scenes.items():
        title = f"{name}: {what}"
        for substeps in SUBSTEPS:
            first = substeps == SUBSTEPS[0]
            of = [found.get((engine, substeps)) for engine in WHO.values()]
            kept.append(line([title if first else "", figure(reference) if first else "", str(substeps)] +
                             ["–" if row is None else figure(float(row["kept"])) for row in of]))
            if "a minute" in title:
                time.append(line([name if first else "", str(substeps)] +
                                 ["–" if row is None else number(float(row["ms"])) for row in of]))
    return {"**Table 19.1.**": with_heads(["scene", "reference", "sub-steps", *WHO.values()], kept),
            "**Table 19.2.**": with_heads(["scene", "sub-steps", *WHO.values()], time)}


def in_depth_tables(measured):
    tables = {}
    for column, worlds in IN_DEPTH.items():
        lines = [line([title if substeps == 1 else "", str(substeps)] +
                      [number(measured(column, scene, engine, substeps)) for engine in WHO.values()])
                 for scene, title in worlds.items() for substeps in ((1,) if scene in ONE_STEP_ONLY else (1, 4))]
        tables[f"<!-- table: benchmark/engines.csv {column} -->"] = with_heads(["world", "sub-steps", *WHO.values()], lines)
    return tables


def main_road_tables(measured):
    def cells(engines, column, scene, substeps):
        return [measured(column, scene, engine, substeps) for engine in engines]

    behind, moved = [], []
    for scene, (title, lines) in BEHIND.items():
        for i, (column, times, heading) in enumerate(lines):
            # By default settings, which for Box2D 3 are four sub-steps.
            values = cells(("this book", SWEEPS, "Box2D 2.4", "Chipmunk"), column, scene, 1) + cells(("Box2D 3",), column, scene, 4)
            texts = [number(times * value, road=True) for value in values]
            if column == "ms_all":
                texts[0] = f"**{texts[0]}**"
            behind.append(line(["" if i else title, heading] + texts))
    for title, scene, column, all_substeps in MOVED:
        for substeps in all_substeps:
            values = cells(("this book", SWEEPS, "Box2D 2.4", "Chipmunk"), column, scene, substeps)
            # More than the size of a box, which is 1 m in all of these, is a fall.
            texts = ["falls" if column == "sunk" and not value < 1 else number(value, road=True) for value in values]
            moved.append(line([title if substeps == 1 else "", str(substeps)] + texts))
    book = ["engine of this book", SWEEPS]
    tables = {"behind": with_heads(["world", "", *book, "Box2D 2.4", "Chipmunk", "Box2D 3"], behind),
              "moved": with_heads(["world", "sub-steps", *book, "Box2D", "Chipmunk"], moved)}
    return {f"<!-- table: benchmark/engines.csv {name} -->": [text.replace("|  |", "| |") for text in table]
            for name, table in tables.items()}


def asleep_table(measured):
    lines = []
    for bodies in (100, 1000, 10000, 100000):
        counts = [measured(column, f"asleep_{bodies}") for column in ("awake", "contacts", "visits", "tested")]
        counts.append(measured("tested", f"awake_{bodies}"))
        lines.append(line([f"{n:,.0f}" if n >= 1e4 else f"{n:.0f}" for n in [bodies] + counts]))
    heads = ["$N$", "awake", "contacts", "rows visited", "boxes compared", "boxes compared if all roll"]
    return {"<!-- table: benchmark/asleep.csv counted -->": with_heads(heads, lines)}


def main():
    if len(sys.argv) > 2:
        raise SystemExit(__doc__)
    check = sys.argv[1:] == ["--check"]
    measured = {} if check or len(sys.argv) == 1 else rows_of(sys.argv[1])
    texts, rows = {}, {}
    for file, heading in HEADINGS.items():
        place = CHAPTER / "benchmark" / file
        if measured.get(file):
            text = io.StringIO()
            csv.writer(text, lineterminator="\n").writerows([heading, *measured[file]])
            texts[place] = text.getvalue()
        rows[file] = list(csv.DictReader(io.StringIO(texts.get(place) or place.read_text(encoding="utf-8"))))
    engines, asleep = Measured("engines.csv", rows["engines.csv"]), Measured("asleep.csv", rows["asleep.csv"])
    pages = {CHAPTER / "in_depth.md": {**in_depth_tables(engines), **asleep_table(asleep), **kept_tables(rows["kept.csv"])},
             CHAPTER / "README.md": main_road_tables(engines)}
    if check:
        faults = [f"{page.relative_to(CHAPTER.parents[1])}: the table at {place} is not that of its file; run "
                  f"{pathlib.Path(__file__).resolve().relative_to(CHAPTER.parents[1])}."
                  for page, tables in pages.items() for place in stale(page, tables)]
        print("\n".join(faults), end="\n" if faults else "")
        sys.exit(1 if faults else 0)
    for place, text in texts.items():  # only when all tables could be made
        place.write_text(text, encoding="utf-8")
    for page, tables in pages.items():
        put_all(page, tables)


if __name__ == "__main__":
    main()
