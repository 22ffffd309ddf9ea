#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"
starts="cold previous best_multiple"

if [ -n "$table" ]; then
    # engines/SCENE/WHO: time [us], error [mm]; held at the edges of the plot.
    for kind in hanging swinging column triangle; do
        for who in quick careful box2d chipmunk disorder; do echo 1e-9 1e-9 >"$data/engines_${kind}_$who"; done
    done
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^engines\// {
            split($1, part, "/")
            split(part[2], scene, "_")
            who = part[3]
            if (who != "quick" && who != "careful" && who != "box2d" && who != "chipmunk") next
            e = $column["link_mm"] > $column["overlap_mm"] ? $column["link_mm"] : $column["overlap_mm"]
            e = e > 1e7 ? 1e7 : e < 5e-5 ? 5e-5 : e
            print $column["real_time"], e >> (dir "/engines_" scene[1] "_" who)
            if ($column["in_order"] == 0) print $column["real_time"], e >> (dir "/engines_" scene[1] "_disorder")
        }'
    plot ch08_engines
    exit
fi

# Pictures of scenes.
run --scene column --method cold,previous,best_multiple --steps 300 --svg "$out/ch08_column.svg"
run --scene hanging_chain --method cold,previous,best_multiple --steps 300 --svg "$out/ch08_chain.svg"
run --scene triangle --method cold,previous,best_multiple --steps 300 --svg "$out/ch08_triangle.svg"

# A column of 20, ten sweeps a step: how far its top sinks.
for start in $starts; do
    run --scene column --method $start --steps 600 --csv "$data/sink_$start"
done
plot ch08_sink

# Five discs and seven rods: the greatest speed, of which a millionth of a metre a second was given.
for start in $starts; do
    run --scene loop --method $start --set order=3 digits=12 --steps 300 --csv "$data/loop_$start"
done
run --scene loop --method previous --set order=1 max_sweeps=2 digits=12 --steps 300 --csv "$data/loop_symmetric"
plot ch08_loop

# Growth in a step of a chain of 20 under Baumgarte: theory, and the ratio of the greatest speeds in two windows.
# Where it grows, from a start so small that it stays linear; where it shrinks, before it reaches the rounding.
growth() { # file, start, settings
    file=$1 start=$2
    shift 2
    for k in 1 2 3 4 6 8 10 12 15 18 21 24 27 30 34 38 42 46 50; do
        weight=1e-3 window=35 from=20 to=90
        if [ "$file" = growth_previous ] && [ $k -lt 31 ]; then weight=1e-11 window=70 from=290 to=430; fi
        run --scene hanging_chain --method $start --set max_sweeps=$k digits=12 weight=$weight "$@" --steps 500 --csv "$data/growth"
        awk -F, -v k=$k -v window=$window -v from=$from -v to=$to '
            NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
            { n = $column["step"]; u = $column["speed"]; theory = $column["theory"] }
            n > from && n <= from + window && u > early { early = u }
            n > to && n <= to + window && u > late { late = u }
            END { print k, theory, (late / early)^(1 / (to - from)) }' "$data/growth" >>"$data/$file"
    done
}
growth growth_previous previous
growth growth_factor previous --set factor=0.8
growth growth_none previous --set repaid_by=0
plot ch08_growth

# F1: how far the next disc rises above its place when 100 kg are taken off, for each way to repay.
for start in previous best_multiple; do
    for way in 0 1 2 3 4; do
        for k in 2 3 4 5 6 8 10 12 16 20 30 40; do
            run --scene removed --method $start --set max_sweeps=$k repaid_by=$way --steps 400 --csv "$data/removed"
            awk -F, -v k=$k 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
                $column["step"] > 120 && $column["last_rise"] > top { top = $column["last_rise"] }
                END { print k, 1000 * top }' "$data/removed" >>"$data/removed_${start}_$way"
        done
    done
done
plot ch08_removed

# Sweeps of each step of the ten discs.
for start in $starts; do
    run --scene ten_discs --method $start --steps 2400 --csv "$data/discs_$start"
done
plot ch08_discs

# The tallest column that stands 600 steps without an overlap of a tenth of a radius.
stands() { # discs, settings
    discs=$1
    shift
    run --scene column --set discs=$discs "$@" --steps 600 --csv "$data/height" &&
        awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
            $column["penetration"] > 0.01 { exit 1 }' "$data/height"
}
tallest() { # file, settings
    file=$1
    shift
    for k in 1 2 4 8 16 32 64; do
        low=1 high=201
        while [ $((high - low)) -gt 1 ]; do
            middle=$(((low + high) / 2))
            if stands $middle --set max_sweeps=$k "$@"; then low=$middle; else high=$middle; fi
        done
        echo $k $low >>"$data/$file"
    done
}
tallest height_cold --method cold --set repaid_by=1
tallest height_previous --method previous --set repaid_by=3 slop=0.001
tallest height_best_multiple --method best_multiple --set repaid_by=3 slop=0.001
plot ch08_height

# Error against row visits: the largest error of 600 steps, the mean visits of a step.
error() { # file, settings
    file=$1
    shift
    run "$@" --steps 600 --csv "$data/error" 2>/dev/null || true
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        $column["rows"] == 0 { next }
        { visits += $column["row_visits"] / $column["rows"]; ++n
          e = $column["link_error"] > $column["penetration"] ? $column["link_error"] : $column["penetration"] }
        e > worst { worst = e }
        END { print visits / n, 1000 * worst }' "$data/error" >>"$data/$file"
}
for k in 1 2 3 4 6 8 12 16 24 32 48 64 96 128; do
    for start in $starts; do
        error column_$start --scene column --method $start --set max_sweeps=$k repaid_by=3 slop=0.0005
        error swing_$start --scene swinging_chain --method $start --set max_sweeps=$k end_mass=10
        error triangle_$start --scene triangle --method $start --set max_sweeps=$k repaid_by=3 slop=0.0005
    done
    if [ $k -gt 64 ]; then continue; fi
    error column_substeps --scene column --method previous --set max_sweeps=1 substeps=$k repaid_by=4 slop=0.0005
    error swing_substeps --scene swinging_chain --method previous --set max_sweeps=1 substeps=$k end_mass=10
    error triangle_substeps --scene triangle --method previous --set max_sweeps=1 substeps=$k repaid_by=4 slop=0.0005
done
plot ch08_visits

# The picture of the small program.
small ch08_small
