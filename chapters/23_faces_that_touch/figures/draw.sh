#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene stack --method four_points,one_point --steps 45 --svg "$out/ch23_stack.svg"
run --scene over --steps 60 --svg "$out/ch23_over.svg"

# The picture of the small program.
small ch23_small
