#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

# A benchmark's table as: problem method sweeps row_visits error nanoseconds, one file for each pair.
errors() {
    tr -d '"' <"$1" | awk -F, -v dir="$data" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        /^error\// {
            split($1, part, "/")
            file = dir "/" part[2] "_" part[3]
            error = $column["error"]
            if (exact[file]) next
            if (error <= 1e-12) { exact[file] = 1; error = 1e-12 }  # the last point, at the edge
            print $column["sweeps"], $column["row_visits"], error, $column["cpu_time"] > file
        }'
}

if [ -n "$table" ]; then
    errors "$table"
    plot ch04_time
    exit
fi

# Pictures of scenes.
run --scene ten_discs --steps 2000 --svg "$out/ch04_ten_discs.svg"
run --scene zigzag --steps 14 --svg "$out/ch04_zigzag.svg"
run --scene zigzag --set a22=1 --set skew=2 --set coupling=0 --set q1=-3 --set q2=1 --steps 8 --svg "$out/ch04_cycle.svg"
run --scene mass_ratio --steps 120 --method gauss_seidel,sor --svg "$out/ch04_mass_ratio.svg"

# Error against sweeps for each method on a column of 20; the best omega of it is 1.8545.
for method in jacobi gauss_seidel symmetric cg; do
    run --scene sweeps --method $method --set rows=20 --steps 600 --csv "$data/sweeps_$method"
done
run --scene sweeps --method sor --set rows=20 --set omega=1.8545 --steps 600 --csv "$data/sweeps_sor"
run --scene sweeps --method sor --set rows=20 --set omega=0.05 --steps 600 --csv "$data/sweeps_under"
plot ch04_methods
plot ch04_change

# The rate: theory is a formula in the plot; measured is the last ratio of two errors above 1e-7.
for R in 1 10 100 1000; do
    for N in 2 3 5 10 20 40; do
        run --scene sweeps --set rows=$N --set end_mass=$R --steps $((N * N + 900)) --csv "$data/rate"
        awk -F, -v N=$N '$4 > 1e-7 && NR > 3 { ratio = $9 } END { print N, ratio }' "$data/rate" >>"$data/rate_$R"
    done
done
plot ch04_rate

# SOR on a column of 10: the mean rate between sweeps 80 and 120, or 30 and 100 where it is fast; and the ten discs.
for omega in 0.3 0.5 0.7 0.9 1 1.1 1.2 1.3 1.4 1.5 1.6 1.65 1.7 1.75 1.8 1.85 1.9 1.95; do
    run --scene sweeps --method sor --set rows=10 --set omega=$omega --steps 120 --csv "$data/omega"
    awk -F, -v omega=$omega 'BEGIN { fast = omega > 1.55 && omega < 1.88; from = fast ? 30 : 80; to = fast ? 100 : 120 }
        $1 == from { e = $4 } $1 == to { print omega, exp(log($4 / e) / (to - from)) }' "$data/omega" >>"$data/omega_column"
done
for omega in 0.3 0.5 0.7 0.9 1 1.1 1.2 1.3 1.4 1.5 1.55 1.6 1.65 1.7; do
    run --scene ten_discs --method sor --set omega=$omega --set max_sweeps=2000 --steps 2400 --csv "$data/omega"
    awk -F, -v omega=$omega 'NR > 2 { sum += $3; ++n } END { print omega, sum / n }' "$data/omega" >>"$data/omega_discs"
done
plot ch04_omega

# The error of each row of a column of ten, (4.8), after some sweeps from zero, beside the slowest mode.
awk -v data="$data" 'BEGIN {
    N = 10
    for (sweep = 0; sweep <= 90; ++sweep) {
        if (sweep == 0 || sweep == 10 || sweep == 30 || sweep == 90)
            for (k = 1; k <= N; ++k) print k, (N - k + 1 - lambda[k]) / N > (data "/mode_" sweep)
        lambda[1] = lambda[2] + 1
        for (k = 2; k <= N; ++k) lambda[k] = (lambda[k - 1] + (k < N ? lambda[k + 1] : 0)) / 2
    }
}'
plot ch04_mode

# Sweeps of each step of the ten discs.
run --scene ten_discs --steps 2400 --csv "$data/discs"
plot ch04_discs

# Where it fails: how deep a heavy disc sinks, for three numbers of sweeps. Deeper than a radius it falls through
# the other: such a run stands at the upper edge.
for sweeps in 5 20 100; do
    through=0
    for R in 1 2 5 10 20 50 100 200 500 1000 2000 5000 10000; do
        run --scene mass_ratio --method gauss_seidel --set ratio=$R --set max_sweeps=$sweeps --set digits=12 --steps 1200 --csv "$data/sink"
        awk -F, -v R=$R -v through=$through 'NR > 1 && $9 > 0.1 { through = 1 } END { print R, through ? 1000 : 1000 * $9 }' "$data/sink" >>"$data/sink_$sweeps"
        through=$(awk 'END { print $2 == 1000 }' "$data/sink_$sweeps")
    done
done
plot ch04_failure

# Error against row visits: counted, so the same on every run.
"${program}_benchmark" --benchmark_filter='^error/' --benchmark_format=csv >"$data/benchmark.csv" 2>/dev/null
errors "$data/benchmark.csv"
plot ch04_visits

# The picture of the small program.
small ch04_small
