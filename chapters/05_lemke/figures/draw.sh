#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then
    # error/PROBLEM/n/sweeps: time [us], residual. versus/PROBLEM/n: n and three times [us]; a time whose answer
    # is wrong goes to a file of its own.
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        { split($1, part, "/") }
        /^error\// {
            residual = $column["residual"]
            who = part[4] == 0 ? "lemke" : "pgs"
            if (who == "pgs" && residual <= 1e-15) { if (exact[part[2]]) next; exact[part[2]] = 1 }
            print $column["cpu_time"], (residual > 1e3 ? 1e3 : residual < 1e-15 ? 1e-15 : residual) > (dir "/" part[2] "_" who)
        }
        /^versus\// {
            print part[3], $column["lemke_us"] > (dir "/versus_" part[2] "_lemke")
            for (p = 1; p <= 2; ++p) {
                peer = p == 1 ? "siconos" : "bullet"
                if (!(peer "_us" in column) || $column[peer "_us"] == 0) continue
                print part[3], $column[peer "_us"] > (dir "/versus_" part[2] "_" peer ($column[peer "_residual"] > 1e-8 ? "_wrong" : ""))
            }
        }'
    for file in siconos bullet siconos_wrong bullet_wrong; do
        for problem in spd column friction; do touch "$data/versus_${problem}_$file"; done
    done
    plot ch05_time
    plot ch05_peers
    exit
fi

# Pictures of scenes.
run --scene two_contacts --steps 3 --svg "$out/ch05_cones.svg"
run --scene tableau --set family=6 rows=8 --steps 3 --svg "$out/ch05_tableau.svg"
run --scene box_stack --set boxes=2 jostle=1 --steps 100 --svg "$out/ch05_stack.svg"
run --scene heavy_top --method lemke,gauss_seidel --set rows=5 --steps 480 --svg "$out/ch05_heavy_top.svg"

# Pivots against n. A walk that is done stands still, so a run may be longer than its walk.
pivots() { # name, family, tie rule, numbers of rows
    name=$1 family=$2 rule=$3
    shift 3
    for n in "$@"; do
        run --scene tableau --set family=$family rows=$n --method $rule --steps $((n > 12 ? 100 : 4100)) --csv "$data/walk"
        awk -F, -v n=$n 'END { print n, $3 }' "$data/walk" >>"$data/pivots_$name"
    done
}
pivots murty 0 lexicographic 1 2 3 4 5 6 7 8 9 10 11 12
pivots transposed 1 lexicographic 2 3 4 5 6 7 8 9 10 11 12
pivots transposed_last 1 last_row 2 3 4 6 8 10 12 16 20 24 32 40
pivots transposed_first 1 first_row 2 3 4 6 8 10 12 16 20 24 32 40
pivots fathi 3 lexicographic 2 3 4 5 6 7 8 9 10 11 12
pivots column 5 lexicographic 2 3 4 6 8 10 12 16 20 24 32 40
pivots spd 6 lexicographic 2 3 4 6 8 10 12 16 20 24 32 40
plot ch05_pivots

# The tie tolerance: pivots of Fathi's ten rows (1024 is right), and friction problems solved, of ten.
for digits in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do
    run --scene tableau --set family=3 rows=10 tie_digits=$digits --steps 2000 --csv "$data/walk"
    awk -F, -v d=$digits 'END { print d, $3 }' "$data/walk" >>"$data/tie_fathi"
    for seed in 1 2 3 4 5 6 7 8 9 10; do
        run --scene box_stack --set boxes=20 jostle=1 top_mass=1000 tie_digits=$digits --seed $seed --steps 600 --csv "$data/walk"
        awk -F, 'END { print ($8 == 1 && $6 < 1e-6) }' "$data/walk"
    done | awk -v d=$digits '{ sum += $1 } END { print d, sum }' >>"$data/tie_stacks"
done
plot ch05_ties

# The picture of the small program.
small ch05_small
