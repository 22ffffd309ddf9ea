#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene chain --method trees --steps 60 --svg "$out/ch15_chain.svg"
run --scene bridge --method trees --steps 120 --svg "$out/ch15_bridge.svg"
run --scene dolls --steps 110 --svg "$out/ch15_dolls.svg"

# A tree and its two ways.
plot ch15_tree

# The picture of the small program.
small ch15_small
