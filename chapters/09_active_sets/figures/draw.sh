#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

if [ -n "$table" ]; then
    # error/PROBLEM/WHO/n: time [us], residual.   growth/PROBLEM/n: n, solve [us], assembly [us].
    # versus/PROBLEM/n: n and times [us]; a time whose answer is wrong goes to a file of its own.
    tr -d '"' <"$table" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        function of(key) { return $column[key] }
        { split($1, part, "/") }
        /^error\// {
            who = part[3]; sub(/_[0-9]+$/, "", who)
            residual = of("residual")
            if (who == "pgs" && residual <= 1e-15) { if (exact[part[2]]) next; exact[part[2]] = 1 }
            print of("us"), (residual > 1e3 ? 1e3 : residual < 1e-16 ? 1e-16 : residual) > (dir "/error_" part[2] "_" who)
        }
        /^growth\// { print of("n"), of("us"), of("assembly_us") > (dir "/growth_" part[2]) }
        /^versus\// {
            print of("n"), of("us") > (dir "/versus_" part[2] "_ours")
            split("ode polished siconos bullet", peers, " ")
            for (p = 1; p <= 4; ++p) {
                peer = peers[p]
                if (of(peer "_us") > 0)
                    print of("n"), of(peer "_us") > (dir "/versus_" part[2] "_" peer (of(peer "_residual") > 1e-8 ? "_wrong" : ""))
            }
        }'
    for problem in spd column_hit chain pyramid_hit; do
        for who in ours ode polished siconos bullet ode_wrong siconos_wrong bullet_wrong; do
            touch "$data/versus_${problem}_$who"
        done
    done
    plot ch09_error
    plot ch09_peers
    plot ch09_growth
    exit
fi

# Pictures of scenes.
run --scene cycle --steps 1 --svg "$out/ch09_cycle.svg"
run --scene fill --steps 1 --svg "$out/ch09_fill.svg"
run --scene guess --method active_sets,dantzig --set levels=4 --seed 5 --steps 1 --svg "$out/ch09_guess.svg"
run --scene long_chain --method active_sets,gauss_seidel --steps 1500 --svg "$out/ch09_chain.svg"

# Guesses and pivots against n.
counts() { # name, kind of pile, jostle, levels …
    name=$1 pile=$2 jostle=$3
    shift 3
    for levels in "$@"; do
        for method in active_sets dantzig lemke; do
            run --scene guess --method $method --set pile=$pile levels=$levels jostle=$jostle at_once=1 --steps 1 --csv "$data/count"
            awk -F, 'END { print $9, $3, $7 }' "$data/count" >>"$data/count_${name}_$method"
        done
    done
}
counts column 0 1 2 5 10 20 50 100 200
counts pyramid 2 1 2 3 4 6 8 11 16
plot ch09_counts

# What the previous set is worth: guesses of each step of the ten discs.
run --scene ten_discs --method active_sets --steps 1440 --csv "$data/warm"
run --scene ten_discs --method cold --steps 1440 --csv "$data/cold"
plot ch09_warm

# How long the chain of 200 links becomes.
run --scene long_chain --method active_sets --steps 2400 --csv "$data/stretch_exact"
for sweeps in 10 40 160; do
    run --scene long_chain --method gauss_seidel --set max_sweeps=$sweeps --steps 2400 --csv "$data/stretch_$sweeps"
done
plot ch09_stretch

# The picture of the small program.
small ch09_small
