#!/bin/sh
# Draws this chapter's figures: draw.sh BIN OUT [measured], as common/figures.sh says.
. "$(dirname "$0")/../../../common/figures.sh"

# Lines of a benchmark's table that begin with a word, as chosen columns in one file for each name.
columns_of() { # FILE WORD COLUMNS: the file is WORD_second part_third part
    tr -d '"' <"$1" | awk -F, -v dir="$data" -v word="$2" -v wanted="$3" '
        /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        index($1, word "/") == 1 {
            split($1, part, "/")
            file = dir "/" part[1] "_" part[2] (word == "error" ? "_" part[3] : "")
            count = split(wanted, name, " ")
            line = ""
            for (k = 1; k <= count; ++k) line = line " " $column[name[k]]
            print line > file
        }'
}

if [ -n "$table" ]; then
    columns_of "$table" visit "rows given_ns alternating_ns shuffled_ns coloured_ns blocks_ns world_in_memory_ns"
    plot ch06_visits
    columns_of "$table" size "rows ours_us pgs_us ours_bytes pgs_bytes"
    plot ch06_size
    columns_of "$table" error "row_visits residual time_us"
    plot ch06_error
    exit
fi

# Pictures of scenes.
run --scene one_sweep --method given,coloured --steps 60 --svg "$out/ch06_triangle.svg"
run --scene groove --method given,correction --steps 16 --svg "$out/ch06_groove.svg"
run --scene cradle --method sequential,simultaneous --steps 960 --svg "$out/ch06_cradle.svg"
run --scene bounce --method scaled,fixed --steps 270 --svg "$out/ch06_bounce.svg"
run --scene lift --steps 60 --svg "$out/ch06_lift.svg"
run --scene rope --steps 330 --svg "$out/ch06_rope.svg"

# At rest in the groove: clamp the sum or each correction, with contacts known before they close and after.
for method in given correction; do
    run --scene groove --set drop=0 sweeps=30 --method $method --steps 300 --csv "$data/jitter_$method"
    run --scene groove --set drop=0 sweeps=30 margin=1e-9 --method $method --steps 300 --csv "$data/late_$method"
done
plot ch06_jitter

# A steep groove and too few sweeps: which way does it creep?
for method in given alternating shuffled coloured; do
    run --scene groove --set drop=0 angle=60 sweeps=3 --method $method --steps 600 --csv "$data/creep_$method"
done
plot ch06_creep

# Lifts and belt beside their closed forms.
run --scene lift --set speed=1 --steps 90 --csv "$data/lift"
run --scene belt --steps 90 --csv "$data/belt"
plot ch06_motors

# When do the balls with e = 0.8 and 0.5 lie still? Three thresholds, eight time steps.
for method in scaled none fixed; do
    for n in 30 60 120 240 480 960 1920 3840; do
        run --scene bounce --method $method --h "$(awk "BEGIN { printf \"%.17g\", 1 / $n }")" --steps $((8 * n)) --csv "$data/rest"
        awk -F, -v n=$n 'NR > 1 { if ($9 * $9 > 1e-18) first = $2; if ($10 * $10 > 1e-18) second = $2 }
            END { print 1 / n, first, second }' "$data/rest" >>"$data/rest_$method"
    done
done
plot ch06_rest

# Residual and sideways momentum against sweeps.
for method in given alternating shuffled coloured blocks; do
    run --scene one_sweep --set size=20 --method $method --steps 1500 --csv "$data/order_$method"
    run --scene one_sweep --set kind=1 size=20 --method $method --steps 1500 --csv "$data/column_$method"
done
plot ch06_orders

# The picture of the small program.
small ch06_small
