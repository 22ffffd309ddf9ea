#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

# One file for each case of the benchmark: n, work, nanoseconds, error (1e-16 where there is none).
split_table() {
    tr -d '"' <"$1" | awk -F, -v data="$data" '
        /^name,/ { for (i = 1; i <= NF; i++) column[$i] = i; on = 1; next }
        on {
            scale = $column["time_unit"] == "us" ? 1000 : $column["time_unit"] == "ms" ? 1e6 : 1
            count = split($1, part, "/")
            name = count > 2 ? part[1] "_" part[2] : part[1]
            error = $column["error"] + 0
            print $column["n"], $column["work"], $column["cpu_time"] * scale, (error > 1e-16 ? error : 1e-16) > (data "/" name)
        }'
}

if [ -n "$table" ]; then
    split_table "$table"
    plot ch03_assembly_time
    plot ch03_exact_time
    plot ch03_exact_error
    exit
fi

# Pictures of scenes.
run --scene bounce --steps 30 --svg "$out/ch03_impact.svg"
run --scene corner --steps 1 --svg "$out/ch03_corner.svg"
run --scene ten_discs --seed 4 --steps 1700 --svg "$out/ch03_ten_discs.svg"

# What the scenes measure.
run --scene bounce --h 0.02 --steps 300 --csv "$data/bounce.csv"
plot ch03_either_or
run --scene ten_discs --steps 1200 --csv "$data/ten.csv"
plot ch03_sets
plot ch03_impulses

# Counted work: the counters of the benchmark, not its times.
"${program}_benchmark" --benchmark_filter=assembly --benchmark_min_time=0.001 --benchmark_format=csv \
    >"$data/assembly.csv" 2>/dev/null
split_table "$data/assembly.csv"
plot ch03_assembly_work

# The picture of the small program.
small ch03_small
