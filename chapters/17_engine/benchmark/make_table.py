"""Tables 17.1 and 17.2, what is kept where things move, from what `./book bench 17` measured.

    make_table.py CSV                prints a row for each scene, engine and number of sub-steps, as CSV
    make_table.py CSV KEPT           writes these rows into the file KEPT
    make_table.py CSV KEPT IN_DEPTH  and puts the tables where they stand in the text
"""

import csv
import io
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "docs" / "tools"))
from put_table import put_all  # noqa: E402

WHO = {"book": "this book", "box2d3": "Box2D 3", "box2d": "Box2D 2.4", "chipmunk": "Chipmunk"}
SUBSTEPS = (1, 4, 16)


def read(file):
    """scene → {what, reference, seconds, (who, sub-steps) → row}, in the order of the file."""
    with open(file, newline="", encoding="utf-8") as stream:
        lines = list(stream)
    first = next(i for i, line in enumerate(lines) if line.startswith("name,"))
    scenes = {}
    for row in csv.DictReader(lines[first:]):
        part = row["name"].split("/")
        if part[0] != "kept" or part[2] not in WHO:
            continue
        scene = scenes.setdefault(part[1], {"what": row["label"], "reference": float(row["right"]),
                                            "seconds": float(row["steps"]) / 60})
        scene[part[2], int(part[3])] = row
    return scenes


def rows(scenes):
    yield ["scene", "what", "reference", "engine", "sub-steps", "kept", "error", "gap", "ms"]
    for name, scene in scenes.items():
        for substeps in SUBSTEPS:
            for who, title in WHO.items():
                if (who, substeps) in scene:
                    row = scene[who, substeps]
                    numbers = [f"{float(row[key]):.6g}" for key in ("kept", "error", "gap", "ms_all")]
                    yield [name, scene["what"], f"{scene['reference']:.10g}", title, substeps] + numbers


def figure(value):
    """Four digits, few enough to compare; what is smaller than any that counts is 0."""
    return "0" if abs(value) < 5e-6 else f"{value:.4g}" if abs(value) >= 1e-3 else f"{value:.1g}"


def table(scenes, column, with_reference):
    heads = ["scene"] + (["reference"] if with_reference else []) + ["sub-steps"] + list(WHO.values())
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    for name, scene in scenes.items():
        for substeps in SUBSTEPS:
            first = substeps == SUBSTEPS[0]
            cells = [f"{name}: {scene['what']}" if with_reference else name] if first else [""]
            if with_reference:
                cells.append(figure(scene["reference"]) if first else "")
            cells.append(str(substeps))
            for who in WHO:
                row = scene.get((who, substeps))
                cells.append("–" if row is None else figure(float(row[column])) if with_reference else
                             f"{float(row[column]):.2g}" if float(row[column]) < 100 else f"{float(row[column]):.0f}")
            lines.append("| " + " | ".join(cells) + " |")
    return lines


def main():
    if len(sys.argv) not in (2, 3, 4):
        raise SystemExit(__doc__)
    scenes = read(sys.argv[1])
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows(scenes))
    if len(sys.argv) == 2:
        print(text.getvalue(), end="")
        return
    pathlib.Path(sys.argv[2]).write_text(text.getvalue(), encoding="utf-8")
    if len(sys.argv) == 4:
        long = {name: scene for name, scene in scenes.items() if scene["seconds"] >= 60}
        put_all(pathlib.Path(sys.argv[3]), {"**Table 17.1.**": table(scenes, "kept", True),
                                            "**Table 17.2.**": table(long, "ms_all", False)})


if __name__ == "__main__":
    main()
