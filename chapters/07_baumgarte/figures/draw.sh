#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

# A benchmark's table as: budget visits error step_us, one file for each problem and way.
errors() {
    tr -d '"' <"$1" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^error\// {
            split($1, part, "/")
            print part[4], $column["visits"], $column["error_mm"], $column["step_us"] > (dir "/" part[2] "_" part[3])
        }'
}

if [ -n "$table" ]; then
    errors "$table"
    plot ch07_time errors "column=4; cost='time of a step [µs]'"
    exit
fi

# Pictures of scenes.
run --scene bead --h 0.1 --steps 300 --method none,baumgarte --svg "$out/ch07_bead.svg"
run --scene hanging_chain --steps 90 --method baumgarte,split_impulse,none --svg "$out/ch07_chain.svg"
run --scene crowd --steps 60 --method baumgarte,projection,none --svg "$out/ch07_crowd.svg"
run --scene ten_discs --steps 1000 --method baumgarte,projection --svg "$out/ch07_ten_discs.svg"

# Drift, and the bead that settles.
run --scene bead --steps 1000 --method none --csv "$data/bead_none"
run --scene bead --steps 1000 --method baumgarte --csv "$data/bead_baumgarte"
plot ch07_drift
for h in 0.05 0.02 0.01; do
    for beta in 0.05 0.1 0.2 0.4 0.6 0.8 1 1.2 1.4 1.6 1.8 1.95; do
        run --scene bead --h $h --set beta=$beta --steps 2000 --csv "$data/one"
        awk -F, -v beta=$beta 'END { print beta "," $3 }' "$data/one" >>"$data/settled_$h"
    done
done
plot ch07_settled

# A linear error.
for beta in 0.2 0.5 1 1.5 1.9 2.05; do
    run --scene rail --set beta=$beta --steps 20 --csv "$data/rail_$beta"
done
plot ch07_decay

# A hanging chain: n sweeps in one step, n steps of one sweep.
for n in 1 2 4 8 16 32 64 128; do
    sag() { run --scene hanging_chain --steps 4000 --set sweeps=$n "$@" --csv "$data/one"
            awk -F, -v n=$n 'END { print n "," $3 "," $5 }' "$data/one"; }
    sag --method baumgarte >>"$data/sag_sweeps"
    sag --method baumgarte --set substeps=$n >>"$data/sag_small"
    [ $n = 1 ] || sag --method split_impulse >>"$data/sag_split"
done
plot ch07_sag

# Position and speed of a disc in the floor, under the ways that correct.
for way in baumgarte relaxation split_impulse projection; do
    run --scene overlap --method $way --set beta=0.2 --steps 20 --csv "$data/three_$way"
done
plot ch07_three

# Slop against jitter: three discs at rest.
quiet() { name=$1; shift; run --scene triangle --set base=2 --set sweeps=20 "$@" --steps 600 --csv "$data/slop_$name"; }
quiet none --set margin=0
quiet slop --set margin=0 --set slop=0.002
quiet margin
plot ch07_slop

# Raise beta until it is unstable. A run that has flown apart stands at the upper edge.
worst='NR > 1 && $1 * 2 > steps { e = $c > $d ? $c : $d; if (!(e < 1)) e = 1; if (e > most) most = e }
       END { print beta "," (bad || $1 < steps ? 1000 : 1000 * most) }'
for beta in 0.05 0.1 0.15 0.2 0.3 0.4 0.5 0.6 0.8 1 1.2 1.4 1.6 1.8 1.9 1.95 2.05 2.1 2.2 2.4; do
    recipe() { # SCENE STEPS COLUMN COLUMN OPTIONS
        name=$1; steps=$2; c=$3; d=$4; shift 4
        run --scene "$name" --method baumgarte --steps $steps --set beta=$beta "$@" --csv "$data/one" 2>/dev/null || true
        awk -F, -v beta=$beta -v steps=$steps -v c=$c -v d=$d "$worst" "$data/one" >>"$data/recipe_$name"
    }
    recipe bead 2000 3 3 --h 0.05
    recipe hanging_chain 1200 3 4
    recipe swinging_chain 1200 3 4
    recipe column 1200 3 4
    recipe ten_discs 1200 3 4
    [ "$(awk "BEGIN { print $beta < 2 }")" = 0 ] || for way in baumgarte relaxation split_impulse projection; do
        run --scene overlap --method $way --set beta=$beta --steps 200 --csv "$data/one"
        awk -F, -v beta=$beta 'END { print beta "," $6 - 0.5 "," $5 }' "$data/one" >>"$data/hop_$way"
    done
done
plot ch07_recipe

# Error against row visits: counted, so the same on every run.
"${program}_benchmark" --benchmark_format=csv >"$data/benchmark.csv" 2>/dev/null
errors "$data/benchmark.csv"
plot ch07_visits errors "column=2; cost='row visits in a step'"

# The picture of the small program.
small ch07_small
