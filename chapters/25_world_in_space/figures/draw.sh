#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene book --steps 170 --svg "$out/ch25_book.svg"
run --scene handle --steps 220 --svg "$out/ch25_handle.svg"
run --scene top --steps 2000 --svg "$out/ch25_top.svg"
run --scene chain --steps 300 --svg "$out/ch25_chain.svg"

run --scene stack --method cone,one_point --steps 45 --svg "$out/ch25_stack.svg"
run --scene heap --method cone --steps 600 --svg "$out/ch25_heap.svg"
run --scene hills --method cone --set balls=6 --steps 700 --svg "$out/ch25_hills.svg"

# The force on a block that slides, in 24 directions.
for method in cone box pyramid; do
    for direction in 0 15 30 45 60 75 90 105 120 135 150 165 180 195 210 225 240 255 270 285 300 315 330 345; do
        run --scene slide --method $method --set direction=$direction --steps 1 --csv "$data/run"
        awk -F, 'END { print -$7, $8 }' "$data/run" >>"$data/drag_$method"
    done
done
plot ch25_friction

# The energy of the tossed book by four ways; each time is half a hundredth of a second.
for method in explicit implicit momentum middle; do
    run --scene book --method $method --h 0.005 --steps 1600 --csv "$data/run" 2>"$data/said" || true
    awk -F, 'NR > 1 && NR % 8 == 0 { print (NR - 1) * 0.005, $3 + 1 }' "$data/run" >"$data/energy_$method"
done
plot ch25_energy

# The error after five seconds against the step.
for method in explicit implicit momentum middle; do
    for n in 50 100 200 400 800 1600 3200; do
        run --scene spin --method $method --h "$(awk "BEGIN { printf \"%.17g\", 5 / $n }")" --steps $n --csv "$data/run"
        awk -F, -v n=$n 'END { print 5 / n, $NF }' "$data/run" >>"$data/order_$method"
    done
done
plot ch25_order

# A rattleback that is spun the wrong way: its spin at two steps, and by (25.45).
for h in 0.002 0.0005; do
    run --scene rattleback --method cone --h $h --steps "$(awk "BEGIN { print 3 / $h }")" --csv "$data/run"
    awk -F, -v h=$h 'NR > 1 && (NR - 2) % int(0.02 / h + 0.5) == 0 { print $2, $3, $4 }' "$data/run" >"$data/rattle_$h"
done
plot ch25_rattleback

# The picture of the small program.
small ch25_small
