"""Writes docs/results.md from the table. Every number in its sentences is looked up here.

    docs/results/make_page.py TABLE PAGE
"""

import pathlib
import sys

import table as tables
from table import FAILED, words

BOOK = tuple("123456789") + ("10",)
CHAPTERS = {"1": "01_euler_integration", "2": "02_velocity_constraints", "3": "03_mlcp_formulation", "4": "04_pgs",
            "5": "05_lemke", "6": "06_sequential_impulse", "7": "07_baumgarte", "8": "08_warm_starting",
            "9": "09_active_sets", "10": "10_skipping_work"}


# ---- numbers and names as a reader wants them ---------------------------------------------------------------------

def amount(value):
    """Two significant digits, in plain figures: 0.27, 3.1, 120, 15,000."""
    if value is None:
        return "–"
    rounded = float(f"{value:.2g}")
    if rounded >= 10:
        return f"{rounded:,.0f}"
    return f"{rounded:.2g}"


def power(value):
    """1e-06 → $10^{-6}$; 2.3e-5 → $2.3 \\cdot 10^{-5}$; 0.02 as it is."""
    if value == 0:
        return "0"
    if not value < FAILED:
        return "∞"
    mantissa, exponent = f"{value:.1e}".split("e")
    if -3 <= int(exponent) <= 3:
        return f"{float(f'{value:.2g}'):g}"
    if mantissa == "1.0":
        return f"$10^{{{int(exponent)}}}$"
    return f"${mantissa} \\cdot 10^{{{int(exponent)}}}$"


def chapter_link(number, root):
    if number == "peer":
        return "another program"
    if not (root / "chapters" / CHAPTERS[number] / "README.md").exists():
        return f"chapter {number}"
    return f"[chapter {number}](../chapters/{CHAPTERS[number]}/README.md)"


def times(ratio):
    return "as long" if ratio < 1.05 else f"{amount(ratio)} times as long"


# ---- the answers at the top -----------------------------------------------------------------------------------------

def best_error(curve):
    return min(point.error for point in curve)


def verdict(table, scene, target, others, root):
    """Two sentences: who is cheapest at this error, and what the others need for it."""
    ranking = [entry for entry in tables.cheapest(table, scene, target) if entry[1] in BOOK]
    if not ranking:
        nearest = min(((best_error(curve), key) for key, curve in table.curves(scene).items() if key[0] in BOOK))
        return (f"nothing reaches {power(target)} here; {words(nearest[1][1])} come nearest with "
                f"{power(nearest[0])}", "–")
    least, chapter, method = ranking[0]
    need = {entry[2]: entry[0] for entry in tables.cheapest(table, scene, target)}
    curves = {key[1]: curve for key, curve in table.curves(scene).items()}
    slower, never, faster = [], [], []
    for other in others:
        if other == method or other not in curves:
            continue
        if other not in need:
            best = best_error(curves[other])
            never.append(f"{words(other)} ({power(best)})" if best < FAILED else f"{words(other)} (falls)")
        elif need[other] >= least:
            slower.append(f"{words(other)} {times(need[other] / least)}")
        else:
            faster.append(f"{words(other)} {amount(100 * need[other] / least)} % of that")
    because = f"error {power(target)} in {amount(least)} time units"
    if slower or faster:
        because += "; " + ", ".join(faster + slower)
    if never:
        because += "; at no cost tried: " + ", ".join(never)
    return because, f"{words(method)}, {chapter_link(chapter, root)}"


WHEN = [
    # what a reader has, scene, error wanted, with what to compare
    ("a smooth motion, nothing touches", "kepler e=0.6 T=50", 1e-6,
     ("symplectic_euler", "verlet", "yoshida4", "rk4")),
    ("a ball that bounces", "bouncing_ball drop=1 e=0.8 T=2", 1e-2, ("sequential_impulse",)),
    ("a tall column, as a game runs it", "column_run discs=20 top_mass=1 steps=300", 1e-2,
     ("gauss_seidel", "baumgarte", "warm", "small_steps", "lemke", "active_sets_warm", "box2d", "chipmunk")),
    ("a long chain", "hanging_chain_run links=200 end_mass=1 steps=300", 1e-2,
     ("gauss_seidel", "baumgarte", "warm", "small_steps", "active_sets_warm", "box2d", "chipmunk")),
    ("a heavy load: 1000 kg on 40 links", "hanging_chain_run links=40 end_mass=1000 steps=300", 1e-2,
     ("gauss_seidel", "warm", "small_steps", "active_sets_warm", "box2d", "chipmunk")),
    ("a heavy load: 10,000 kg on 19 discs", "column_run discs=20 top_mass=10000 steps=300", 1e-2,
     ("gauss_seidel", "warm", "small_steps", "lemke", "active_sets_warm", "box2d", "chipmunk")),
    ("a thousand resting bodies", "triangle_run base=44 discs=990 steps=60", 1e-2,
     ("gauss_seidel", "sequential_impulse", "warm", "small_steps", "careful_small_steps", "box2d", "chipmunk")),
    ("exact impulses of one step, links", "chain links=200 end_mass=1000", 1e-6,
     ("one_shot", "gauss_seidel", "sor", "conjugate_gradients", "active_sets", "ode_dantzig", "bullet_dantzig")),
    ("exact impulses of one step, contacts", "column discs=20 top_mass=10000", 1e-6,
     ("gauss_seidel", "sor", "lemke", "active_sets", "ode_dantzig", "bullet_dantzig", "siconos_lemke")),
]


def when(table, root):
    lines = ["| you have | take | because |", "|---|---|---|"]
    for have, scene, target, others in WHEN:
        if scene not in table.scenes():
            continue
        because, take = verdict(table, scene, target, others, root)
        lines.append(f"| {have} | {take} | {because} |")
    return lines


# ---- the tables -----------------------------------------------------------------------------------------------------

def reach_table(table, scenes, target, axis="time"):
    """Rows are methods, columns scenes: what it costs to reach an error."""
    there = {scene: title for scene, title in scenes.items() if scene in table.scenes()}
    methods = list(dict.fromkeys(key for scene in there for key in table.curves(scene)))
    lines = ["| chapter | method | " + " | ".join(there.values()) + " |", "|---|---|" + "---:|" * len(there)]
    best = {scene: (tables.cheapest(table, scene, target, axis=axis) or [(None,)])[0][0] for scene in there}
    for key in methods:
        cells = []
        for scene in there:
            curve = table.curves(scene).get(key)
            value = tables.to_reach(curve, target, axis) if curve else None
            if not curve:
                cells.append("")
            elif value is None:
                cells.append("never")
            else:
                cells.append(f"**{amount(value)}**" if value == best[scene] else amount(value))
        lines.append(f"| {'' if key[0] == 'peer' else key[0]} | {words(key[1])} | " + " | ".join(cells) + " |")
    return lines


def order_table(table, scenes):
    there = {scene: title for scene, title in scenes.items() if scene in table.scenes()}
    methods = list(dict.fromkeys(key for scene in there for key in table.curves(scene)))
    lines = ["| chapter | method | " + " | ".join(there.values()) + " |", "|---|---|" + "---:|" * len(there)]
    for key in methods:
        cells = []
        for scene in there:
            fitted = tables.order(table.curves(scene).get(key, []))
            cells.append("" if fitted is None else f"{-fitted:.2f}")
        if any(cells):
            lines.append(f"| {'' if key[0] == 'peer' else key[0]} | {words(key[1])} | " + " | ".join(cells) + " |")
    return lines


def growth_table(table, name, parameter, sizes, rest, target):
    """How the time to reach an error grows with the size of a scene."""
    scenes = [f"{name} {parameter}={size} {rest}".strip() for size in sizes]
    if any(scene not in table.scenes() for scene in scenes):
        return []
    lines = ["| chapter | method | " + " | ".join(f"{parameter} {size}" for size in sizes) + " | grows like |",
             "|---|---|" + "---:|" * (len(sizes) + 1)]
    for key in table.curves(scenes[0]):
        values = [tables.to_reach(table.curves(scene).get(key, []), target) for scene in scenes]
        if all(value is None for value in values):
            continue
        fitted = tables.slope([(size, value) for size, value in zip(sizes, values) if value])
        cells = [amount(value) if value else "never" for value in values]
        lines.append(f"| {'' if key[0] == 'peer' else key[0]} | {words(key[1])} | " + " | ".join(cells) +
                     (f" | $N^{{{fitted:.1f}}}$ |" if fitted is not None else " | |"))
    return lines


def failures(table):
    """Who failed where: no answer, or one that is off by all there is."""
    found = {}
    for point in table.points:
        if point.error > 1 and point.given.get("sweeps") not in ("1", "4"):
            found.setdefault((point.chapter, point.method, point.scene), []).append(point)
    lines = ["| chapter | method | scene | runs | smallest error among them | how they ended |", "|---|---|---|---:|---:|---|"]
    for (chapter, method, scene), points in found.items():
        ends = ", ".join(sorted({point.status for point in points}))
        lines.append(f"| {'' if chapter == 'peer' else chapter} | {words(method)} | `{scene}` | {len(points)} | "
                     f"{power(min(p.error for p in points))} | {ends} |")
    return lines


def details(summary, lines):
    return ["<details>", f"<summary>{summary}</summary>", "", *lines, "", "</details>", ""]


GROUPS = [
    ("smooth", "Smooth motion", "Kepler's orbit, a pendulum as an angle, the same pendulum as a disc on a rod, and a ball "
     "that bounces. Error: distance from the exact place at the end, in metres."),
    ("chains", "The impulses of one step: hanging chains", "Rows and velocities after gravity are given, impulses are "
     "wanted. Error: the largest velocity that is left, as a share of the free fall of the step."),
    ("columns", "The impulses of one step: columns", "The same for discs that stand on each other. A contact can only "
     "push; conjugate gradients and the plain factorisations cannot take it."),
    ("heaps", "The impulses of one step: heaps", "Triangles of discs, where more contacts touch than motions are there to "
     "be stopped, and sixty steps of the ten discs in the middle of their tumble, in turn."),
    ("chain_runs", "Seconds of a chain, as an engine runs it", "Steps of 1/60 s. Error: the largest error of a link's "
     "length, overlap, or way of the centre of mass from where it belongs, over all steps, in units of 0.1 m."),
    ("heap_runs", "Seconds of columns and heaps", "The same for columns between two walls and for triangles of discs. A heap "
     "whose discs change places has failed, whatever its overlaps are."),
]


def page(table, root):
    import draw
    pieces = ["# Run time against error", "",
              "**Every method of this book on the same scenes: what it costs, and how wrong it is.** Made by "
              "`./book bench` from [its table](results/results.csv); no number on this page was typed in.", "",
              "## Which method, when", ""]
    pieces += when(table, root)
    pieces += ["", "A time unit is a thousand row visits: one sweep over a thousand rows, measured in the same process "
               "(`docs/results/baseline.hpp`). Errors are relative: to the free fall of one step, or to the length of a link and the radius of a "
               "disc, 0.1 m; of smooth motions they are in metres. *Never* means: not within what was tried.", ""]
    pieces += ["How to read the figures: each dot is a run, below is more accurate, left is faster. The grey staircase joins "
               "the runs that no other beats in both. Runs at the upper edge have failed; they are there because a method that fails "
               "is an answer too.", ""]
    for name, title, text in GROUPS:
        scenes = draw.GROUPS[name][2]
        there = [scene for scene in scenes if scene in table.scenes()]
        if not there:
            continue
        pieces += [f"## {title}", "", text, "",
                   f"![Error against time on log-log axes, {len(there)} panels: {'; '.join(scenes[scene] for scene in there)}.]"
                   f"(results/figures/results_{name}.svg)", ""]
        pieces += [f"Time to reach an error of {power(1e-4)} (least in bold):", ""]
        pieces += reach_table(table, scenes, 1e-4) + [""]
        for target in (1e-2, 1e-6):
            pieces += details(f"The same for an error of {target:g}", reach_table(table, scenes, target))
        if name == "smooth":
            pieces += ["How the error falls with the work: the fitted exponents. 1 means: twice the work, half the error.", ""]
            pieces += order_table(table, scenes) + [""]
        if name == "chains":
            pieces += [f"How the time to reach {power(1e-2)} grows with the number of links, end mass 1 kg:", ""]
            pieces += growth_table(table, "chain", "links", (10, 40, 200), "end_mass=1", 1e-2) + [""]
    pieces += ["## What failed", "", "All runs with an error above 1 that had more than four sweeps: an answer that is as wrong as none.", ""]
    pieces += details("Failures", failures(table))
    references = sorted({(point.scene.split()[0], point.reference) for point in table.points})
    units = {}
    for point in table.points:
        units.setdefault(point.unit, set()).add(words(point.method))
    pieces += ["## What was counted, and against what", "",
               "The table has the work of each run in the unit of its kind:", "", "| unit | methods |", "|---|---|"]
    pieces += [f"| {unit} | {', '.join(sorted(methods))} |" for unit, methods in sorted(units.items())]
    pieces += ["", "No error is measured against the method itself:", "", "| scene | reference |", "|---|---|"]
    pieces += [f"| `{scene}` | {reference} |" for scene, reference in references]
    instructions = sum(1 for point in table.points if point.instructions)
    pieces += ["", f"The table has {len(table.points)} runs on {len(table.scenes())} scenes; of {instructions} the instructions were "
               "counted too. It was made by the release build, portable code, so that work, instructions and time belong to the same "
               "program, and the peers are what the distribution ships. Their times leave out what it takes to fill their own matrix or world.", "",
               "## Make it yourself", "",
               "```sh", "./book bench            # about ten minutes; goes on where it was stopped",
               "./book bench --quick    # a minute", "ctest --preset release -L results   # is the counted work what it was?", "```", ""]
    return "\n".join(pieces)


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    root = pathlib.Path(__file__).resolve().parent.parent.parent
    pathlib.Path(sys.argv[2]).write_text(page(tables.Table(sys.argv[1]), root), encoding="utf-8")


if __name__ == "__main__":
    main()
