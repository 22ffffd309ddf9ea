#!/bin/sh
# The table of section 17.6: ns a row visit by g++ and clang++, portable and native, and the figures of the chapter that are
# measured. From the root of the book:
#
#     chapters/17_wide_sweeps/benchmark/compilers.sh [OUT]      OUT: build/bench/17_wide_sweeps
#     … --build                                                 only compile
#
# Flags are those of the presets `release` and `native`. What is up to date is not compiled again; the runs take a minute.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
only=
if [ "${1:-}" = --build ]; then only=1 && shift; fi
out=${1:-$root/build/bench/17_wide_sweeps}
mkdir -p "$out"
out=$(cd "$out" && pwd)
cd "$root"
eigen=$(pkg-config --cflags eigen3)
fresh() { [ -f "$1" ] && [ -z "$(find chapters common -newer "$1" \( -name '*.hpp' -o -name '*.cpp' \) | grep -E 'chapters/(02|03|06|17)|common/' | head -n 1)" ]; }

sources="$here/benchmark.cpp chapters/17_wide_sweeps/brick_rows.cpp chapters/02_velocity_constraints/row_checks.cpp"
for name in sequential_impulse solver_row row_order feedback; do sources="$sources chapters/06_sequential_impulse/$name.cpp"; done
# one source is the team, whoever compiles the rest
fresh "$out/team.o" || g++ -std=c++20 -O2 -fopenmp -DRIGID_HAS_TEAM -I. -c chapters/17_wide_sweeps/team.cpp -o "$out/team.o"
for compiler in g++ clang++; do
    command -v $compiler >/dev/null || continue
    for build in portable native; do
        flags="-O2"
        [ $build = portable ] || flags="-O3 -march=native"
        [ $build$compiler != nativeg++ ] || flags="$flags -fno-tree-slp-vectorize"
        program=$out/benchmark_${compiler}_$build
        # shellcheck disable=SC2086
        fresh "$program" || $compiler -std=c++20 -DNDEBUG -DRIGID_HAS_TEAM $flags -ffp-contract=off -I. $eigen \
            $sources "$out/team.o" -lbenchmark -lpthread -lgomp -o "$program"
        [ -n "$only" ] || "$program" --benchmark_out="$out/${compiler}_$build.csv" --benchmark_out_format=csv >&2
    done
done
[ -z "$only" ] || exit 0

# ns of the pyramid of 40, a row for each way
value() { tr -d '"' <"$1" | awk -F, -v name="$2" -v what="$3" '
    /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    index($1, name "/") == 1 || $1 == name { printf "%.2f", $column[what] }'; }
# line NAME ROW WHAT: one number of each build
line() {
    printf '| %s |' "$1"
    for file in g++_portable g++_native clang++_portable clang++_native; do
        [ ! -f "$out/$file.csv" ] || printf ' %s |' "$(value "$out/$file.csv" "$2" "$3")"
    done
    echo
}
{
    echo "| ns a row visit | g++, portable | g++, native | clang++, portable | clang++, native |"
    echo "|---|---|---|---|---|"
    for way in given rows bundles doubles floats; do line $way visits/$way/40 ns; done
    for way in doubles floats; do line "$way, two threads: times as fast" threads/$way/2 times; done
} | tee "$out/compilers.md"
cp "$out/g++_native.csv" "$out/benchmark.csv"
"$here/../figures/draw.sh" build/release/bin "$out" measured
