"""Draws the figures of docs/results.md from the table.

    docs/results/draw.py TABLE FOLDER
"""

import pathlib
import subprocess
import sys

import table as tables

INK = "#808080"
FRONT = "#B8808080"
#         chapter of the method: colour
COLOURS = {"1": "#AA3377", "2": "#CCBB44", "3": "#AA3377", "4": "#4477AA", "5": "#CC3311", "6": "#EE7733",
           "7": "#AA3377", "8": "#22AACC", "9": "#228833", "10": "#BBAA22", "11": "#AA3377",
           "12": "#4477AA", "13": "#CC3311", "14": "#22AACC", "15": "#22AACC", "19": "#228833", "peer": INK}
MARKS = [7, 9, 5, 13, 11, 6, 8, 4, 12, 10, 3, 2, 1, 15]
#         method: (colour or None, point type)
SMOOTH = {"explicit_euler": ("#EE7733", 1), "symplectic_euler": ("#4477AA", 7), "verlet": ("#228833", 9),
          "yoshida4": ("#AA3377", 5), "rk4": ("#CCBB44", 11), "dormand_prince": ("#CC3311", 13),
          "one_row": ("#4477AA", 6), "one_row_repaid": ("#4477AA", 4), "direct": ("#228833", 12),
          "adaptive_with_events": ("#CC3311", 13), "sequential_impulse": ("#EE7733", 7)}
GROUPS = {
    "smooth": (SMOOTH, "error [m]", {
        "kepler e=0.6 T=50": "Kepler, e = 0.6, 50 s",
        "pendulum angle=90 T=2": "pendulum from 90°, 2 s",
        "pendulum_on_a_rod angle=90 T=2": "the same, on a rod",
        "bouncing_ball drop=1 e=0.8 T=2": "bouncing ball, 2 s"}),
    "chains": (None, "error / g h", {
        "chain links=10 end_mass=1": "10 links",
        "chain links=40 end_mass=100": "40 links, 100 kg at the end",
        "chain links=200 end_mass=1": "200 links",
        "chain links=200 end_mass=1000": "200 links, 1000 kg at the end"}),
    "columns": (None, "error / g h", {
        "column discs=10 top_mass=1": "10 discs",
        "column discs=20 top_mass=1": "20 discs",
        "column discs=20 top_mass=100": "20 discs, 100 kg on top",
        "column discs=20 top_mass=10000": "20 discs, 10,000 kg on top"}),
    "heaps": (None, "error / g h", {
        "triangle base=10 discs=55": "triangle of 55 discs",
        "triangle base=44 discs=990": "triangle of 990 discs",
        "ten_discs steps=60": "the ten discs, 60 steps"}),
    "chain_runs": (None, "error / 0.1 m", {
        "hanging_chain_run links=10 end_mass=1 steps=300": "10 links, 5 s",
        "hanging_chain_run links=40 end_mass=1000 steps=300": "40 links, 1000 kg, 5 s",
        "hanging_chain_run links=200 end_mass=1 steps=300": "200 links, 5 s",
        "swinging_chain_run links=40 end_mass=1 steps=60": "40 links swing for 1 s"}),
    "heap_runs": (None, "error / 0.1 m", {
        "column_run discs=20 top_mass=1 steps=300": "20 discs, 5 s",
        "column_run discs=20 top_mass=100 steps=300": "20 discs, 100 kg on top, 5 s",
        "column_run discs=20 top_mass=10000 steps=300": "20 discs, 10,000 kg on top, 5 s",
        "triangle_run base=10 discs=55 steps=300": "triangle of 55 discs, 5 s"}),
    "rest_runs": (None, "error / 0.1 m", {
        "bins_run bins=100 discs=1000 steps=300": "1,000 discs in 100 bins, 5 s",
        "triangle_run base=44 discs=990 steps=60": "one triangle of 990 discs, 1 s"}),
    "turning_runs": (None, "error [m or rad]", {
        "box_stack_run boxes=10 top_mass=1 steps=120": "10 boxes",
        "box_stack_run boxes=20 top_mass=1 steps=120": "20 boxes",
        "box_stack_run boxes=5 top_mass=1000 steps=120": "1000 kg on 4",
        "box_pyramid_run base=20 boxes=210 steps=60": "210 boxes",
        "sliding_box_run slope=30 mu=0.3 steps=60": "a slope",
        "double_rod_run steps=60": "two rods"}),
    "joint_runs": (None, "error [m or rad]", {
        "jointed_chain_run links=50 load=1 angle=20 steps=60": "50 links swing",
        "jointed_chain_run links=50 load=1000 angle=20 steps=60": "50 links, a load of 1000 of them",
        "bridge_run planks=41 load=1000 steps=120": "41 planks, a load of 1000 of them",
        "doll_run steps=60": "a doll on stairs"}),
    "rubble": (None, "residual [m/s]", {
        "rubble contacts=20 mu=0.5": "20 contacts",
        "rubble contacts=200 mu=0.5": "200 contacts",
        "rubble contacts=2000 mu=0.5": "2,000 contacts"}),
}
# The same runs by what was counted: only methods that count in this unit.
BY_WORK = {
    "kepler e=0.6 T=50": ("Kepler", "force evaluation", "error [m]"),
    "chain links=40 end_mass=1": ("chain of 40", "row visit", "error / g h"),
    "column discs=20 top_mass=1": ("column of 20", "row visit", "error / g h"),
    "triangle base=10 discs=55": ("triangle of 55", "row visit", "error / g h")}


def styles(table, scenes, given, only=None):
    """(chapter, method) → (colour, point type), the same in all panels of a figure.

    `only`: scene → unit; methods that count something else are left out of the key.
    """
    found = {}
    used = {}
    for scene in scenes:
        for (chapter, method), curve in table.curves(scene).items():
            if only and (chapter == "peer" or not any(p.unit == only[scene] and p.work for p in curve)):
                continue
            if (chapter, method) in found:
                continue
            if given and method in given and not (only and only[scene] == "row visit"):
                found[chapter, method] = given[method]
            else:
                number = used[chapter] = used.get(chapter, -1) + 1
                found[chapter, method] = (COLOURS[chapter], MARKS[number % len(MARKS)])
    return found


def panel(table, scene, title, looks, top, bottom, label, axis="time", unit=None):
    """The gnuplot lines of one panel."""
    lines, plots = [], []

    def block(name, rows):
        lines.append(f"${name} << END")
        lines.extend(f"{x:g} {y:g}" for x, y in rows)
        lines.append("END")

    def cost(point):
        return tables.cost(point, axis) if unit in (None, point.unit) else None

    curves = {key: curve for key, curve in table.curves(scene).items() if key in looks}
    points = [point for curve in curves.values() for point in curve if cost(point) is not None]
    if not points:
        raise SystemExit(f"no {axis} on '{scene}': make the table without --work-only")
    ahead = tables.front(points, axis)
    corners = []
    for before, after in zip(ahead, ahead[1:]):
        corners += [(cost(before), before.error), (cost(after), before.error)]
    if ahead:
        corners.append((cost(ahead[-1]), max(ahead[-1].error, bottom)))
        corners = [(x, max(y, bottom)) for x, y in corners]
        block("front", corners)
        plots.append(f"$front using 1:2 with lines lw 5 lc rgb '{FRONT}' notitle")
    for number, ((chapter, method), curve) in enumerate(curves.items()):
        colour, mark = looks[chapter, method]
        able = [point for point in curve if cost(point) is not None]
        fine = sorted((cost(p), max(p.error, bottom)) for p in able if p.error <= top)
        failed = [(cost(p), top) for p in able if not p.error <= top]
        if fine:
            block(f"curve{number}", fine)
            plots.append(f"$curve{number} using 1:2 with linespoints lw 1 pt {mark} ps 0.6 lc rgb '{colour}' notitle")
        if failed:
            block(f"failed{number}", failed)
            plots.append(f"$failed{number} using 1:2 with points pt {mark} ps 0.6 lc rgb '{colour}' notitle")
    lines.append(f"set title \"{title}\" tc rgb '{INK}' offset 0,-0.5")
    lines.append(f"set ylabel \"{label}\" tc rgb '{INK}' offset 1,0")
    lines.append(f"set yrange [{bottom}:{top}]")
    lines.append("plot " + ", \\\n     ".join(plots))
    return lines


def draw(table, name, out):
    if name == "work":
        given, label, axis = None, None, "work"
        titles = BY_WORK
        there = [scene for scene in titles if scene in table.scenes()]
        looks = styles(table, there, SMOOTH, only={scene: titles[scene][1] for scene in there})
        xlabels = {scene: titles[scene][1] + "s" for scene in there}
        panels = {scene: (titles[scene][0], titles[scene][2], titles[scene][1]) for scene in there}
    else:
        given, label, scenes = GROUPS[name]
        axis = "time"
        there = [scene for scene in scenes if scene in table.scenes()]
        looks = styles(table, there, given)
        xlabels = {scene: "time [thousand row visits]" if number >= len(there) - 2 else ""
                   for number, scene in enumerate(there)}
        panels = {scene: (scenes[scene], label, None) for scene in there}
    rows = (len(there) + 1) // 2
    keys = 3
    key_lines = -(-(len(looks) + 1) // keys)
    height = 340 * rows + 18 * key_lines + 50
    low = (18 * key_lines + 74) / height
    top, bottom = (10, 1e-13)
    between = 96 if axis == "work" else 72
    script = [f"set terminal svg size 860,{height} dynamic enhanced font 'DejaVu Sans,13' linewidth 1",
              f"set output '{out / ('results_' + name + '.svg')}'",
              f"set border 3 lc rgb '{INK}'", f"set tics nomirror out tc rgb '{INK}'",
              f"set grid lc rgb '{INK}' lt 1 lw 0.2", "set logscale xy",
              "set format x '10^{%L}'; set format y '10^{%L}'; set ytics 1e2",
              "unset key",
              f"set multiplot layout {rows},2 margins 0.09,0.98,{low:.3f},{1 - 30 / height:.3f} spacing 0.10,{between / height:.3f}"]
    for scene in there:
        title, label, unit = panels[scene]
        script.append(f"set xlabel '{xlabels[scene]}' tc rgb '{INK}'")
        script += panel(table, scene, title, looks, top, bottom, label, axis, unit)
    # The key of all panels, below them: a panel of its own, so that it comes out the same everywhere.
    entries = [(("" if chapter == "peer" else chapter + ": ") + tables.words(method), colour, mark)
               for (chapter, method), (colour, mark) in looks.items()] + [("nothing is better in both", FRONT, None)]
    script += ["unset title; unset xlabel; unset ylabel; unset tics; unset border; unset grid; unset logscale",
               f"set yrange [{key_lines}:0]; set xrange [0:{keys}]",
               f"set lmargin at screen 0.06; set rmargin at screen 0.99; set bmargin at screen 0.005; "
               f"set tmargin at screen {18 * key_lines / height:.3f}"]
    plots = []
    for number, (title, colour, mark) in enumerate(entries):
        x, y = number // key_lines, number % key_lines + 0.5
        script.append(f"set label {number + 1} '{title}' at {x + 0.13},{y} left font ',11' tc rgb '{INK}'")
        look = f"lw 1 pt {mark} ps 0.7" if mark else "lw 5 pt 0"
        plots.append(f"'+' using (column(0) == 0 ? {x} : {x + 0.1}):({y}) every ::0::1 with linespoints {look} lc rgb '{colour}'")
    script.append("set samples 2")
    script.append("plot " + ", \\\n     ".join(plots))
    script.append("unset multiplot")
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    table = tables.Table(sys.argv[1])
    out = pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    for name, (_, _, scenes) in GROUPS.items():
        if any(scene in table.scenes() for scene in scenes):
            draw(table, name, out)
    if any(scene in table.scenes() for scene in BY_WORK):
        draw(table, "work", out)


if __name__ == "__main__":
    main()
