"""The table of `bin/results`, and what can be asked of it.

A scene is named with its own parameters (`links=40 end_mass=100`); what belongs to a method (`sweeps`, `substeps`,
`slop`, `tolerance`) makes the points of its curve. `unit` and `reference` say what was counted and what the error is
measured against.
"""

import csv
import math

OF_METHODS = ("sweeps", "substeps", "slop", "tolerance", "unit", "reference")
FAILED = math.inf


NAMES = {"rk4": "RK4", "yoshida4": "Yoshida 4", "verlet": "Verlet", "explicit_euler": "explicit Euler",
         "symplectic_euler": "symplectic Euler", "dormand_prince": "Dormand-Prince, adaptive",
         "adaptive_with_events": "Dormand-Prince with events", "gauss_seidel": "Gauss-Seidel", "sor": "SOR",
         "jacobi": "Jacobi", "lemke": "Lemke", "dantzig": "Dantzig", "sequential_impulse": "sequential impulses",
         "sequential_impulse_coloured": "sequential impulses, coloured", "one_shot": "dense factorisation",
         "direct": "sparse factorisation", "one_row_repaid": "one row, error repaid",
         "warm_impulses": "warm impulses", "warm": "warm sweeps", "warm_best_multiple": "warm, best multiple",
         "active_sets_warm": "active sets, warm", "exact_steps": "exact small steps", "baumgarte": "Baumgarte", "ode_dantzig": "ODE (Dantzig)",
         "bullet_dantzig": "Bullet (Dantzig)", "bullet_gauss_seidel": "Bullet (Gauss-Seidel)", "siconos_lemke": "Siconos (Lemke)", "box2d": "Box2D",
         "box2d_sleeping": "Box2D, with its sleep", "chipmunk": "Chipmunk",
         "chipmunk_sleeping": "Chipmunk, with its sleep", "block_impulse": "impulses two by two",
         "sequential_impulse_alternating": "sequential impulses, to and fro",
         "sequential_impulse_shuffled": "sequential impulses, shuffled",
         "active_sets_descent": "active sets, descent", "active_sets_proximal": "active sets, proximal",
         "skipping": "skipping step", "skipping_without_sleep": "skipping step, without sleep",
         "skipping_exact_islands": "skipping step, exact islands",
         "friction_sweeps": "warm sweeps with friction", "friction_small_steps": "small steps with friction",
         "exact_friction": "exact friction", "rods_sweeps": "warm sweeps on rods", "rods_small_steps": "small steps on rods",
         "exact_rods": "exact small steps on rods", "rattle": "RATTLE", "friction_by_lemke": "Lemke, with friction",
         "joint_sweeps": "warm sweeps on joints", "joint_small_steps": "small steps on joints", "trees": "trees",
         "trees_without_stiffness": "trees, loads not stiff", "world": "the engine", "world_sleeping": "the engine, with its sleep"}


def words(method):
    """A method's name for a reader; peers of the smooth scenes begin with `odeint_`."""
    if method.startswith("odeint_"):
        return f"odeint: {words(method[len('odeint_'):])}"
    return NAMES.get(method, method.replace("_", " "))


class Point:
    """One row of the table."""

    def __init__(self, row):
        self.chapter = row["chapter"]
        self.method = row["method"]
        self.given = dict(word.split("=", 1) for word in row["parameters"].split())
        of_scene = [word for word in row["parameters"].split() if word.split("=")[0] not in OF_METHODS]
        self.scene = " ".join([row["scene"]] + of_scene)
        self.h = float(row["h"]) if row["h"] else None
        self.sweeps = int(row["sweeps"]) if row["sweeps"] else None
        self.work = int(row["work"]) if row["work"] else None
        self.instructions = int(row["instructions"]) if row["instructions"] else None
        self.time = float(row["time_ratio"]) if row["time_ratio"] else None
        self.error = float(row["error"]) if row["error"] else FAILED
        self.status = row["status"]
        self.unit = self.given.get("unit", "none").replace("_", " ")
        self.reference = self.given.get("reference", "").replace("_", " ")

    def settings(self):
        """What the method was told, in words."""
        words = []
        for key, unit in (("sweeps", "sweeps"), ("substeps", "substeps")):
            if key in self.given and not (key == "sweeps" and self.given[key] == "1" and "substeps" in self.given):
                words.append(f"{self.given[key]} {unit if self.given[key] != '1' else unit[:-1]}")
        if "slop" in self.given:
            words.append(f"slop {1000 * float(self.given['slop']):g} mm")
        if "tolerance" in self.given:
            words.append(f"tolerance {self.given['tolerance']}")
        return ", ".join(words)


class Table:
    def __init__(self, file):
        with open(file, newline="", encoding="utf-8") as stream:
            self.points = [Point(row) for row in csv.DictReader(stream)]
        # The last line tells what a time ratio of 1 was on the machine of the table.
        self.microseconds = next((point.given["microseconds"] for point in self.points if point.method == "baseline"), None)
        self.points = [point for point in self.points if point.method != "baseline"]
        if not self.points:
            raise SystemExit(f"{file} is empty")

    def scenes(self):
        return list(dict.fromkeys(point.scene for point in self.points))

    def curves(self, scene):
        """(chapter, method) → its points on this scene, in the order of the table."""
        found = {}
        for point in self.points:
            if point.scene == scene:
                found.setdefault((point.chapter, point.method), []).append(point)
        if not found:
            raise SystemExit(f"the table has no scene '{scene}'")
        return found

    def point(self, scene, method, **given):
        """The one row with these parameters."""
        fitting = [point for point in self.points if point.scene == scene and point.method == method
                   and all(point.given.get(key) == str(value) for key, value in given.items())]
        if len(fitting) != 1:
            raise SystemExit(f"{len(fitting)} rows fit '{method}' on '{scene}' with {given}")
        return fitting[0]


def cost(point, axis):
    return {"time": point.time, "work": point.work, "instructions": point.instructions}[axis]


def front(points, axis="time"):
    """The points that none beats in both cost and error, the cheapest first."""
    best, kept = math.inf, []
    able = [point for point in points if cost(point, axis) is not None and point.error < FAILED]
    for point in sorted(able, key=lambda p: (cost(p, axis), p.error)):
        if point.error < best:
            best = point.error
            kept.append(point)
    return kept


def to_reach(curve, target, axis="time"):
    """The cost at which a method's error falls below the target, or None.

    Where the points are a ladder (steps, sweeps, tolerances): for good, and read off the straight line through
    the logarithms of the points around it. Where a method runs a scene for seconds, more work need not be better:
    the cheapest run that is good enough.
    """
    if curve and curve[0].scene.split()[0].endswith("_run"):
        enough = [cost(point, axis) for point in curve if point.error <= target and cost(point, axis) is not None]
        return min(enough, default=None)
    points = [point for point in curve if cost(point, axis) is not None]
    points.sort(key=lambda p: cost(p, axis))
    first = len(points)
    while first > 0 and points[first - 1].error <= target:
        first -= 1
    if first == len(points):
        return None
    here = points[first]
    if first == 0:
        return cost(here, axis)
    before = points[first - 1]
    if not before.error < FAILED or not here.error > 0:
        return cost(here, axis)
    share = math.log(before.error / target) / math.log(before.error / here.error)
    return math.exp(math.log(cost(before, axis)) +
                    share * (math.log(cost(here, axis)) - math.log(cost(before, axis))))


def slope(pairs):
    """The exponent p of y = c x^p, fitted to the logarithms; None for fewer than three points."""
    logs = [(math.log(x), math.log(y)) for x, y in pairs if x and y and x > 0 and 0 < y < FAILED]
    if len(logs) < 3:
        return None
    n = len(logs)
    mx, my = sum(x for x, _ in logs) / n, sum(y for _, y in logs) / n
    xx = sum((x - mx) ** 2 for x, _ in logs)
    return sum((x - mx) * (y - my) for x, y in logs) / xx if xx > 0 else None


def order(curve):
    """How the error falls with the work: fitted where it is neither saturated nor rounding."""
    return slope([(point.work, point.error) for point in curve if 1e-10 < point.error < 0.1])


def cheapest(table, scene, target, without=(), axis="time"):
    """[(cost, chapter, method)] of all that reach the target, the cheapest first."""
    found = []
    for (chapter, method), curve in table.curves(scene).items():
        if chapter in without:
            continue
        value = to_reach(curve, target, axis)
        if value is not None:
            found.append((value, chapter, method))
    return sorted(found)
