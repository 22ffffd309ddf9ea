#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then # a file for each scene and method: time of half a second, error
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^(light|heavy)\// {
            split($1, part, "/")
            print $column["ms_whole"], $column["error"] > (dir "/" part[1] "_" part[2] "_" part[3] "_" part[4])
        }'
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^net\// {
            split($1, part, "/")
            kind = part[2] ~ /xpbd|vbd|projective|springs/ ? part[2] : part[2] "_" part[3]
            print $column["us"], $column["error"] > (dir "/net_" kind)
        }
        /^beam\// {
            split($1, part, "/")
            print $column["ms_whole"], $column["error"] > (dir "/beam_" part[2] "_" part[3] "_" part[4])
        }'
    plot ch30_pareto
    plot ch30_net
    exit
fi

# Pictures of scenes.
run --scene triangle --set pull=0.1 --steps 1 --svg "$out/ch30_triangle.svg"
run --scene jelly --method neo_hookean --steps 116 --svg "$out/ch30_jelly.svg"
run --scene jelly_in_space --method neo_hookean --steps 70 --svg "$out/ch30_space.svg"
run --scene bridge --method corotational --steps 250 --svg "$out/ch30_bridge.svg"

# Locking: sag over theory against elements through the height.
for nu in 0 0.4999; do
    for order in 1 2; do
        for n in 1 2 4 8; do
            printf '%s,' $n
            run --scene cantilever --set through=$n --set order=$order --set nu=$nu --steps 1 --csv - | tail -n 1
        done >"$data/locking_${order}_$nu"
    done
done
for n in 1 2 4 8; do
    printf '%s,' $n
    run --scene cantilever --set through=$n --set parallel=1 --set nu=0.4999 --steps 1 --csv - | tail -n 1
done >"$data/locking_parallel"
plot ch30_locking

# The picture of the small program.
small ch30_small
