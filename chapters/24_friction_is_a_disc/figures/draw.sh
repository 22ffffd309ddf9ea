#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
[ -z "$table" ] || exit 0

# Pictures of scenes.
run --scene heap --method cone --steps 600 --svg "$out/ch24_heap.svg"

# The force on a block that slides, in 24 directions.
for method in cone box pyramid; do
    for direction in 0 15 30 45 60 75 90 105 120 135 150 165 180 195 210 225 240 255 270 285 300 315 330 345; do
        run --scene slide --method $method --set direction=$direction --steps 1 --csv "$data/run"
        awk -F, 'END { print -$7, $8 }' "$data/run" >>"$data/drag_$method"
    done
done
plot ch24_friction

# A rattleback that is spun the wrong way: its spin at two steps, and by (24.12).
for h in 0.002 0.0005; do
    run --scene rattleback --method cone --h $h --steps "$(awk "BEGIN { print 3 / $h }")" --csv "$data/run"
    awk -F, -v h=$h 'NR > 1 && (NR - 2) % int(0.02 / h + 0.5) == 0 { print $2, $3, $4 }' "$data/run" >"$data/rattle_$h"
done
plot ch24_rattleback

# The picture of the small program.
small ch24_small
