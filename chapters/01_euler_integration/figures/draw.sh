#!/bin/sh
# draw.sh BIN OUT           the figures that are the same on every run
# draw.sh BIN OUT measured  those that show measured times, from OUT/benchmark.csv
# BIN: folder with the executables; OUT: folder to write the pictures to.
set -eu
bin=$1
out=$2
folder=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

plot() { # NAME DATA [more assignments]
    gnuplot -e "folder='$folder'; data='$2'; out='$out/ch01_$1.svg'; ${3:-}" "$folder/$1.gp"
}
table() { # NAME
    "$bin/01_euler_integration_benchmark" --table "$1" >"$work/$1.csv"
}
picture() { # NAME arguments of the program
    name=$1
    shift
    "$bin/01_euler_integration" --headless --svg "$out/ch01_$name.svg" "$@"
}

if [ "${3:-}" = measured ]; then
    # problem,method,ours|odeint,microseconds,error from Google Benchmark's own table
    awk -F, '$1 == "name" { for (i = 1; i <= NF; i++) { gsub(/"/, "", $i); column[$i] = i } next }
             column["error"] && /^"/ { name = $1; gsub(/"/, "", name); split(name, part, "/")
               print part[1] "," part[2] "," part[3] "," $column["cpu_time"] "," $column["error"] }' \
        "$out/benchmark.csv" >"$work/time.csv"
    plot time_precision "$work/time.csv"
    exit
fi

plot areas none
for name in energy phase stability modified long_time steps work_precision; do
    table $name
done
plot energy "$work/energy.csv"
plot phase "$work/phase.csv"
plot stability "$work/stability.csv"
plot modified "$work/modified.csv"
plot long_time "$work/long_time.csv"
plot steps "$work/steps.csv"
plot work_precision "$work/work_precision.csv" "what='force evaluations'"
picture springs --scene springs --steps 240
picture projectile --scene projectile --steps 300
picture pendulum --scene pendulum --method symplectic_euler --steps 300
for method in explicit_euler symplectic_euler rk4; do
    "$bin/01_euler_integration" --headless --scene kepler --h 0.02 --steps 628 --method $method --csv "$work/$method.csv"
done
plot orbits "$work"
"$folder/../../../book" small 1 "$out/ch01_small.svg" >/dev/null
