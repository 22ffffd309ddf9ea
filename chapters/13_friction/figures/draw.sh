#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene house --steps 60 --svg "$out/ch13_house.svg"
run --scene arch --steps 60 --svg "$out/ch13_arch.svg"

# One contact under 1, 2, 3, ... sweeps.
for mu in 1.2 1.6; do
    for sweeps in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do
        run --scene rod --method sweeps --set mu=$mu sweeps=$sweeps --steps 1 --csv - | tail -n 1 | sed "s/^1,[^,]*/$sweeps/"
    done >"$data/mu$mu"
done
plot ch13_cycle

# The wave of a run of dominoes.
for gap in 0.2 0.35 0.6; do
    run --scene dominoes --set gap=$gap --steps 2400 --csv "$data/dominoes$gap"
done
plot ch13_dominoes

# The stretch of a spring whose block sticks and slips.
run --scene stick_slip --steps 3000 --csv "$data/two"
run --scene stick_slip --set mu_k=0.6 --steps 3000 --csv "$data/one"
plot ch13_stick_slip

# The picture of the small program.
small ch13_small
