#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene chain --steps 300 --svg "$out/ch21_chain.svg"
run --scene top --steps 2000 --svg "$out/ch21_top.svg"

# The picture of the small program.
small ch21_small
