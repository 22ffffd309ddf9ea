#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then # a file for each scene and way: time of a second, error
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^beads\// { split($1, part, "/"); print part[3], $column["ns"] > (dir "/beads_" part[2]); next }
        /^forces\// { next } # a table, no figure
        /\/iterations/ {
            split($1, part, "/")
            error = $column["error"]
            if (!(error < 10)) next # what flew apart
            if (error < 1e-13) error = 1e-13
            print $column["us"], error > (dir "/all_" part[1] "_" part[2])
            if (part[1] ~ /^(pendulum|stack_of_five)$/ && error < 1) print $column["us"], error > (dir "/" part[1] "_" part[2])
        }'
    printf '1 NaN\n' >"$data/none" # a way or an engine that is not there
    plot ch26_pendulum ch26_error "scene='pendulum'; ways='spring end_spring acceleration impulses positions coordinates'; top=3"
    plot ch26_stack ch26_error "scene='stack_of_five'; ways='spring end_spring acceleration single impulses positions coordinates'; top=1"
    plot ch26_growth
    plot ch26_engines
    exit
fi

# The picture of the small program.
small ch26_small
