#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^visits\// {
            split($1, part, "/")
            print 4 * part[3] * part[3], $column["ns"] > (dir "/visits_" part[2])
            print $column["flops"] / $column["bytes"], $column["gflops"] > (dir "/roof_" part[2])
        }
        /^machine\/bandwidth\// { split($1, part, "/"); print part[3], $column["gbytes"] > (dir "/bandwidth") }
        /^machine\/flops\// { split($1, part, "/"); print part[3], $column["gflops"] > (dir "/flops") }'
    plot ch17_visits
    plot ch17_roofline
    exit
fi

run --scene pyramid --method given,wide --steps 30 --svg "$out/ch17_pyramid.svg"
run --scene pyramid --method given,wide --set colours=0 --steps 40 --svg "$out/ch17_careless.svg"

# The picture of the small program.
small ch17_small
