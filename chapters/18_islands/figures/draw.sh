#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene struck --set prices=1 --set sleep=0 --steps 20 --svg "$out/ch18_struck.svg"
run --scene mixed --set bodies=60 --set sleep=0 --steps 60 --svg "$out/ch18_mixed.svg"

# The picture of the small program.
small ch18_small
