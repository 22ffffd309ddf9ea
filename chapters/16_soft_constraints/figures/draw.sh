#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then # a file for each scene and method: time of a step, error
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^(pyramid|house|chain|dolls)\// {
            split($1, part, "/")
            error = $column["error"]
            if (!(error <= 1)) error = 1 # what fell, at the edge
            if (error < 1e-9) error = 1e-9
            print $column["us"], error > (dir "/" part[1] "_" part[2])
        }'
    plot ch16_pareto
    exit
fi

# Pictures of scenes.
run --scene soft_body --method soft --set stiffness=120 --steps 70 --svg "$out/ch16_soft_body.svg"
run --scene cloth --method soft --set stiffness=100 --steps 500 --svg "$out/ch16_cloth.svg"
run --scene stack --set ratio=1000 --set boxes=5 --method bodies,hard --steps 90 --svg "$out/ch16_stack.svg"

# What a spring keeps of its energy, and the floor of soft contacts.
for f in 0.5 2 30; do
    run --scene spring --method soft --set spring=$f --steps 120 --csv "$data/spring$f"
done
plot ch16_energy
for method in soft preloaded; do
    for n in 1 2 4 8 16; do
        printf '%s,' $n
        run --scene stack --method $method --set ratio=1 --set boxes=4 --set frequency=1000 --set sweeps=20 \
            --set substeps=$n --steps 300 --csv - | tail -n 1
    done >"$data/floor_$method"
done
plot ch16_floor

# The picture of the small program.
small ch16_small
