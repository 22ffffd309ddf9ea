#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then
    # name,iterations,real_time,cpu_time,unit,… and the counters, in a fixed order: nanoseconds, error
    tr -d '"' <"$table" | awk -F, '/^name,/ { on = 1; next } on {
        scale = $5 == "us" ? 1000 : $5 == "ms" ? 1e6 : 1
        split($1, part, "/")
        print part[1], part[2], part[3], $4 * scale, ($11 > 1e-16 ? $11 : 1e-16)
    }' >"$data/table"
    for name in row repaid spring angle; do grep "^pendulum $name " "$data/table" >"$data/$name"; done
    for name in one-shot row-by-row; do grep "^links $name " "$data/table" >"$data/$name"; done
    plot ch02_time
    plot ch02_links
    exit
fi

# Pictures of scenes.
run --scene circle --h 0.45 --steps 2 --svg "$out/ch02_bead.svg"
run --scene own_curve --steps 85 --svg "$out/ch02_own_curve.svg"
run --scene feasible --steps 1 --svg "$out/ch02_feasible.svg"
run --scene discs --steps 29 --svg "$out/ch02_discs.svg"
run --scene conflict --steps 1 --svg "$out/ch02_conflict.svg"
run --scene atwood --steps 120 --svg "$out/ch02_atwood.svg"
run --scene wedge --steps 60 --svg "$out/ch02_wedge.svg"

# The radius of the bead over time, for three steps.
for h in 0.04 0.02 0.01; do
    run --scene circle --h $h --steps "$(awk "BEGIN { print int(10 / $h + 0.5) }")" --csv "$data/drift_$h.csv"
done
plot ch02_drift

# Errors against the step: the bead after 10 s, the pendulum after 1 s.
for n in 64 128 256 512 1024 2048 4096; do
    h=$(awk "BEGIN { printf \"%.17g\", 1 / $n }")
    run --scene circle --h "$h" --steps $((10 * n)) --csv "$data/run"
    sed -n "\$s/^/$h,/p" "$data/run" >>"$data/bead.csv"
    run --scene pendulum --h "$h" --steps $n --csv "$data/run"
    sed -n "\$s/^/$h,/p" "$data/run" >>"$data/pendulum.csv"
done
plot ch02_order

# The pull of the pendulum's rod.
run --scene pendulum --steps 130 --csv "$data/tension.csv"
plot ch02_tension

# The picture of the small program.
small ch02_small
