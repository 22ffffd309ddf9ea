#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then
    # Of several rounds the shortest time [us]: broad/METHOD/SCENE/N, and sleepers, beside or awake/WHO/K.
    tr -d '"' <"$table" | awk -F, '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        $1 !~ /^(broad|sleepers|beside|awake)\// || $1 ~ /_(mean|median|stddev|cv)$/ { next }
        {
            sub(/\/min_time.*/, "", $1)
            time = $column["cpu_time"]
            if (!($1 in least)) { name[++n] = $1; least[$1] = time }
            else if (time < least[$1]) least[$1] = time
        }
        END { for (i = 1; i <= n; ++i) print name[i], least[name[i]] }' >"$data/least"
    for engine in box2d chipmunk; do
        for kind in sleepers beside awake; do touch "$data/${kind}_$engine"; done
    done
    tr / ' ' <"$data/least" | awk -v dir="$data" '
        $1 == "broad" { print $4, $5 > (dir "/broad_" $3 "_" $2); next }
        { print ($3 < 1 ? 0.2 : $3), $4 > (dir "/" $1 "_" $2) }'
    plot ch10_broad
    plot ch10_sleepers
    exit
fi

# Pictures of scenes.
run --scene rain --set discs=2000 --steps 528 --svg "$out/ch10_asleep.svg"
plot ch10_skin_pair
run --scene columns --steps 410 --svg "$out/ch10_columns.svg"

# The counters of the rain, step by step, with sleep and without.
for method in skipping no_sleep; do
    run --scene rain --set discs=2000 --steps 1680 --method $method --csv "$data/rain_$method.csv"
done
plot ch10_counters

# What the skin does: distances computed and discs that query in a step of the rain, against the skin.
for skin in 0 0.001 0.002 0.005 0.01 0.02 0.05 0.1 0.2; do
    run --scene rain --set discs=1000 skin=$skin --steps 1200 --csv "$data/run.csv"
    awk -F, -v s=$skin 'NR > 1 { t += $9; a += $10 } END { print s, t / 1200, a / 1200 }' "$data/run.csv" >>"$data/skin"
done
plot ch10_skin

# The picture of the small program.
small ch10_small
