#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then # a file for each scene and method: time of a step, error of the position
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^(ball)\// {
            split($1, part, "/")
            error = $column["position"]
            if (!(error <= 1)) error = 1 # what is lost, at the edge
            time = $column["us"]
            if (time < 6) time = 6 # it was lost at once
            print time, error > (dir "/" part[1] "_" part[2])
        }
        /^grow\// {
            split($1, part, "/")
            print $column["particles"], $column["us"] / 1000 > (dir "/grow_" part[2])
        }'
    plot ch28_pareto
    plot ch28_grow
    exit
fi

# Pictures of scenes.
run --scene ball --set squares=30 --steps 150 --svg "$out/ch28_ball.svg"
run --scene trampoline --set mass=5 --steps 42 --svg "$out/ch28_trampoline.svg"
run --scene fold --set squares=24 --set thickness=16 --steps 36 --svg "$out/ch28_fold.svg"
run --scene goal --steps 5 --svg "$out/ch28_goal.svg"
run --scene pole --set wind=12 --steps 110 --svg "$out/ch28_pole.svg"

# The picture of the small program.
small ch28_small
