"""The tables of chapter 30 from what `./book bench 30` measured.

    make_table.py RUN        writes the rows of Google Benchmark's CSV file RUN into measured.csv beside this file, and the
                             tables into the texts; what RUN has no row of stays as it is
    make_table.py            writes the tables from measured.csv
    make_table.py --check    changes nothing, exit 1 if another table stands in a text

A line of measured.csv is a line of the benchmark; the head of benchmark.cpp says what its numbers are.
"""

import csv
import io
import pathlib
import sys

CHAPTER = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(CHAPTER.parents[1] / "docs" / "tools"))
from put_table import benchmark_rows, put_all, stale  # noqa: E402

MEASURED = CHAPTER / "benchmark" / "measured.csv"
COLUMNS = ["us", "ms", "ms_whole", "solve_ms", "error", "residual", "systems", "inner", "factors", "bytes_model", "bytes_solver",
           "nodes", "blocks", "rows", "fill", "tones"]

TETS = {"linear/direct/all": "linear, factor kept", "linear/cg/one": "linear, CG to 1 % of the right side",
        "corotational/direct/kept_one": "corotational, one system, factor kept",
        "neo_hookean/direct/kept_one": "neo-Hookean, one system, factor kept", "corotational/cg/all": "corotational, CG",
        "corotational/direct/kept": "corotational, factor kept", "neo_hookean/direct/kept": "neo-Hookean, factor kept",
        "corotational/direct/all": "corotational, factors made anew"}
NET = {"xpbd/100": "XPBD, 100 sweeps", "xpbd/1000": "XPBD, 1,000 sweeps", "xpbd/3000": "XPBD, 3,000 sweeps",
       "vbd/100": "VBD, 100 sweeps", "vbd/1000": "VBD, 1,000 sweeps", "vbd/3000": "VBD, 3,000 sweeps",
       "projective/3": "projective dynamics, 3 rounds", "projective/30": "projective dynamics, 30 rounds",
       "projective/100": "projective dynamics, 100 rounds", "springs_newton/1": "springs by Newton's method",
       "linear/direct/5": "linear law, factor kept", "corotational/direct/3": "corotational law, factor kept while it serves",
       "corotational/direct/7": "the same to $10^{-7}$", "corotational/cg/5": "corotational law, conjugate gradients"}
BEAM = {"corotational/euler/direct": "this book, implicit Euler", "corotational/midpoint/direct": "this book, midpoint",
        "bullet/corotational/1": "Bullet"}
FACTOR = {"book": "this book, blocks", "eigen": "Eigen, `SimplicialLDLT`", "cholmod": "CHOLMOD, supernodal"}
SOFT = {"ball": "a ball that rolls", "jelly": "jelly on stairs", "mattress": "a box on a mattress", "fingers": "fingers and a box"}


def rows_of(run):
    """name without what Google Benchmark adds → its numbers."""
    found = {}
    for row in benchmark_rows(run):
        name = "/".join(part for part in row["name"].split("/") if not part.startswith("iterations:"))
        found[name] = [f"{float(row[column]):.6g}" if row.get(column) else "0" for column in COLUMNS]
    return found


def with_heads(heads, lines):
    first, *others = heads
    return [line(heads), "|---|" + "---:|" * len(others), *map(line, lines)]


def line(cells):
    return "| " + " | ".join(cells) + " |"


def number(value):
    """Two digits, and no fewer than are before the point."""
    if value == 0:
        return "0"
    if abs(value) >= 99.5:
        power = 10 ** (len(f"{abs(value):.0f}") - 2)
        return f"{round(value / power) * power:,.0f}"
    if abs(value) >= 1e-2:
        return f"{value:#.2g}".rstrip(".")
    digits, power = f"{value:.0e}".split("e")
    return rf"${digits} \cdot 10^{{{int(power)}}}$"


def share(value):
    """A share in per cent."""
    return "below 0.001 %" if value < 1e-5 else f"{100 * value:.3f} %" if value < 1e-3 else f"{100 * value:#.2g}".rstrip(".") + " %" \
        if value < 0.995 else f"{100 * value:.0f} %"


def tables_of(rows):
    def get(name, column):
        if name not in rows:
            raise SystemExit(f"measured.csv has no line {name} that a table could show; run the whole benchmark, with its peers")
        return float(rows[name][COLUMNS.index(column)])

    tets = [[title, number(get(f"tets/{name}", "ms_whole")), number(get(f"tets/{name}", "residual")),
             number(get(f"tets/{name}", "systems")), number(get(f"tets/{name}", "factors"))] for name, title in TETS.items()]
    net = [[title, share(get(f"net/{name}", "error")), number(get(f"net/{name}", "us"))] for name, title in NET.items()]
    beam = [[title if steps == 30 else "", str(steps), share(get(f"beam/{name}/{steps}", "error")),
             number(get(f"beam/{name}/{steps}", "ms_whole"))] for name, title in BEAM.items() for steps in (30, 60, 120, 240)]
    factor = [[title, f"{get(f'factor/{name}', 'fill'):,.0f}", number(get(f"factor/{name}", "ms")),
               number(get(f"factor/{name}", "solve_ms")), number(get(f"factor/{name}", "residual"))] for name, title in FACTOR.items()]
    soft = [[title, f"{get(f'soft/{name}/new', 'nodes'):,.0f}", f"{get(f'soft/{name}/new', 'rows'):.0f}",
             number(get(f"soft/{name}/new", "ms")), number(get(f"soft/{name}/kept", "ms"))] for name, title in SOFT.items()]
    ccx = [[title, f"{get(f'ccx/{order}', 'nodes'):,.0f}", number(get(f"ccx/{order}", "error")), number(get(f"ccx/{order}", "tones"))]
           for order, title in {1: "linear", 2: "quadratic"}.items()]
    return {
        CHAPTER / "in_depth.md": {
            "<!-- table: benchmark/measured.csv tets -->":
                with_heads(["", "a step [ms]", "residual", "systems", "factors"], tets),
            "<!-- table: benchmark/measured.csv factor -->":
                with_heads(["", "numbers in the factor", "factor [ms]", "solution [ms]", "residual"], factor),
            "<!-- table: benchmark/measured.csv soft -->":
                with_heads(["scene", "tetrahedra", "rows", "a factor for each iteration [ms]", "kept while it serves [ms]"], soft),
            "<!-- table: benchmark/measured.csv net -->": with_heads(["method", "error", "a step [µs]"], net),
            "<!-- table: benchmark/measured.csv beam -->":
                with_heads(["", "steps", "error", "half a second [ms]"], beam),
            "<!-- table: benchmark/measured.csv ccx -->":
                with_heads(["tetrahedra", "nodes", "rest", "vibrations"], ccx)}}


def main():
    if len(sys.argv) > 2:
        raise SystemExit(__doc__)
    check = sys.argv[1:] == ["--check"]
    rows = {}
    if MEASURED.exists():
        with open(MEASURED, newline="", encoding="utf-8") as stream:
            rows = {name: numbers for name, *numbers in list(csv.reader(stream))[1:]}
    if len(sys.argv) == 2 and not check:
        rows.update(rows_of(sys.argv[1]))
    pages = tables_of(rows)
    if check:
        faults = [f"{page.relative_to(CHAPTER.parents[1])}: the table at {place} is not that of its file; run "
                  f"{pathlib.Path(__file__).resolve().relative_to(CHAPTER.parents[1])}."
                  for page, tables in pages.items() for place in stale(page, tables)]
        print("\n".join(faults), end="\n" if faults else "")
        sys.exit(1 if faults else 0)
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([["name", *COLUMNS], *([name, *numbers] for name, numbers in rows.items())])
    MEASURED.write_text(text.getvalue(), encoding="utf-8")
    for page, tables in pages.items():
        put_all(page, tables)


if __name__ == "__main__":
    main()
