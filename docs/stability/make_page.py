"""Writes docs/stability.md from page.txt, the matrix and the mark, and stability_in_depth.md beside it from in_depth.txt. Every number of a cell is looked up here.

    docs/stability/make_page.py MATRIX MARK PAGE

In these texts stands, between « and »:

    total METHOD                     mean of all stresses, in per cent
    row METHOD / STRESS              mean of the five levels, in per cent, and the lowest score
    cell METHOD / STRESS / VALUE     mean of the perturbations of a cell, in per cent, and the lowest score
    worst METHOD                     the stresses with a cell of score 0
    gap METHOD / column              gap at four sweeps, in metres; also: chain
    zeros STRESS, cells STRESS       how many cells of a stress are ever 0, and how many there are
    far                              how many methods score the same at 1e6 m and at 100 m
    best                             the table of methods, best first
    mark                             the table of the mark
    methods                          the list of columns
    seeds                            how many runs the whole table is
    stresses                         how many stresses, in a word
    energy                           the section on gained and lost energy, from energy.csv beside the mark; nothing without it
    turning QUESTION                 the same questions of turning.csv beside the matrix: bodies that turn
    joints QUESTION                  the same of joints.csv: bodies on joints
    space QUESTION                   the same of space.csv: bodies in space
"""

import csv
import pathlib
import re
import sys

from matrix_table import Table

CHAPTERS = {3: "03_mlcp_formulation", 4: "04_pgs", 5: "05_lemke", 6: "06_sequential_impulse", 7: "07_baumgarte",
            8: "08_warm_starting", 9: "09_active_sets", 10: "10_skipping_work",
            11: "11_rotation", 12: "12_contact_manifolds", 13: "13_friction",
            14: "14_joints", 15: "15_trees", 16: "16_soft_constraints", 19: "19_engine", 25: "25_world_in_space",
            26: "26_four_ways"}


def chapter(number):
    return f"[{number}](../chapters/{CHAPTERS[number]}/README.md)"


def percent(found):
    return f"{100 * found[0]:.0f} ({found[1]})" if found else "does not apply"


ENERGY = """Nothing brakes these three linkages, so their exact energy never changes: a double pendulum of unit rods, a four-bar linkage of 30.9 J, and a chain of ten links that swings from level. Ten seconds in steps of 1/60 s, the worst of four perturbations of the masses; gains and losses in per cent of what goes up and down. In the rows of the [matrix](stability.md) that bear their names both signs count: up to 1 % is accurate, up to 10 % holds, a larger loss is a failure and a larger gain an explosion. A method that only ever loses looks stable everywhere else; here it comes to rest. `rattle` is [chapter 9](../chapters/09_active_sets/in_depth.md#9j-a-repair-that-does-no-work)'s step whose repair does no work."""


class Page:
    def __init__(self, matrix, mark):
        self.table = Table(matrix)
        self.others = {kind: Table(pathlib.Path(matrix).with_name(f"{kind}.csv")) for kind in ("turning", "joints", "space")}
        with open(mark, encoding="utf-8") as file:
            self.marks = list(csv.DictReader(file))
        beside = pathlib.Path(mark).with_name("energy.csv")
        self.energies = list(csv.DictReader(beside.open(encoding="utf-8"))) if beside.exists() else []

    def level_of(self, stress, value):
        for level, words in self.table.values[stress].items():
            if words == value:
                return level
        raise SystemExit(f"'{stress}' has no level '{value}'; it has {', '.join(self.table.values[stress].values())}")

    def other(self, kind, question):
        """A question to another table."""
        other = Page.__new__(Page)
        other.table, other.marks, other.energies = self.others[kind], [], []
        return other.fill(" / ".join(question))

    def turning(self, *question):
        return self.other("turning", question)

    def joints(self, *question):
        return self.other("joints", question)

    def space(self, *question):
        return self.other("space", question)

    def fill(self, question):
        word, _, rest = question.partition(" ")
        parts = [part.strip() for part in rest.split(" / ")] if rest else []
        return str(getattr(self, word)(*parts))

    def total(self, method):
        return f"{100 * self.table.total(method)[0]:.0f} %"

    def row(self, method, stress):
        return percent(self.table.row(stress, method))

    def cell(self, method, stress, value):
        return percent(self.table.cell(stress, self.level_of(stress, value), method))

    def worst(self, method):
        found = [stress for stress in self.table.stresses
                 if any((self.table.cell(stress, level, method) or (1, 3))[1] == 0
                        for level in self.table.values[stress])]
        return ", ".join(found) if found else "none"

    def gap(self, method, scene):
        found = [row for row in self.marks if row["method"] == method]
        if not found:
            raise SystemExit(f"the mark knows no method '{method}'")
        return self.metres(found[0], scene)

    @staticmethod
    def metres(row, scene):
        if not row[f"{scene} score"]:
            return "–"
        if row[f"{scene} score"] == "0":
            return "explodes"
        value = float(row[f"{scene} gap"])
        words = f"{value:.2g} m" if value >= 5e-4 else "below 0.5 mm"
        return words + (", falls through" if scene == "column" and row["column score"] == "1" and value >= 0.19 else "")

    def zeros(self, stress):
        return sum(lowest == 0 for (name, _, _), (_, lowest) in self.table.cells.items() if name == stress)

    def cells(self, stress):
        return sum(name == stress for name, _, _ in self.table.cells)

    def far(self):
        """How many methods score at the farthest place what they score at the nearest."""
        there = [method for method in self.table.methods if self.table.cell("far away", 1, method)]
        same = [m for m in there if self.table.cell("far away", 1, m) == self.table.cell("far away", 5, m)]
        return f"{len(same)} of {len(there)}"

    def seeds(self):
        return f"{self.table.runs:,}"

    def stresses(self):
        count = len(self.table.stresses)
        return {12: "twelve", 13: "thirteen", 14: "fourteen", 15: "fifteen", 16: "sixteen", 17: "seventeen", 18: "eighteen", 19: "nineteen", 20: "twenty", 21: "twenty-one", 22: "twenty-two"}.get(count, str(count))

    def energy(self):
        """What each method gains and loses where nothing should be gained or lost."""
        if not self.energies:
            return ""
        scenes = [name.removesuffix(" gain") for name in self.energies[0] if name.endswith(" gain")]
        lines = ["## Energy: gained and lost", "", ENERGY, "",
                 "| method | chapter | it may spend | " + " | ".join(scenes) + " |", "|---|---|---|" + "---:|" * len(scenes)]
        for row in self.energies:
            cells = [f"+{row[f'{s} gain']} −{row[f'{s} loss']}" if row[f"{s} gain"] else "gains more than 10" for s in scenes]
            lines.append(f"| {row['method']} | {chapter(int(row['chapter']))} | {row['budget']} | " + " | ".join(cells) + " |")
        return "\n".join(lines) + "\n\n"

    def best(self):
        lines = ["| method | chapter | mean | cells | of these always 3 | of these ever 0 |", "|---|---|---:|---:|---:|---:|"]
        ranking = sorted(self.table.methods, key=lambda method: -self.table.total(method)[0])
        for method in ranking:
            mean, count, zero, full = self.table.total(method)
            lines.append(f"| {method} | {chapter(self.table.chapters[method])} | {100 * mean:.0f} % | {count} | {full} | {zero} |")
        return "\n".join(lines)

    def mark(self):
        lines = ["| method | chapter | it may spend | 1000 kg on four discs | 40 links with 1000 kg |", "|---|---|---|---:|---:|"]
        for row in self.marks:
            lines.append(f"| {row['method']} | {chapter(int(row['chapter']))} | {row['budget']} | "
                         f"{self.metres(row, 'column')} | {self.metres(row, 'chain')} |")
        return "\n".join(lines)


def main():
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    page = Page(sys.argv[1], sys.argv[2])
    there = pathlib.Path(sys.argv[3])
    for text, file in (("page.txt", there), ("in_depth.txt", there.with_name(f"{there.stem}_in_depth.md"))):
        words = (pathlib.Path(__file__).parent / text).read_text(encoding="utf-8")
        file.write_text(re.sub("«([^»]*)»", lambda found: page.fill(found.group(1)), words), encoding="utf-8")


main()
