#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then # a file for each scene and method: time of a step, error of the position; and for each strip: load, height over width
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^(sheet|strip|flag)\// {
            split($1, part, "/")
            error = $column["position"]
            if (!(error <= 1)) error = 1 # what is lost, at the edge
            time = $column["us"]
            if (time < 6) time = 6 # it was lost at once
            print time, error > (dir "/" part[1] "_" part[2])
        }
        /^(weight|end)\// {
            split($1, part, "/")
            print part[3] / 100, $column["height"] > (dir "/" part[1] "_" part[2])
        }'
    plot ch27_pareto
    plot ch27_master
    exit
fi

# Pictures of scenes.
run --scene flag --set squares=30 --set wind=12 --steps 100 --svg "$out/ch27_flag.svg"
run --scene tear --set strength=15 --steps 75 --svg "$out/ch27_tear.svg"

# The first mass after one step against the number of sweeps.
for method in xpbd pbd forgotten threads; do
    for n in 1 2 3 4 6 8 12 16 24 32 48 64 100; do
        printf '%s ' $n
        run --scene masses --method $method --set sweeps=$n --steps 1 --csv - | tail -n 1 | tr ',' ' '
    done >"$data/count_$method"
done
plot ch27_count

# The picture of the small program.
small ch27_small
