#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene percussion --steps 5 --svg "$out/ch11_percussion.svg"
run --scene double --method rattle --steps 1680 --svg "$out/ch11_double.svg"
run --scene ladder --steps 200 --svg "$out/ch11_ladder.svg"
run --scene gears --steps 480 --svg "$out/ch11_gears.svg"

# The rod pendulum after 1 s and what is off at its pin, against the step; and one step cut into parts.
for method in exact rattle baumgarte; do
    for n in 30 60 120 240 480 960 1920; do
        run --scene pendulum --method $method --h "$(awk "BEGIN { printf \"%.17g\", 1 / $n }")" --steps $n --csv "$data/run"
        awk -F, -v n=$n 'END { print 1 / n, $5, $7 }' "$data/run" >>"$data/order_$method"
    done
done
for parts in 1 2 4 8 16 32; do
    run --scene pendulum --method sweeps --h "$(awk 'BEGIN { printf "%.17g", 1 / 60 }')" --set substeps=$parts --steps 60 --csv "$data/run"
    awk -F, -v n=$parts 'END { print 1 / (60 * n), $5, $7 }' "$data/run" >>"$data/parts"
done
plot ch11_order

# The letters of a point of a body.
plot ch11_point

# The picture of the small program.
small ch11_small
