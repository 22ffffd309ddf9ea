#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene slope --steps 60 --svg "$out/ch13_slope.svg"
run --scene rod --steps 1 --svg "$out/ch13_rod.svg"
