#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene book --steps 240 --svg "$out/ch20_book.svg"
run --scene handle --steps 220 --svg "$out/ch20_handle.svg"

# The energy of the tossed book by four ways; each time is half a hundredth of a second.
for method in explicit implicit momentum middle; do
    run --scene book --method $method --h 0.005 --steps 1600 --csv "$data/run" 2>"$data/said" || true
    awk -F, 'NR > 1 && NR % 8 == 0 { print (NR - 1) * 0.005, $3 + 1 }' "$data/run" >"$data/energy_$method"
done
plot ch20_energy

# The error after five seconds against the step.
for method in explicit implicit momentum middle; do
    for n in 50 100 200 400 800 1600 3200; do
        run --scene spin --method $method --h "$(awk "BEGIN { printf \"%.17g\", 5 / $n }")" --steps $n --csv "$data/run"
        awk -F, -v n=$n 'END { print 5 / n, $NF }' "$data/run" >>"$data/order_$method"
    done
done
plot ch20_order

# Two quarter turns in both orders.
plot ch20_turns

# The picture of the small program.
small ch20_small
