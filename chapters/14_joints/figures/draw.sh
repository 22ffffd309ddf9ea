#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene walkers --method exact --steps 60 --svg "$out/ch14_walkers.svg"
run --scene excavator --method exact --steps 120 --svg "$out/ch14_excavator.svg"

# The kinds of joint.
plot ch14_kinds

# The picture of the small program.
small ch14_small
