"""The tables of engines and solvers of chapter 26 from what `./book bench 26` measured.

    make_table.py RUN        writes the rows of Google Benchmark's CSV file RUN into engines.csv and forces.csv beside this one, and
                             the tables into the text; what is not in RUN stays as it is
    make_table.py            writes the tables from the two files
    make_table.py --check    changes nothing, exit 1 if another table stands in the text

    engines.csv    error, energy and time of engines and of two ways of the book at 240 steps a second    section 26.G
    forces.csv     residual and time of solvers on the forces of scenes where they start                  section 26.H
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
FORCES = CHAPTER / "benchmark" / "forces.csv"
PAGE = CHAPTER / "in_depth.md"
MARK = "<!-- table: benchmark/engines.csv engines -->"
FORCE_MARK = "<!-- table: benchmark/forces.csv forces -->"
HEADING = ["scene", "engine", "error", "energy", "us"]
FORCE_HEADING = ["problem", "rows", "solver", "residual", "us"]
RATE = "240"
SCENES = {"pendulum": "pendulum", "double_pendulum": "double pendulum", "slider-crank": "slider-crank", "heavy_chain": "heavy chain",
          "block_on_a_slope": "block on a slope", "bouncing_ball": "bouncing ball", "stack_of_five": "stack of five",
          "Painleve_s_rod": "Painlevé's rod", "Newton_s_cradle": "Newton's cradle", "doll": "doll"}
KEEP_THEIR_ENERGY = {"pendulum", "double_pendulum", "slider-crank", "heavy_chain"}
ENGINES = {"impulses": "this book, impulses", "coordinates": "this book, coordinates", "ODE": "ODE", "Bullet": "Bullet",
           "Bullet_s_trees": "Bullet's trees", "Simbody": "Simbody", "MuJoCo": "MuJoCo"}
SOLVERS = {"this_book": "this chapter", "ODE": "ODE", "Bullet": "Bullet", "Siconos_Lemke": "Siconos' Lemke",
           "Siconos_sweeps": "Siconos' sweeps"}
NO_ANSWER = 1e-6  # of the residual, in m/s²: accelerations are of size 10


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


def forces_of(run, kept):
    """The rows of forces.csv with the residuals and times of a run, where it has them."""
    found = {(row["problem"].replace(" ", "_").replace("'", "_"), row["solver"]): dict(row) for row in kept}
    for row in benchmark_rows(run):
        part = row["name"].split("/")
        if part[0] == "forces" and (part[1], part[2]) in found:
            found[part[1], part[2]] |= {"residual": f"{float(row['error']):.6g}", "us": f"{float(row['us']):.6g}"}
    return list(found.values())


def force_table_of(rows):
    """A line a problem, a column a solver: residual and time."""
    lines = ["| problem | rows | " + " | ".join(SOLVERS.values()) + " |", "|---|---:|" + "---|" * len(SOLVERS)]
    for problem in dict.fromkeys(row["problem"] for row in rows):
        cells = {row["solver"]: row for row in rows if row["problem"] == problem}
        words = []
        for solver in SOLVERS:
            row = cells.get(solver)
            time = f", {two_digits(float(row['us']))} µs" if row and row["us"] else ""
            words.append("–" if row is None else (one_digit(float(row["residual"])) if float(row["residual"]) < NO_ANSWER else "none") + time)
        lines.append("| " + " | ".join([problem.replace("Painleve", "Painlevé"), next(iter(cells.values()))["rows"], *words]) + " |")
    return lines


def rows_in(file):
    return list(csv.DictReader(io.StringIO(file.read_text(encoding="utf-8")))) if file.exists() else []


def write(file, heading, rows):
    text = io.StringIO()
    writer = csv.DictWriter(text, heading, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    file.write_text(text.getvalue(), encoding="utf-8")


def main():
    if len(sys.argv) > 2:
        raise SystemExit(__doc__)
    kept, forces = rows_in(FILE), rows_in(FORCES)
    if sys.argv[1:] == ["--check"]:
        faults = [f"{PAGE.relative_to(CHAPTER.parents[1])}: the table at {place} is not that of its file; run "
                  f"{pathlib.Path(__file__).resolve().relative_to(CHAPTER.parents[1])}."
                  for place in stale(PAGE, {MARK: table_of(kept), FORCE_MARK: force_table_of(forces)})]
        print("\n".join(faults), end="\n" if faults else "")
        sys.exit(1 if faults else 0)
    if len(sys.argv) == 2:
        kept, forces = rows_of(sys.argv[1], kept), forces_of(sys.argv[1], forces)
        write(FILE, HEADING, kept)
        write(FORCES, FORCE_HEADING, forces)
    put_all(PAGE, {MARK: table_of(kept), FORCE_MARK: force_table_of(forces)})


if __name__ == "__main__":
    main()
