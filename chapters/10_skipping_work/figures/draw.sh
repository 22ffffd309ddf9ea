#!/bin/sh
# draw.sh BIN OUT [measured]: draws this chapter's figures into the folder OUT with the executables of BIN.
# Without a third word the figures that come out the same on every run; with `measured` those that
# show run times, from OUT/benchmark.csv, which `./book bench 10` leaves there (or from a run of its own).
set -eu
bin=$1
out=$2
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$out"
program=$bin/10_skipping_work
data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT

run() { "$program" --headless "$@"; }
plot() { gnuplot -e "data='$data'; out='$out/$1.svg'" "$here/$1.gp"; }

if [ "${3:-}" = measured ]; then
    table=$out/benchmark.csv
    if [ ! -f "$table" ]; then
        "${program}_benchmark" --benchmark_out="$table" --benchmark_out_format=csv >&2
    fi
    # broad/METHOD/SCENE/N: time [us]; sleepers/K, beside/K, plain/K: time [us].
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        { split($1, part, "/") }
        /^broad\// { print part[4], $column["cpu_time"] > (dir "/broad_" part[3] "_" part[2]) }
        /^(sleepers|beside|plain)\// { print (part[2] < 1 ? 0.5 : part[2]), $column["cpu_time"] > (dir "/" part[1]) }'
    plot ch10_broad
    plot ch10_sleepers
    exit
fi

# Pictures of scenes.
run --scene rain --set discs=2000 --steps 720 --svg "$out/ch10_asleep.svg"
run --scene columns --steps 410 --svg "$out/ch10_columns.svg"

# The counters of the rain, step by step, with sleep and without.
for method in skipping no_sleep; do
    run --scene rain --set discs=2000 --steps 1680 --method $method --csv "$data/rain_$method.csv"
done
plot ch10_counters

# What the skin does: distances computed in 600 steps of the rain, against the skin.
for skin in 0 0.001 0.002 0.005 0.01 0.02 0.05 0.1 0.2; do
    run --scene rain --set discs=1000 skin=$skin --steps 1200 --csv "$data/run.csv"
    awk -F, -v s=$skin 'NR > 1 { t += $9; a += $10 } END { print s, t / 1200, a / 1200 }' "$data/run.csv" >>"$data/skin"
done
plot ch10_skin
