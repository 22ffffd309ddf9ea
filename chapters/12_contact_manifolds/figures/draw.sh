#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene stack --method one_point --steps 54 --svg "$out/ch12_one_point.svg"
run --scene rolling --steps 47 --svg "$out/ch12_rolling.svg"
run --scene overhang --steps 60 --svg "$out/ch12_overhang.svg"
run --scene pile --steps 300 --svg "$out/ch12_pile.svg"

# Angular velocity of a rocking block.
run --scene rocking --steps 1440 --csv "$data/rocking"
plot ch12_rocking

# Two corners that are nearest to each other.
plot ch12_cones

# The picture of the small program.
small ch12_small
