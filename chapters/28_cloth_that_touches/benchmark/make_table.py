#!/usr/bin/env python3
"""Writes the measured tables of chapters 27 and 28 from their benchmarks' tables, and takes over the measured figures.

    make_table.py            from build/bench/NAME/benchmark.csv, which `./book bench 27` and `./book bench 28` leave there
    make_table.py --bench    runs those two first; on a machine that does nothing else
    make_table.py --counted  no times and no figures: only what each run of the same program has alike

A table of a text keeps its rows, which say what is measured; their numbers are written anew. A row of which the benchmark has
no line stays as it is, and is named; what a sentence says is printed.
"""
import csv
import math
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
CHAPTERS = {27: "27_particles_and_cloth", 28: "28_cloth_that_touches"}
FIGURES = {27: ["ch27_pareto", "ch27_master"], 28: ["ch28_pareto", "ch28_grow"]}
FRONT = {"rows (XPBD)": "small", "threads": "threads", "threads, limit": "threads_limit"}
COLUMNS = ("us", "position", "stretch", "energy", "visits", "solves", "mean", "largest", "particles", "entries", "bytes")
GROWN = ("small", "threads", "particles", "projective", "implicit")
SUBSTEPS = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512)
WORK, TIME = 40, 1000  # visits of each row in a step; µs a step
NONE = "–"


def measured(number):
    """The lines of a benchmark by `group/method/argument`."""
    path = ROOT / "build" / "bench" / CHAPTERS[number] / "benchmark.csv"
    lines = path.read_text(encoding="utf-8").splitlines()
    head = next(i for i, line in enumerate(lines) if line.startswith("name,"))
    return {"/".join(row["name"].split("/")[:3]): {key: float(value) for key, value in row.items() if key in COLUMNS}
            for row in csv.DictReader(lines[head:])}


def digits(value, count=2):
    """So many significant digits, without an exponent."""
    if not math.isfinite(value):
        return "lost"
    if value < 1e-6:
        return "0"
    text = f"{float(f'{value:.{count}g}'):.10f}".rstrip("0").rstrip(".")
    return f"{int(text):,}" if "." not in text else text


def renew(path, header, numbers, fixed=2):
    """Below a header of a table, whose first columns say what is measured, writes what numbers(those cells) gives; an empty
    first cell is that above."""
    lines = path.read_text(encoding="utf-8").split("\n")
    at = lines.index(header) + 2
    method = ""
    while lines[at].startswith("|"):
        all_cells = [cell.strip() for cell in lines[at].strip("|").split("|")]
        cells = all_cells[:fixed]
        method = cells[0] or method
        try:
            new = [old if cell is None else cell for cell, old in zip(numbers(method, *cells[1:]), all_cells[fixed:], strict=True)]
            lines[at] = ("| " + " | ".join([*cells, *new]) + " |").replace("|  |", "| |")
        except KeyError as missing:
            print(f"{path.parent.name}: the benchmark has no line {missing}; its row stays as it is")
        at += 1
    path.write_text("\n".join(lines), encoding="utf-8")


def main():
    if sys.argv[1:] == ["--bench"]:
        for number in CHAPTERS:
            subprocess.run([ROOT / "book", "bench", str(number)], cwd=ROOT, check=True)
    timed = sys.argv[1:] != ["--counted"]
    hung, touching = measured(27), measured(28)
    for number, names in FIGURES.items() if timed else ():
        for name in names:
            shutil.copy(ROOT / "build" / "bench" / CHAPTERS[number] / f"{name}.svg",
                        ROOT / "chapters" / CHAPTERS[number] / "figures" / f"{name}.svg")

    def time(value, count=2):
        return digits(value, count) if timed else None

    def on_a_sheet(method, count):
        line = hung[f"sheet/{method}/{count}"]
        return [time(line["us"], 3), digits(1000 * line["position"])]

    def ten_thousand(method, count):
        line, unit = touching[f"front/{FRONT[method]}/{count}"], touching["front/small/8"]["us"]
        return [time(line["us"] / unit), time(line["us"] / 1000), digits(line["mean"]), digits(line["largest"])]

    def beside(scene, lines):
        """A method with as many sub-steps as the work allows, then as many as the time does."""
        def within(method, column, most):
            runs = {n: lines[f"{scene}/{method}/{n}"] for n in SUBSTEPS if f"{scene}/{method}/{n}" in lines}
            allowed = [n for n, line in runs.items() if line[column] <= most]
            if not runs:
                raise KeyError(f"{scene}/{method}")
            if not allowed:
                return [NONE] * 4
            n = max(allowed)
            line = runs[n]
            return [str(n), digits(1000 * line["position"]), digits(100 * line["stretch"]), digits(100 * line["energy"])]

        def both(method):
            rows = lines[f"{scene}/threads/1"]["visits"]
            return within(method, "visits", 1.01 * WORK * rows) + (within(method, "us", TIME) if timed else [None] * 4)

        return both

    def of_threads(method, count):
        line = hung[f"net/{method}/{count}"]
        return [time(line["us"], 3), digits(1000 * line["position"]), digits(line["largest"]), digits(100 * line["energy"])]

    def larger_net(particles):
        squares = {"121": 10, "1,024": 31, "10,000": 99}[particles]
        line = hung[f"threads/factor/{squares}"]
        return [time(line["us"] / 1000), digits(line["solves"]), digits(line["entries"]), digits(line["bytes"] / 1000)]

    def grown(column):
        squares = {"121": 10, "1,024": 31, "10,000": 99, "99,856": 315}
        return lambda particles: [
            (time if column == "us" else digits)(touching[f"grow/{method}/{squares[particles]}"][column] / 1000) for method in GROWN]

    depth = {number: ROOT / "chapters" / name / "in_depth.md" for number, name in CHAPTERS.items()}
    renew(depth[27], "| method | sub-steps | time of a step [µs] | error [mm] |", on_a_sheet)
    for scene, lines, page in (("sheet", hung, 27), ("strip", hung, 27), ("flag", hung, 27), ("ball", touching, 28)):
        renew(depth[page], f"| {scene} " + 2 * "| sub-steps | way [mm] | stretch [%] | energy [%] " + "|", beside(scene, lines), 1)
    renew(depth[27], "| net | sub-steps | time of a step [µs] | way [mm] | largest stretch [%] | energy [%] |", of_threads)
    renew(depth[27], "| particles | a step [ms] | systems | numbers in the factor, a row | kB a particle |", larger_net, 1)
    heads = "XPBD | threads | particles | one matrix | conjugate gradients |"
    renew(depth[28], f"| particles, ms a step | {heads}", grown("us"), 1)
    renew(depth[28], f"| particles, kB a particle | {heads}", grown("bytes"), 1)
    renew(ROOT / "chapters" / CHAPTERS[28] / "README.md",
          "| method | sub-steps | time | in ms | mean stretch [%] | largest [%] |", ten_thousand)
    for name, line in {**hung, **touching}.items():
        if timed and (name.split("/")[0] in ("self", "sleep") or "/bt_" in name):
            print(f"{name}: {line['us'] / 1000:.2g} ms, {line['particles']:.0f} particles, {1000 * line['position']:.2g} mm off")
    return 0


if __name__ == "__main__":
    sys.exit(main())
