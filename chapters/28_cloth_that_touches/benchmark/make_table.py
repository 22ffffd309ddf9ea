#!/usr/bin/env python3
"""Writes the measured tables of chapters 27 and 28 from their benchmarks' tables, and takes over the measured figures.

    make_table.py           from build/bench/NAME/benchmark.csv, which `./book bench 27` and `./book bench 28` leave there
    make_table.py --bench   runs those two first; on a machine that does nothing else

A table of a text keeps its rows, which say what is measured; their numbers are written anew. What a sentence says is printed.
"""
import csv
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
CHAPTERS = {27: "27_particles_and_cloth", 28: "28_cloth_that_touches"}
FIGURES = {27: ["ch27_pareto", "ch27_master"], 28: ["ch28_pareto", "ch28_grow"]}
FRONT = {"rows (XPBD)": "small", "threads": "threads", "threads, limit": "threads_limit"}


def measured(number):
    """The lines of a benchmark by `group/method/argument`."""
    path = ROOT / "build" / "bench" / CHAPTERS[number] / "benchmark.csv"
    lines = path.read_text(encoding="utf-8").splitlines()
    head = next(i for i, line in enumerate(lines) if line.startswith("name,"))
    return {"/".join(row["name"].split("/")[:3]): {key: float(value) for key, value in row.items()
                                                   if key in ("us", "position", "mean", "largest", "particles")}
            for row in csv.DictReader(lines[head:])}


def digits(value, count=2):
    """Two significant digits, without an exponent."""
    text = f"{float(f'{value:.{count}g}'):.10f}".rstrip("0").rstrip(".")
    return f"{int(text):,}" if "." not in text else text


def renew(path, header, numbers):
    """Below a header of a table, whose first two columns are a method and a count, writes what numbers(method, count) gives."""
    lines = path.read_text(encoding="utf-8").split("\n")
    at = lines.index(header) + 2
    method = ""
    while lines[at].startswith("|"):
        cells = [cell.strip() for cell in lines[at].strip("|").split("|")]
        method = cells[0] or method
        lines[at] = f"| {cells[0]} | {cells[1]} | ".replace("|  |", "| |") + " | ".join(numbers(method, cells[1])) + " |"
        at += 1
    path.write_text("\n".join(lines), encoding="utf-8")


def main():
    if sys.argv[1:] == ["--bench"]:
        for number in CHAPTERS:
            subprocess.run([ROOT / "book", "bench", str(number)], cwd=ROOT, check=True)
    hung, touching = measured(27), measured(28)
    for number, names in FIGURES.items():
        for name in names:
            shutil.copy(ROOT / "build" / "bench" / CHAPTERS[number] / f"{name}.svg",
                        ROOT / "chapters" / CHAPTERS[number] / "figures" / f"{name}.svg")

    def on_a_sheet(method, count):
        line = hung[f"sheet/{method}/{count}"]
        return [digits(line["us"], 3), digits(1000 * line["position"])]

    def ten_thousand(method, count):
        line, unit = touching[f"front/{FRONT[method]}/{count}"], touching["front/small/8"]["us"]
        return [digits(line["us"] / unit), digits(line["us"] / 1000), digits(line["mean"]), digits(line["largest"])]

    renew(ROOT / "chapters" / CHAPTERS[27] / "in_depth.md",
          "| method | sub-steps | time of a step [µs] | error [mm] |", on_a_sheet)
    renew(ROOT / "chapters" / CHAPTERS[28] / "README.md",
          "| method | sub-steps | time | in ms | mean stretch [%] | largest [%] |", ten_thousand)
    for name, line in {**hung, **touching}.items():
        if name.split("/")[0] in ("self", "sleep") or "/bt_" in name:
            print(f"{name}: {line['us'] / 1000:.2g} ms, {line['particles']:.0f} particles, {1000 * line['position']:.2g} mm off")
    return 0


if __name__ == "__main__":
    sys.exit(main())
