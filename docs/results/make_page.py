"""Writes docs/results.md from the table. Every number in its sentences is looked up here.

    docs/results/make_page.py TABLE PAGE
    docs/results/make_page.py --check TABLE PAGE     only says whether the page is that of the table
    docs/results/make_page.py --tables TABLE         prints the long tables: what each method needs in each scene, and what failed
"""

import pathlib
import sys

import table as tables
from table import FAILED, words

WAYS_ON = "[Contents](../README.md) · [Back: Conventions](conventions.md) · [Next: Stability](stability.md)"
BOOK = tuple("123456789") + ("10", "11", "12", "13", "14", "15", "19")
CHAPTERS = {"1": "01_euler_integration", "2": "02_velocity_constraints", "3": "03_mlcp_formulation", "4": "04_pgs",
            "5": "05_lemke", "6": "06_sequential_impulse", "7": "07_baumgarte", "8": "08_warm_starting",
            "9": "09_active_sets", "10": "10_skipping_work",
            "11": "11_rotation", "12": "12_contact_manifolds", "13": "13_friction", "14": "14_joints", "15": "15_trees",
            "19": "19_engine"}


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


# ---- the answers at the top -----------------------------------------------------------------------------------------

def best_error(curve):
    return min(point.error for point in curve)


def verdict(table, scene, target, others, root):
    """Three cells: what to take, what it costs, and what the others need for the same error."""
    ranking = [entry for entry in tables.cheapest(table, scene, target) if entry[1] in BOOK]
    curves = {key[1]: curve for key, curve in table.curves(scene).items()}
    if not ranking:
        nearest = min(((best_error(curve), key) for key, curve in table.curves(scene).items() if key[0] in BOOK))
        return (f"nothing; nearest: {words(nearest[1][1])}, {chapter_link(nearest[1][0], root)}",
                f"error {power(nearest[0])}", "")
    least, chapter, method = ranking[0]
    need = {entry[2]: entry[0] for entry in tables.cheapest(table, scene, target)}
    reach, never = [], []
    for other in others:
        if other == method or other not in curves:
            continue
        if other in need:
            reach.append((need[other] / least, words(other)))
        else:
            never.append(words(other))
    reach.sort()
    beside = ", ".join(f"{name} ×{amount(ratio)}" for ratio, name in reach[:MOST_BESIDE])
    if len(reach) > MOST_BESIDE:
        beside += f" to {reach[-1][1]} ×{amount(reach[-1][0])}"
    never = [name for name in never if name.removesuffix(", with its sleep") not in never or not name.endswith(", with its sleep")]
    if never:
        beside += ("; " if beside else "") + "never: " + ", ".join(never)
    return (f"**{words(method)}**, {chapter_link(chapter, root)}", amount(least), beside)


MOST_BESIDE = 3  # of the other methods that reach an error; and the last of them
ENGINES = ("box2d", "box2d_sleeping", "chipmunk", "chipmunk_sleeping")
WHEN = [
    # what a reader has, scene, error wanted, with what to compare
    ("a smooth motion, nothing touches: Kepler's orbit", "kepler e=0.6 T=50", 1e-6,
     ("symplectic_euler", "verlet", "yoshida4", "rk4", "odeint_dormand_prince")),
    ("a ball that bounces", "bouncing_ball drop=1 e=0.8 T=2", 1e-4, ("sequential_impulse",)),
    ("a tall column: 20 discs", "column_run discs=20 top_mass=1 steps=300", 1e-2,
     ("gauss_seidel", "baumgarte", "warm", "small_steps", "careful_small_steps", "lemke", "active_sets_warm", "exact_steps") + ENGINES),
    ("a long chain: 200 links", "hanging_chain_run links=200 end_mass=1 steps=300", 1e-2,
     ("gauss_seidel", "baumgarte", "warm", "small_steps", "careful_small_steps", "active_sets_warm", "exact_steps") + ENGINES),
    ("a chain that swings: 40 links, 1 s", "swinging_chain_run links=40 end_mass=1 steps=60", 0.5,
     ("gauss_seidel", "baumgarte", "warm", "small_steps", "active_sets_warm", "exact_steps") + ENGINES),
    ("a heavy load: 1000 kg on a chain of 40", "hanging_chain_run links=40 end_mass=1000 steps=300", 1e-2,
     ("gauss_seidel", "warm", "small_steps", "careful_small_steps", "active_sets_warm", "exact_steps") + ENGINES),
    ("a heavy load: 10,000 kg on a column of 20", "column_run discs=20 top_mass=10000 steps=300", 1e-2,
     ("gauss_seidel", "warm", "small_steps", "careful_small_steps", "lemke", "active_sets_warm", "exact_steps") + ENGINES),
    ("a thousand resting bodies in many piles", "bins_run bins=100 discs=1000 steps=300", 1e-2,
     ("gauss_seidel", "warm", "small_steps", "careful_small_steps", "active_sets_warm", "exact_steps", "skipping",
      "skipping_without_sleep") + ENGINES),
    ("a thousand resting bodies in one heap", "triangle_run base=44 discs=990 steps=60", 1e-2,
     ("gauss_seidel", "warm", "small_steps", "careful_small_steps", "active_sets_warm", "exact_steps", "skipping") + ENGINES),
    ("boxes with friction: a stack of 20", "box_stack_run boxes=20 top_mass=1 steps=120", 1e-2,
     ("friction_sweeps", "friction_small_steps", "exact_friction") + ENGINES),
    ("boxes with friction: 1000 kg on a stack of four", "box_stack_run boxes=5 top_mass=1000 steps=120", 1e-2,
     ("friction_sweeps", "friction_small_steps", "exact_friction") + ENGINES),
    ("boxes with friction: a pyramid of 210", "box_pyramid_run base=20 boxes=210 steps=60", 1e-2,
     ("friction_sweeps", "friction_small_steps", "exact_friction") + ENGINES),
    ("rods on pins: a double pendulum, 1 s", "double_rod_run steps=60", 1e-2,
     ("rods_sweeps", "rods_small_steps", "exact_rods", "rattle") + ENGINES),
    ("joints: a load of 1000 links on a chain of 50 that swings, 1 s", "jointed_chain_run links=50 load=1000 angle=20 steps=60", 1e-2,
     ("joint_sweeps", "joint_small_steps", "trees", "trees_without_stiffness", "world") + ENGINES),
    ("joints: a load of 1000 planks on a bridge of 41", "bridge_run planks=41 load=1000 steps=120", 1e-2,
     ("joint_sweeps", "joint_small_steps", "trees", "trees_without_stiffness", "world") + ENGINES),
    ("joints: a doll on stairs", "doll_run steps=60", 1e-2, ("joint_sweeps", "joint_small_steps", "trees", "world")),
    ("one step, exact: friction at 200 contacts", "rubble contacts=200 mu=0.5", 1e-6, ("friction_sweeps", "exact_friction")),
    ("one step, exact: 200 links, 1000 kg", "chain links=200 end_mass=1000", 1e-6,
     ("one_shot", "gauss_seidel", "sor", "conjugate_gradients", "active_sets", "ode_dantzig", "bullet_dantzig")),
    ("one step, exact: 20 discs, 10,000 kg", "column discs=20 top_mass=10000", 1e-6,
     ("gauss_seidel", "sor", "lemke", "active_sets", "ode_dantzig", "bullet_dantzig", "siconos_lemke")),
]


def when(table, root):
    lines = ["| you have | want an error of | take | time | the others, in times of that |", "|---|---|---|---:|---|"]
    for have, scene, target, others in WHEN:
        if scene not in table.scenes():
            continue
        take, cost, beside = verdict(table, scene, target, others, root)
        lines.append(f"| {have} | {power(target)} | {take} | {cost} | {beside} |")
    return lines


def best_of(entries, able):
    """The cheapest entry of tables.cheapest() whose chapter is one of `able`, or None."""
    return next((entry for entry in entries if entry[1] in able), None)


def targets_of(scene):
    """The errors at which programs are compared. What engines step has none that their slop decides: the smallest slop is
    0.05 mm, and a column of twenty that sinks by so much at each contact has moved by 0.5 mm, 0.005 of 0.1 m."""
    return (1e-1, 1e-2) if scene.split()[0].endswith("_run") else (1e-2, 1e-4, 1e-6)


def losses(table):
    """Where another program is cheaper than everything in the book, or reaches what nothing in the book reaches.

    A scene has one line, for the error at which the book loses most. Less than 5 % is no loss: clocks do that.
    """
    lines = ["| scene | errors | most at | best here | time | best elsewhere | time | ratio |",
             "|---|---:|---:|---|---:|---|---:|---:|"]
    compared = lost = 0
    for scene in table.scenes():
        if not any(key[0] == "peer" for key in table.curves(scene)):
            continue
        here = []
        for target in targets_of(scene):
            entries = tables.cheapest(table, scene, target)
            ours, theirs = best_of(entries, BOOK), best_of(entries, ("peer",))
            if not ours and not theirs:
                continue
            compared += 1
            factor = (ours[0] if ours else FAILED) / theirs[0] if theirs else 0
            if factor >= 1.05:
                here.append((factor, target, ours, theirs))
        if not here:
            continue
        lost += len(here)
        factor, target, ours, theirs = max(here, key=lambda entry: entry[0])
        lines.append(f"| {scene.replace('_', ' ')} | {', '.join(power(entry[1]) for entry in here)} | {power(target)} | "
                     f"{words(ours[2]) if ours else 'nothing'} | {amount(ours[0]) if ours else '–'} | {words(theirs[2])} | "
                     f"{amount(theirs[0])} | {'×' + amount(factor) if ours else 'never'} |")
    return lost, compared, lines


# ---- the tables -----------------------------------------------------------------------------------------------------

def reach_table(table, scenes, target, axis="time"):
    """Rows are methods, columns scenes: what it costs to reach an error. Instructions are told in thousands."""
    scale = 1000 if axis == "instructions" else 1
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
                cells.append("–" if any(tables.cost(point, axis) is None for point in curve) else "never")
            else:
                cells.append(f"**{amount(value / scale)}**" if value == best[scene] else amount(value / scale))
        lines.append(f"| {'' if key[0] == 'peer' else key[0]} | {words(key[1])} | " + " | ".join(cells) + " |")
    return lines


def short_table(table, scenes, target):
    """A line for each scene: the three cheapest ways to an error, and the cheapest of another program."""
    lines = ["| scene | least | next | then | another program |", "|---|---|---|---|---|"]
    for scene, title in scenes.items():
        if scene not in table.scenes():
            continue
        entries = tables.cheapest(table, scene, target)
        ours = [entry for entry in entries if entry[1] in BOOK][:3]
        peer = best_of(entries, ("peer",))
        cells = [f"{words(entry[2])} {amount(entry[0])}" for entry in ours] + ["–"] * (3 - len(ours))
        if ours:
            cells[0] = f"**{cells[0]}**"
        there = any(key[0] == "peer" for key in table.curves(scene))
        cells.append(f"{words(peer[2])} {amount(peer[0])}" if peer else "never" if there else "")
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    return lines


def order_table(table, scenes):
    there = {scene: title for scene, title in scenes.items() if scene in table.scenes()}
    methods = list(dict.fromkeys(key for scene in there for key in table.curves(scene) if key[0] != "peer"))
    lines = ["| chapter | method | " + " | ".join(there.values()) + " |", "|---|---|" + "---:|" * len(there)]
    for key in methods:
        cells = []
        for scene in there:
            fitted = tables.order(table.curves(scene).get(key, []))
            cells.append("" if fitted is None else f"{-fitted:.2f}")
        if any(cells):
            lines.append(f"| {'' if key[0] == 'peer' else key[0]} | {words(key[1])} | " + " | ".join(cells) + " |")
    return lines


def growth(table, name, parameter, sizes, rest, target):
    """{method: (exponent with which the time to reach an error grows with a parameter of a scene, or None where it never gets there)}."""
    scenes = [" ".join(f"{name} {parameter}={size} {rest}".split()) for size in sizes]
    if any(scene not in table.scenes() for scene in scenes):
        return {}
    found = {}
    for key in table.curves(scenes[0]):
        values = [tables.to_reach(table.curves(scene).get(key, []), target) for scene in scenes]
        if any(values):
            found[key] = tables.slope([(size, value) for size, value in zip(sizes, values)]) if all(values) else None
    return found


def growth_table(table, target):
    """How the time of one step of a chain grows with its links and with the mass at its end."""
    links = growth(table, "chain", "links", (10, 40, 200), "end_mass=1", target)
    masses = growth(table, "chain links=40", "end_mass", (1, 10, 100, 1000), "", target)

    def cell(found, key, letter):
        if key not in found:
            return ""
        return "not all reached" if found[key] is None else f"${letter}^{{{round(found[key], 1) + 0.0:.1f}}}$"
    lines = ["| chapter | method | with the links | with the mass |", "|---|---|---:|---:|"]
    lines += [f"| {'' if key[0] == 'peer' else key[0]} | {words(key[1])} | {cell(links, key, 'N')} | {cell(masses, key, 'R')} |"
              for key in dict.fromkeys([*links, *masses])
              if key[1] in ("one_shot", "direct", "gauss_seidel", "sor", "conjugate_gradients", "active_sets", "dantzig", "ode_dantzig", "bullet_gauss_seidel")]
    return lines if links and masses else []


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


GROUPS = [
    ("smooth", "Smooth motion", "Kepler's orbit, a pendulum as an angle, the same pendulum as a disc on a rod, and a ball "
     "that bounces."),
    ("chains", "One step: hanging chains", "Rows and velocities after gravity are given, impulses are "
     "wanted: what is left of the velocities when everything should rest. SOR is given the best relaxation that chapter 4's theory has for lines."),
    ("columns", "One step: columns", "The same for discs that stand on each other. A contact can only "
     "push; conjugate gradients and the plain factorisations cannot take it."),
    ("heaps", "One step: heaps", "Triangles of discs, where more contacts touch than motions are there to "
     "be stopped, and sixty steps of the ten discs in the middle of their tumble. SOR relaxes by 1.5."),
    ("chain_runs", "Seconds of a chain", "Steps of 1/60 s, as an engine takes them, from rest, a nanometre off. *Active sets, warm* is chapter 3's step with an exact "
     "answer, $b = C/h$; *exact small steps* is chapter 9's own, in 1, 4 or 16 of them."),
    ("heap_runs", "Seconds of columns and heaps", "The same for columns between two walls and for a triangle of discs. A heap "
     "whose discs change places has failed, whatever its overlaps are."),
    ("rest_runs", "A thousand resting bodies", "Nothing has to happen. In the bins, a hundred small piles, chapter 8's step is set beside chapter 10's with sleep, without sleep, and with exact answers for islands of up to 32 rows. Its sweeps end at a residual of 1 µm/s."),
    ("turning_runs", "Seconds of bodies that turn", "Boxes of 1 m with friction 0.5 that should stay where they are (stacks for 2 s, a pyramid of 210 for 1 s), a box that slides down 30° by its closed form, and a double pendulum of two rods whose angles after "
     "a second are known: metres or radians, in steps of 1/60 s. The book's ways are chapter 13's (of the pendulum, which has nothing that touches, chapter 11's): sweeps with the last impulses, small "
     "steps of one sweep, exact answers in 1, 4 or 16 sub-steps, RATTLE. Boxes of Box2D are made smaller by its polygon's skin, so that they touch where ours do."),
    ("joint_runs", "Seconds of bodies on joints", "Chains of rods at 20° that are let go, their weight's path known from the coordinates of their joints; a bridge that hangs in its closed form under a heavy plank "
     "and should stay; and a doll on stairs, of which the joints and their limits are looked at. The book's ways are chapter 14's sweeps, chapter 15's trees, and chapter 19's engine."),
    ("rubble", "One step: friction", "Random rubble: rows and velocities after gravity are given, impulses are wanted that fit Coulomb's law."),
]

#      scene: (what its error is, where the reference comes from)
ERRORS = {
    "kepler": ("distance from the exact place after 50 s [m]", "Kepler's equation, in closed form"),
    "pendulum": ("distance along the circle of 1 m after 2 s [m]", "Jacobi's elliptic functions, in closed form"),
    "pendulum_on_a_rod": ("distance from the exact place after 2 s [m]", "Jacobi's elliptic functions, in closed form"),
    "bouncing_ball": ("distance from the exact height after 2 s [m]", "parabolas from bounce to bounce, in closed form"),
    "chain": ("largest velocity of a disc after the step, over $gh$", "everything stays at rest, $u = 0$"),
    "column": ("largest velocity of a disc after the step, over $gh$", "everything stays at rest, $u = 0$"),
    "triangle": ("largest velocity of a disc after the step, over $gh$", "everything stays at rest, $u = 0$"),
    "ten_discs": ("largest difference of a velocity from the reference, over all 60 steps, over $gh$",
                  "chapter 3's enumeration of all cases; of the enumeration itself, Lemke's walk"),
    "hanging_chain_run": ("largest error of a link's length, and way of the centre of mass, in all steps, over 0.1 m",
                          "everything stays at rest, where it is to 1 nm"),
    "swinging_chain_run": ("largest error of a link's length, and way of the centre of mass from its exact path, over 0.1 m",
                           "RK4 with the exact tensions, 200 substeps a step"),
    "column_run": ("largest overlap, and way of the centre of mass, in all steps, over 0.1 m", "everything stays at rest, where it is to 1 nm"),
    "triangle_run": ("largest overlap, and way of the centre of mass, in all steps, over 0.1 m", "everything stays at rest, where it is to 1 nm"),
    "box_stack_run": ("largest way of a body from its place, or angle, in all steps [m, rad]", "everything stays at rest"),
    "box_pyramid_run": ("largest way of a body from its place, or angle, in all steps [m, rad]", "everything stays at rest"),
    "sliding_box_run": ("largest distance from the place down the slope, in all steps [m]", "constant acceleration, $g(\\sin\\alpha - \\mu\\cos\\alpha)$, in closed form"),
    "double_rod_run": ("larger error of the two angles after 1 s [rad]", "RK4 of the equations in angles, to $10^{-8}$"),
    "jointed_chain_run": ("largest error of a joint, and way of the weight from its path, in all steps [m]",
                          "RK4 in the coordinates of the joints, 128 parts of a step"),
    "bridge_run": ("largest way of a plank from its place, or angle, in all steps [m, rad]", "everything stays at rest, as statics says"),
    "doll_run": ("largest error of a joint [m], and what a limit is overstepped by [rad], in all steps", "zero"),
    "rubble": ("natural residual of Coulomb's law [m/s]", "zero"),
    "bins_run": ("largest overlap, and way of the centre of mass, in all steps, over 0.1 m", "everything stays at rest, where it is to 1 nm"),
}
UNITS = {
    "row visit": "one row solved for its own impulse, once; a check of the residual visits each row once too; in chapter 4 and in "
                 "conjugate gradients a visit multiplies one line of $A$",
    "force evaluation": "the acceleration at one place, once",
    "pivot": "one exchange of a basic variable, $O(n^2)$; for Dantzig a row that changes sides",
    "factorisation": "the active rows factored again, or an older factor corrected by a border",
    "tree row": "one row of a joint factored or solved, once, in a tree",
    "case set": "one set of cases tried and solved",
    "solve": "one exact answer to all rows of a sub-step",
    "none": "not counted: another program that does not say, or one that chooses its own steps",
}


def picture(name, titles):
    alt = f"Error against {'work' if name == 'work' else 'time'} on log-log axes, {len(titles)} panels: {'; '.join(titles)}."
    return [f"![{alt}](results/figures/results_{name}.svg)", ""]


def group(table, name, title, text):
    import draw
    scenes = draw.GROUPS[name][2]
    there = [scene for scene in scenes if scene in table.scenes()]
    if not there:
        return []
    pieces = [f"## {title}", "", text, ""] + picture(name, [scenes[scene] for scene in there])
    main = 1e-2 if name.endswith("runs") else 1e-4
    pieces += [f"Time to reach an error of {power(main)}:", ""] + short_table(table, scenes, main) + [""]
    return pieces


def long_tables(table):
    """What the page has no room for."""
    import draw
    pieces = []
    for name, title, _ in GROUPS:
        scenes = draw.GROUPS[name][2]
        there = [scene for scene in scenes if scene in table.scenes()]
        if not there:
            continue
        pieces += [f"# {title}", ""]
        for target in ((1e-1,) if name.endswith("runs") else ()) + (1e-2, 1e-4, 1e-6):
            pieces += [f"Time to reach an error of {target:g}:", "", *reach_table(table, scenes, target), ""]
        if any(point.instructions for scene in there for curve in table.curves(scene).values() for point in curve):
            main = 1e-2 if name.endswith("runs") else 1e-4
            pieces += [f"Thousand instructions to reach an error of {main:g}:", "", *reach_table(table, scenes, main, "instructions"), ""]
    pieces += ["# What failed", "", "Runs with an error above 1 that had more than four sweeps.", "", *failures(table)]
    return "\n".join(pieces)


def before_the_nudge(table):
    """A table that knows no exact_steps was measured before scenes at rest were set off and engines got small steps."""
    if any(point.method == "exact_steps" for point in table.points):
        return []
    return ["> **To be measured again.** The table below is older than the sentences beside it. Its scenes rest to the last bit, which flatters the exact "
            "steps of chapter 3: a chain that hangs straight has nothing that could tear it, and a nanometre beside the line it falls. In it engines take "
            "their own number of iterations, with a slop of 5 mm, and chapter 9's own step has no line.", ""]


def page(table, root):
    import draw
    chosen = when(table, root)
    # the engine is no curve of this page: it is what chooses among the methods
    chosen.insert(2, "| a program of your own: shapes, friction, joints | | **the engine's own choice**, "
                  "[chapter 18](../chapters/18_islands/README.md#183-each-island-by-its-own-solver): for each island an exact answer or sweeps, "
                  "whichever (18.2) and (18.3) find cheaper | | what it costs beside other engines is in "
                  "[section 19.8](../chapters/19_engine/README.md#198-measure-it); the lines below are single methods |")
    lost, compared, lines_lost = losses(table)
    pieces = ["# Run time against error", "", WAYS_ON, "",
              "**Every method of this book on the same scenes: what it costs, and how wrong it is.** Made by "
              "`./book bench` from [its table](results/results.csv); no number on this page was typed in.", "",
              *before_the_nudge(table), "## Which method, when", "",
              "In words: for smooth motion take a step of high order; for a scene that stands, small steps, and sleep as soon as it rests; for a heavy load on light things an exact answer, whose price does not depend on the masses, and likewise for friction that has to hold. Sweeps remain for heaps that are poured, where the next step comes before more digits would matter.", "", *chosen, "",
              "One time unit is a thousand row visits, measured in the same process (`docs/results/baseline.hpp`)" +
              (f"; on the machine of this table {table.microseconds} µs" if table.microseconds else "") + ". A column, a chain "
              "or a heap runs for five seconds (the one heap and the swinging chain for one) in steps of 1/60 s, and its error is a share of 0.1 m, the "
              "length of a link and the radius of a disc. What rests is set off by a nanometre, disc by disc in directions drawn by lot: a chain that hangs straight "
              "to the last bit has nothing that could tear it. *Never*: not within what was tried. A factor below 1: another program is faster. *To* names the slowest that gets there.",
              "", "## Where the book loses", ""]
    if compared:
        pieces += [f"Other programs were measured in the same run on the same problems: {compared} times a scene and an error that one of them reaches: "
                   f"0.01, 0.0001 or 0.000001 in one step, 0.1 or 0.01 in seconds of a scene. In {lost} of these another program is faster, by 5 % or more, than everything in this book:", ""]
        pieces += lines_lost if lost else []
        pieces += ["", "Solvers are timed from the rows to the impulses, the book's and the others' alike: with the assembly of $A$ and the filling of "
                   "their own matrix. Engines are timed without the building of a world, chapter 10's step too. "
                   "All are what Debian 12 ships: Box2D is 2.4.1, Chipmunk 7.0.3. Box2D 3 has another solver, and is measured in [section 19.8](../chapters/19_engine/README.md#198-measure-it).", "",
                   "Engines are given what the book's own methods have: 1, 4, 8, 16 or 32 small steps (one is with their own number of iterations, the others with "
                   "one iteration each), sleep or none, and in piles a slop of 5, 0.5 or 0.05 mm, the overlap that they leave alone on purpose; of all "
                   "these the cheapest run that is good enough counts. Chipmunk is given its slop. Box2D's is a constant of the library, so its world is made "
                   "1, 10 or 100 times as large, gravity too: the same motion, measured in our units. The book's methods have a slop of zero here. An error of 0.01 is 1 mm, "
                   "which the smallest slop allows in all these piles.", ""]
    else:
        pieces += ["No other program was installed where this table was made.", ""]
    pieces += ["## How to read the figures", "",
               "Each dot is a run: below is more accurate, left is faster, both axes are logarithmic. Dots of one method are joined as it is given more sweeps, "
               "smaller steps or a smaller tolerance. The grey staircase joins the runs that no other beats in both. Errors below "
               f"{power(1e-13)} are drawn at the lower edge. Runs at the upper edge have failed; they are there because a method that fails is an answer too.", ""]
    for name, title, text in GROUPS:
        pieces += group(table, name, title, text)
        if name == "smooth":
            pieces += ["How the error falls with the work: the fitted exponents. For fixed steps that are small enough they are the orders of the methods. 2 means: twice the work, a quarter of the error.", ""]
            pieces += order_table(table, draw.GROUPS[name][2]) + [""]
        if name == "chains":
            grows = growth_table(table, 1e-2)
            if grows:
                pieces += [f"How the time to reach {power(1e-2)} grows with the number of links $N$ (10, 40, 200 with 1 kg at the end) and with the mass $R$ at the end "
                           "(1 to 1000 kg, 40 links):", "", *grows, ""]
    there = [draw.BY_WORK[scene][0] for scene in draw.BY_WORK if scene in table.scenes()]
    pieces += ["## By counted work", "", "Time belongs to a machine, counted work does not. It can be compared among methods that count in the same unit:", ""]
    pieces += picture("work", there)
    pieces += ["## What was counted, and against what", "", "No error is measured against the method itself.", "",
               "| scene | error | reference |", "|---|---|---|"]
    pieces += [f"| `{scene}` | {what} | {against} |" for scene, (what, against) in ERRORS.items()
               if any(point.scene.split()[0] == scene for point in table.points)]
    used = {point.unit for point in table.points}
    pieces += ["", "The work of each run is counted in the unit of its kind; across kinds compare instructions or time: " +
               "; ".join(f"*{unit}*, {UNITS[unit]}" for unit in sorted(used)) + ".", ""]
    instructions = sum(1 for point in table.points if point.instructions)
    failed = sum(1 for point in table.points if point.error > 1 and point.given.get("sweeps") not in ("1", "4"))
    pieces += [f"The table has {len(table.points)} runs on {len(table.scenes())} scenes. Of {instructions} of them callgrind counted the instructions; "
               "runs that take more than 3000 time units are left to the clock. Everything was made by the release build, portable code, so that work, "
               "instructions and time belong to the same program. Columns of the table: `chapter, method, scene, parameters, h, sweeps, work, instructions, "
               "time_ratio, error, status`; what was not measured is empty. "
               f"{failed} runs that had more than four sweeps have an error above 1: an answer that is as wrong as none. What each method needs in each "
               "scene, and which runs failed, is printed by `python3 docs/results/make_page.py --tables docs/results/results.csv`.", "",
               "## Make it yourself", "",
               "```sh", "./book bench            # some minutes; goes on where it was stopped",
               "./book bench --quick    # some seconds", "ctest --preset release -L results   # is the counted work what it was?", "```", "", WAYS_ON, ""]
    return "\n".join(pieces)


def main():
    if len(sys.argv) == 3 and sys.argv[1] == "--tables":
        print(long_tables(tables.Table(sys.argv[2])))
        return
    if len(sys.argv) not in (3, 4) or len(sys.argv) == 4 and sys.argv[1] != "--check":
        raise SystemExit(__doc__)
    root = pathlib.Path(__file__).resolve().parent.parent.parent
    text, file = page(tables.Table(sys.argv[-2]), root), pathlib.Path(sys.argv[-1])
    if len(sys.argv) == 3:
        file.write_text(text, encoding="utf-8")
    elif text != file.read_text(encoding="utf-8"):
        raise SystemExit(f"{file} is not what {sys.argv[-2]} makes: ./book bench --publish writes both")


if __name__ == "__main__":
    main()
