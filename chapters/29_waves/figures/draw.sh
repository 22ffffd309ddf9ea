#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then # a file for each method: time, error
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^string\// {
            split($1, part, "/")
            error = $column["error"]
            if (error < 1e-15) error = 1e-15
            print $column["us"], error > (dir "/" part[2])
        }'
    plot ch29_pareto
    exit
fi

# Pictures of scenes.
run --scene boat --set waves=0.12 --steps 840 --svg "$out/ch29_boat.svg"
run --scene dam --steps 60 --svg "$out/ch29_dam.svg"
run --scene basin --steps 48 --svg "$out/ch29_basin.svg"
run --scene boxes --set waves=0 --steps 2400 --svg "$out/ch29_boxes.svg"

# How fast each wave is.
run --scene dispersion --steps 31 --csv "$data/dispersion"
plot ch29_dispersion

# The picture of the small program.
small ch29_small
