"""Tables 8.1 and 8.2 from what `./book bench 8` measured.

    make_table.py CSV            prints them
    make_table.py CSV README     puts each where it stands in the text: above the paragraph with its caption

A preset wins where it is no slower than the faster of two engines and no less exact than the more exact one in the largest
error of a length or a gap, the same in the second half of the steps, the drift of the centre of mass, and the speed at rest.
What is right to 0.001 mm counts as right: floats of metres hold no more.
"""

import math
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "docs" / "tools"))
from put_table import benchmark_rows, put_all  # noqa: E402

PEERS = ("box2d", "chipmunk")
#              what both sides have, ours from fast to slow, the end of the engines' names
COMPARISONS = [("own numbers of iterations, *quick* or *careful*", ("quick", "careful"), ""),
               ("8 small steps of one iteration, *quick*", ("quick",), "_8"),
               ("32 small steps of one iteration, *quick* or *careful* with 32", ("quick_32", "careful_32"), "_32")]


class Run:
    def __init__(self, row):
        number = {key: float(row[key]) for key in
                  ("real_time", "link_mm", "overlap_mm", "late_mm", "drift_mm", "speed_mm_s", "in_order")}
        self.us = number["real_time"]
        self.error = max(number["link_mm"], number["overlap_mm"])
        self.drift = number["drift_mm"]
        self.in_order = number["in_order"] == 1
        self.errors = [self.error, number["late_mm"], self.drift, number["speed_mm_s"]]


def read(file):
    """scene → who → run, in the order of the file."""
    scenes = {}
    for row in benchmark_rows(file):
        part = row["name"].split("/")
        if part[0] == "engines":
            scenes.setdefault(part[1], {})[part[2]] = Run(row)
    return scenes


def judged(scene, run):
    errors = run.errors if not scene.startswith("swinging") else run.errors[:3]
    return [max(error, 1e-3) for error in errors]


def verdict(scene, runs, ours, end):
    """(the fastest preset that wins, or the fastest that keeps the order, or the fastest; whether it wins)"""
    peers = [runs[peer + end] for peer in PEERS if peer + end in runs]
    fastest = min((peer.us for peer in peers), default=math.inf)
    least = [min(values) for values in zip(*(judged(scene, peer) for peer in peers))]
    for name in ours:
        run = runs[name]
        if run.in_order and run.us <= fastest and all(a <= b for a, b in zip(judged(scene, run), least)):
            return name, True
    return next((name for name in ours if runs[name].in_order), ours[0]), False


def time_cell(run):
    return "–" if run is None else f"{run.us:.2f}" if run.us < 100 else f"{run.us:.0f}"


def cell(run, value):
    if run is None:
        return "–"
    text = "> 1 km" if not value < 1e6 else "< 0.001" if value < 1e-3 else f"{value:.3g}" if value < 1000 else f"{value:.0f}"
    return text + ("" if run.in_order else " ✗")


def scenes_table(scenes):
    _, ours, end = COMPARISONS[0]
    lines = ["| scene | preset | µs a step | Box2D | Chipmunk | error, mm | Box2D | Chipmunk | drift, mm | Box2D | Chipmunk | wins |",
             "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for scene, runs in scenes.items():
        preset, wins = verdict(scene, runs, ours, end)
        who = [runs.get(name) for name in (preset,) + tuple(peer + end for peer in PEERS)]
        cells = [time_cell(run) for run in who] + [cell(run, run and run.error) for run in who] + \
                [cell(run, run and run.drift) for run in who]
        lines.append(f"| {scene} | {preset} | {' | '.join(cells)} | {'yes' if wins else 'no'} |")
    return lines


def median(values):
    return f"{statistics.median(values):.2g}" if values else "–"


def summary_table(scenes):
    lines = ["| both sides have | scenes | a preset wins | time: Box2D, in times of ours | Chipmunk | error: Box2D, in times of ours | Chipmunk |",
             "|---|---:|---:|---:|---:|---:|---:|"]
    for title, ours, end in COMPARISONS:
        won, times, errors = 0, {peer: [] for peer in PEERS}, {peer: [] for peer in PEERS}
        for scene, runs in scenes.items():
            preset, wins = verdict(scene, runs, ours, end)
            won += wins
            for peer in PEERS:
                if peer + end in runs:
                    times[peer].append(runs[peer + end].us / runs[preset].us)
                    errors[peer].append(max(runs[peer + end].error, 1e-3) / max(runs[preset].error, 1e-3))
        cells = [median(values[peer]) for values in (times, errors) for peer in PEERS]
        lines.append(f"| {title} | {len(scenes)} | {won} | {' | '.join(cells)} |")
    return lines


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    scenes = read(sys.argv[1])
    tables = {"**Table 8.1.**": scenes_table(scenes), "**Table 8.2.**": summary_table(scenes)}
    if len(sys.argv) == 2:
        for caption, table in tables.items():
            print(f"\n{caption}\n\n" + "\n".join(table))
        return
    put_all(pathlib.Path(sys.argv[2]), tables)


if __name__ == "__main__":
    main()
