#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene hills --method cone --set balls=6 --steps 700 --svg "$out/ch25_hills.svg"

# The picture of the small program.
small ch25_small
