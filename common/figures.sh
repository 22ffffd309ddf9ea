# figures.sh: what the draw.sh of a chapter begins with. It is sourced:
#
#     draw.sh BIN OUT            draws the figures that come out the same on every run into the folder OUT,
#                                with the executables of the folder BIN
#     draw.sh BIN OUT measured   draws those that show run times, from OUT/benchmark.csv, which
#                                `./book bench N` leaves there (or from a run of its own)
#
# Then there are: $program, the chapter's; $here, the folder of draw.sh; $data, a folder that vanishes at the end;
# run, plot and small; and, where measured figures are asked for, $table with the benchmark's CSV (else it is empty).
set -eu
bin=$1
out=$2
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$out"
program=$bin/$(basename "$(dirname "$here")")
data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT

run() { "$program" --headless "$@"; }
plot() { # FIGURE [SCRIPT [ASSIGNMENTS]]: by FIGURE.gp, or by another script with more variables
    gnuplot -e "folder='$here'; style='$here/style.gp'; data='$data'; out='$out/$1.svg'; ${3:-}" "$here/${2:-$1}.gp"
}

small() { # FIGURE: the picture that the chapter's small program draws
    "$here/../../../book" small "$(basename "$program" | cut -c1-2)" "$out/$1.svg" >/dev/null
}

table=
if [ "${3:-}" = measured ]; then
    table=$out/benchmark.csv
    if [ ! -f "$table" ]; then
        "${program}_benchmark" --benchmark_out="$table" --benchmark_out_format=csv >&2
    fi
fi
