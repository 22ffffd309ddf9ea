"""Table 10.2 from what `./book bench 10` measured: the whole step beside two engines.

    make_table.py CSV            prints it
    make_table.py CSV README     puts it where it stands in the text
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "docs" / "tools"))
from put_table import benchmark_rows, put_all  # noqa: E402

WHO = {"ours": "this chapter", "box2d": "Box2D 2.4", "box2d_small": "8 small steps", "chipmunk": "Chipmunk 7",
       "chipmunk_small": "8 small steps"}
MS = {"us": 1e-3, "ms": 1, "ns": 1e-6}


def read(file):
    """(kind, who, discs) → its row with the least time [ms]."""
    found = {}
    for row in benchmark_rows(file):
        part = row["name"].split("/")
        if part[0] not in ("pile", "rain") or part[-1].endswith(("_mean", "_median", "_stddev", "_cv")):
            continue
        row["ms"] = float(row["cpu_time"]) * MS[row["time_unit"]]
        key = (part[0], part[1], int(part[2]))
        if key not in found or row["ms"] < found[key]["ms"]:
            found[key] = row
    return found


def figure(value):
    return f"{value:,.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2g}"


def table(found):
    rain_steps = 1200
    lines = ["| | discs | " + " | ".join(WHO.values()) + " |", "|---|---:|" + "---:|" * len(WHO)]

    def line(title, kind, discs, value):
        cells = [figure(value(found[kind, who, discs])) if (kind, who, discs) in found else "–" for who in WHO]
        lines.append(f"| {title} | {discs:,} | {' | '.join(cells)} |")

    line("pile, a step [ms]", "pile", 500, lambda row: row["ms"])
    line("", "pile", 2000, lambda row: row["ms"])
    line("rain, a step on average [ms]", "rain", 500, lambda row: row["ms"] / rain_steps)
    line("", "rain", 2000, lambda row: row["ms"] / rain_steps)
    line("awake after 10 s", "rain", 2000, lambda row: float(row["awake"]))
    line("deepest overlap then [mm]", "rain", 2000, lambda row: 1e3 * float(row["error"]))
    return lines


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    tables = {"**Table 10.2.**": table(read(sys.argv[1]))}
    if len(sys.argv) == 2:
        print("\n".join(tables["**Table 10.2.**"]))
    else:
        put_all(pathlib.Path(sys.argv[2]), tables)


if __name__ == "__main__":
    main()
