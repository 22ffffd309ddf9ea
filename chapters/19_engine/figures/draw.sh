#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene poured --set bodies=60 --steps 600 --svg "$out/ch19_poured.svg"
run --scene dolls --steps 100 --svg "$out/ch19_dolls.svg"
run --scene furniture --steps 400 --svg "$out/ch19_furniture.svg"

# What should stand, as it was measured: from benchmark/engines.csv.
plot ch19_stand

# The picture of the small program.
small ch19_small
