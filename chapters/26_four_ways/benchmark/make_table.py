"""The table of engines of chapter 26 from what `./book bench 26` measured.

    make_table.py RUN        writes the rows of Google Benchmark's CSV file RUN into engines.csv beside this one, and the table into
                             the text; without an engine in RUN its rows stay as they are
    make_table.py            writes the table from engines.csv
    make_table.py --check    changes nothing, exit 1 if another table stands in the text

    engines.csv    error, energy and time of engines and of two ways of the book at 240 steps a second    section 26.G
"""

import csv
import io
import math
import pathlib
import sys

CHAPTER = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(CHAPTER.parents[1] / "docs" / "tools"))
from put_table import benchmark_rows, put_all, stale  # noqa: E402

FILE = CHAPTER / "benchmark" / "engines.csv"
PAGE = CHAPTER / "in_depth.md"
MARK = "<!-- table: benchmark/engines.csv engines -->"
HEADING = ["scene", "engine", "error", "energy", "us"]
RATE = "240"
SCENES = {"pendulum": "pendulum", "double_pendulum": "double pendulum", "slider-crank": "slider-crank", "heavy_chain": "heavy chain",
          "block_on_a_slope": "block on a slope", "bouncing_ball": "bouncing ball", "stack_of_five": "stack of five",
          "Painleve_s_rod": "Painlevé's rod", "Newton_s_cradle": "Newton's cradle", "doll": "doll"}
KEEP_THEIR_ENERGY = {"pendulum", "double_pendulum", "slider-crank", "heavy_chain"}
ENGINES = {"impulses": "this book, impulses", "coordinates": "this book, coordinates", "ODE": "ODE", "Bullet": "Bullet",
           "Bullet_s_trees": "Bullet's trees", "Simbody": "Simbody", "MuJoCo": "MuJoCo"}


def one_digit(value):
    """As one_digit() of program/who_can.hpp writes it: 20, 0.3, 2e-9."""
    if value < 1e-14:
        return "0"
    return f"{value:.0f}" if value >= 1 else f"{value:.1g}".replace("e-0", "e-")


def two_digits(value):
    """Without a power of ten; what is 100 or more has no digits behind the point."""
    return f"{value:,.0f}" if value >= 99.5 else f"{value:.{max(0, 1 - math.floor(math.log10(value)))}f}"


def rows_of(run, kept):
    """The rows of a run, and those kept of what the run has not; in the order of the table."""
    found = {(row["scene"], row["engine"]): row for row in kept}
    for row in benchmark_rows(run):
        part = row["name"].split("/")
        if part[0] in SCENES and part[1] in ENGINES and part[2] == RATE:
            found[part[0], part[1]] = {"scene": part[0], "engine": part[1],
                                       **{key: f"{float(row[key]):.6g}" for key in HEADING[2:]}}
    return [found[scene, engine] for scene in SCENES for engine in ENGINES if (scene, engine) in found]


def table_of(rows):
    lines = ["| scene | engine | error | energy [J] | time of a second [ms] |", "|---|---|---|---|---:|"]
    before = None
    for row in rows:
        error, energy = float(row["error"]), float(row["energy"])
        gained = ("+" if energy >= 0 else "−") + one_digit(abs(energy)) if row["scene"] in KEEP_THEIR_ENERGY else "–"
        cells = [SCENES[row["scene"]] if row["scene"] != before else "", ENGINES[row["engine"]],
                 "gone" if error >= 10 else one_digit(error), "–" if error >= 10 else gained,
                 two_digits(float(row["us"]) / 1000) if row["us"] else "–"]  # an error can be had without a time
        lines.append("| " + " | ".join(cells).lstrip() + " |")
        before = row["scene"]
    return [line.replace("|  |", "| |") for line in lines]


def main():
    if len(sys.argv) > 2:
        raise SystemExit(__doc__)
    kept = list(csv.DictReader(io.StringIO(FILE.read_text(encoding="utf-8")))) if FILE.exists() else []
    if sys.argv[1:] == ["--check"]:
        faults = [f"{PAGE.relative_to(CHAPTER.parents[1])}: the table at {place} is not that of its file; run "
                  f"{pathlib.Path(__file__).resolve().relative_to(CHAPTER.parents[1])}."
                  for place in stale(PAGE, {MARK: table_of(kept)})]
        print("\n".join(faults), end="\n" if faults else "")
        sys.exit(1 if faults else 0)
    rows = rows_of(sys.argv[1], kept) if len(sys.argv) == 2 else kept
    if len(sys.argv) == 2:
        text = io.StringIO()
        writer = csv.DictWriter(text, HEADING, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        FILE.write_text(text.getvalue(), encoding="utf-8")
    put_all(PAGE, {MARK: table_of(rows)})


if __name__ == "__main__":
    main()
