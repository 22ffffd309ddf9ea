#!/bin/sh
# Tests of the script `book`: where it finds the book, where files land, how many chapters it takes. A book of two
# chapters stands in for this one, and a cmake that builds nothing for the real one.
#
#     tests/book_script.sh BOOK     the script to be tested
set -eu
script=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
faults=0

wants() { # WHAT SAID WANTED
    case "$2" in
    *"$3"*) ;;
    *)
        echo "$1: wanted \"$3\", got \"$2\"" >&2
        faults=$((faults + 1))
        ;;
    esac
}

book=$scratch/book_folder
mkdir -p "$book" "$scratch/tools" "$scratch/reader" "$scratch/links" "$book/build/release/bin"
cp "$script" "$book/book"
for name in 01_one 02_two; do
    mkdir -p "$book/chapters/$name/program" "$book/chapters/$name/figures"
    : >"$book/chapters/$name/program/main.cpp"
    echo "<svg/>" >"$book/chapters/$name/figures/ch_$name.svg"
    printf '#!/bin/sh\necho "<svg>new</svg>" >"$2/ch_%s.svg"\n' "$name" >"$book/chapters/$name/figures/draw.sh"
    printf '#!/bin/sh\necho "rows of $*" >rel.csv\n' >"$book/build/release/bin/$name"
    chmod +x "$book/chapters/$name/figures/draw.sh" "$book/build/release/bin/$name"
done
printf '#!/bin/sh\nexit 0\n' >"$scratch/tools/cmake"
printf '#!/bin/sh\necho "ctest $*"\n' >"$scratch/tools/ctest"
chmod +x "$scratch/tools/cmake" "$scratch/tools/ctest"
PATH=$scratch/tools:$PATH
BOOK_NO_INSTALL=1
export PATH BOOK_NO_INSTALL
unset CDPATH

# A file that the reader names lies where the reader stands.
cd "$scratch/reader"
"$book/book" run 1 --csv rel.csv 2>/dev/null
wants "the table" "$(cat rel.csv 2>&1)" "rows of --csv rel.csv"
[ ! -e "$book/rel.csv" ] || wants "the table" "beside the book" "beside the reader"

# By a symlink, and by a symlink to a symlink, one of them relative.
ln -s "$book/book" "$scratch/links/first"
ln -s first "$scratch/links/second"
for link in first second; do
    rm -f rel.csv
    said=$("$scratch/links/$link" run 2 --x 2>&1 || true)
    wants "book by the link $link ($said)" "$(cat rel.csv 2>&1)" "rows of --x"
done
wants "a relative path" "$(../book_folder/book run 1 2>&1; cat rel.csv)" "rows of"

# A short run is not published.
wants "a short run" "$("$book/book" bench --publish --quick 2>&1 || true)" "bench --publish --quick: what is published is the whole run"

# How long a first build takes; nothing where all has been built.
printf '#!/bin/sh\nfor i in 1 2 3 4 5 6 7; do echo "c++ -o part$i.o -c part$i.cpp"; done\n' >"$scratch/tools/ninja"
chmod +x "$scratch/tools/ninja"
wants "a first build" "$("$book/book" run 1 2>&1)" ": 7 new sources, about a minute on "
for i in 1 2 3 4 5 6 7; do : >"$book/build/release/part$i.o"; done
said=$("$book/book" run 1 2>&1)
case "$said" in *"new sources"*) wants "a second build" "$said" "nothing of new sources" ;; esac
rm "$scratch/tools/ninja"

# Several chapters at once.
said=$("$book/book" figures 1 2 --check 2>&1) && wants "figures" "code 0" "code 1"
wants "figures --check" "$said" "ch_01_one.svg"
wants "figures --check" "$said" "ch_02_two.svg"
"$book/book" figures 1 2 2>/dev/null
wants "figure of chapter 1" "$(cat "$book/chapters/01_one/figures/ch_01_one.svg")" "new"
wants "figure of chapter 2" "$(cat "$book/chapters/02_two/figures/ch_02_two.svg")" "new"
wants "tests of two chapters" "$("$book/book" test 1 2 2>/dev/null)" "-L ^(ch01|ch02)\$"
wants "tests of one chapter" "$("$book/book" test 2 2>/dev/null)" "-L ^(ch02)\$"
for command in "figures 1 9" "test 9 1" "figures 1 x"; do
    # shellcheck disable=SC2086
    said=$("$book/book" $command 2>&1) && wants "$command" "code 0" "a refusal"
    wants "$command" "$said" "there are: 1 2"
done

# The small programs: compiled by a compiler that makes a script, once, and run where the reader stands.
cat >"$scratch/tools/g++" <<'END'
#!/bin/sh
while [ "$1" != -o ]; do shift; done
printf '#!/bin/sh\necho "small rows of $*" >small.csv\n' >"$2"
chmod +x "$2"
END
chmod +x "$scratch/tools/g++"
printf '#!/bin/sh\necho -I/eigen\n' >"$scratch/tools/pkg-config"
chmod +x "$scratch/tools/pkg-config"
unset CXX
printf '// Chapter 1 in one file.\nint one;\n' >"$book/chapters/01_one/small.cpp"
said=$("$book/book" small 1 a.svg 2>&1 || true)
wants "small 1" "$said" "compiling: g++ -std=c++20 -O2 -I/eigen chapters/01_one/small.cpp"
wants "what small 1 wrote" "$(cat small.csv 2>&1)" "small rows of a.svg"
said=$("$book/book" small 1 2>&1 || true)
[ -z "$said" ] || wants "small 1 again" "$said" "nothing compiled"
touch -t 203001010000 "$book/chapters/01_one/small.cpp"
wants "small 1 once it is changed" "$("$book/book" small 1 2>&1)" "compiling: g++"
printf '#!/bin/sh\nexec "$@"\n' >"$scratch/tools/cache"
chmod +x "$scratch/tools/cache"
wants "CXX of several words" "$(CXX="cache g++ -g" "$book/book" small 1 2>&1)" "compiling: cache g++ -g -std=c++20"
wants "CXX that is not there" "$(CXX="no_such_compiler -g" "$book/book" small 1 2>&1)" "compiling: g++ -std=c++20"
said=$("$book/book" small 2 2>&1) && wants "small 2" "code 0" "a refusal"
wants "small 2" "$said" "chapter 2 has no small program; there are: 1"
printf '// Chapter 2 in one file, grown from chapter 1.\nint two;\n' >"$book/chapters/02_two/small.cpp"
said=$("$book/book" small 2 --diff 2>&1 || true)
wants "small 2 --diff" "$said" "-int one;"
wants "small 2 --diff" "$said" "+int two;"
said=$("$book/book" small 1 --diff 2>&1) && wants "small 1 --diff" "code 0" "a refusal"
wants "small 1 --diff" "$said" "chapters/01_one/small.cpp grew from no other"
mkdir -p "$book/tests/small"
printf 'import sys\nprint("holes of", *sys.argv[1:])\n' >"$book/tests/small/holes.py"
wants "small 2 --holes" "$("$book/book" small 2 --holes 2>&1)" "holes of 2"
wants "small --holes 2 step" "$("$book/book" small --holes 2 step 2>&1)" "holes of 2 step"
said=$("$book/book" small 9 --holes 2>&1) && wants "small 9 --holes" "code 0" "a refusal"
wants "small 9 --holes" "$said" "there is no chapter 9; there are: 1 2"
wants "small" "$("$book/book" small 2>&1)" "Chapter 2 in one file, grown from chapter 1."
said=$("$book/book" small 9 2>&1) && wants "small 9" "code 0" "a refusal"
wants "small 9" "$said" "there are: 1 2"
printf '#!/bin/sh\nexit 1\n' >"$scratch/tools/g++"
said=$("$book/book" small 2 2>&1) && wants "small 2 that is wrong" "code 0" "a refusal"
wants "small 2 that is wrong" "$said" "chapters/02_two/small.cpp does not compile"
rm "$scratch/tools/g++" "$scratch/tools/pkg-config" # the real ones, for what follows

# The reader's own headers: a list of one chapter, a program of tests that fails one of three.
cp -r "$(dirname "$script")/tests/mine" "$scratch/mine_tool"
mkdir -p "$book/tests/mine" "$book/build/mine/bin"
cp "$scratch/mine_tool/mine.py" "$book/tests/mine/"
printf 'in     chapters/01_one/idea.hpp\nempty  half  return 0;\n' >"$book/tests/mine/01.txt"
printf 'inline int half(int x)\n{\n    return x / 2;\n}\n' >"$book/chapters/01_one/idea.hpp"
cat >"$book/tests/01_one.cpp" <<'END'
#include "chapters/01_one/idea.hpp"
#include <cstdio>
int again(int x);
int main(int, char** arguments)
{
    std::printf("tags %s\n", arguments[1]);
    const bool right = half(4) == 2 && again(4) == 2;
    std::puts(right ? "All tests passed (3 assertions in 3 test cases)" : "test cases:  3 |  2 passed | 1 failed");
    return right ? 0 : 1;
}
END
printf '#include "chapters/01_one/idea.hpp"\nint again(int x) { return half(x); }\n' >"$book/tests/again.cpp"
cat >"$book/build/mine/build.ninja" <<END
rule compile
  command = g++ -MD -MF \$out.d -I\$book/mine -I\$book -c \$in -o \$out
  depfile = \$out.d
  deps = gcc
rule link
  command = g++ \$in -o \$out
build one.o: compile $book/tests/01_one.cpp
  book = $book
build again.o: compile ../../tests/again.cpp
  book = ../..
build bin/test_01_one: link one.o again.o
END
printf '#!/bin/sh\ncase "$*" in "--build --preset mine"*) exec ninja -C "%s" ;; esac\n' "$book/build/mine" >"$scratch/tools/cmake"
said=$("$book/book" test 1 --mine 2>&1) && wants "test 1 --mine" "code 0" "a refusal"
wants "test 1 --mine before it is begun" "$said" "begin with ./book mine 1"
said=$("$book/book" test 2 --mine 2>&1) && wants "test 2 --mine" "code 0" "a refusal"
wants "test 2 --mine" "$said" "chapter 2 has no header to write yourself"
# Headers that come to be after a build.
"$scratch/tools/cmake" --build --preset mine >/dev/null
wants "the book's own" "$("$book/build/mine/bin/test_01_one" "[idea]")" "All tests passed"
wants "mine 1" "$("$book/book" mine 1)" "write half()"
wants "the emptied header" "$(cat "$book/mine/chapters/01_one/idea.hpp")" "return 0;"
said=$("$book/book" test 1 --mine 2>&1) && wants "test 1 --mine" "code 0" "code 1"
wants "test 1 --mine" "$said" "tags [idea]"
wants "test 1 --mine" "$said" "chapter 1: 2 of 3 idea tests pass"
wants "mine" "$("$book/book" mine)" "0 of 1 functions begun; 2 of 3 idea tests pass"
cp "$book/chapters/01_one/idea.hpp" "$book/mine/chapters/01_one/idea.hpp"
said=$("$book/book" test 1 --mine 2>&1) || wants "the reader's own" "code $? $said" "code 0"
wants "the reader's own" "$said" "chapter 1: 3 of 3 idea tests pass"
said=$("$book/book" test 1 --mine 2>&1)
wants "nothing is new" "$said" "no work to do"
rm "$book/mine/chapters/01_one/idea.hpp"
"$book/book" mine 1 >/dev/null
said=$("$book/book" test 1 --mine 2>&1) && wants "begun again" "code 0" "code 1"
wants "begun again" "$said" "chapter 1: 2 of 3 idea tests pass"
said=$("$book/book" test 1 2 --mine 2>&1) && wants "test 1 2 --mine" "code 0" "a refusal"
wants "test 1 2 --mine" "$said" "takes the number of one chapter"

# The stability matrix: each kind has a table, and each has a short one, in whatever order the reader says it.
cat >"$book/build/release/bin/stress" <<'END'
#!/bin/sh
file= last=
for word in "$@"; do
    [ "$last" != --csv ] || file=$word
    last=$word
done
echo "stress $*" | tee "$file"
END
chmod +x "$book/build/release/bin/stress"
table_of() { # OPTIONS: the tables that are written
    rm -rf "$book/build/stress"
    # shellcheck disable=SC2086
    "$book/book" stress $1 >/dev/null 2>&1
    # shellcheck disable=SC2046
    echo $(ls "$book/build/stress"), and no more
}
for kind in turning joints space; do
    for options in "--$kind --quick" "--quick --$kind" "--$kind --only x --quick" "--quick --only x --$kind"; do
        wants "stress $options" "tables: $(table_of "$options")" "tables: ${kind}_quick.csv, and no more"
        wants "stress $options" "$(cat "$book/build/stress/${kind}_quick.csv" 2>&1)" "$options"
    done
    wants "stress --$kind" "tables: $(table_of "--$kind")" "tables: $kind.csv, and no more"
done
wants "stress" "tables: $(table_of "")" "tables: matrix.csv, and no more"
wants "stress --quick --only x" "tables: $(table_of "--quick --only x")" "tables: quick.csv, and no more"
wants "stress --quick" "$(table_of --quick)" "joints_quick.csv quick.csv space_quick.csv turning_quick.csv, and no more"
said=$("$book/book" stress --joints --space 2>&1) && wants "stress --joints --space" "code 0" "a refusal"
wants "stress --joints --space" "$said" "--joints and --space are two matrices"

# What the doctor says with two packages missing, and on a system whose packages the script doesn't know. Nothing is installed.
printf '#!/bin/sh\nfor name; do :; done\ncase $name in libglfw3-dev | catch2) exit 1 ;; esac\necho "install ok installed"\n' >"$scratch/tools/dpkg-query"
printf '#!/bin/sh\necho called >"%s/apt"\n' "$scratch" >"$scratch/tools/apt-get"
chmod +x "$scratch/tools/dpkg-query" "$scratch/tools/apt-get"
printf 'ID=debian\n' >"$scratch/release"
said=$(BOOK_NO_INSTALL=0 BOOK_OS_RELEASE=$scratch/release "$book/book" doctor 2>&1) || wants "doctor" "code $?" "code 0"
wants "doctor" "$said" "docs    ready
        needs: python3 git doxygen graphviz"
wants "doctor" "$said" "run     missing: libglfw3-dev
        ./book setup run installs it
        needs: cmake"
wants "doctor" "$said" "test    missing: libglfw3-dev catch2
        ./book setup test installs it
        needs: cmake"
printf 'ID=another\n' >"$scratch/release"
printf '#!/bin/sh\n' >"$scratch/tools/ninja"
chmod +x "$scratch/tools/ninja"
said=$(BOOK_NO_INSTALL=0 BOOK_OS_RELEASE=$scratch/release "$book/book" doctor 2>&1) || wants "doctor elsewhere" "code $?" "code 0"
wants "doctor elsewhere" "$said" "cmake   $scratch/tools/cmake"
wants "doctor elsewhere" "$said" "ninja   $scratch/tools/ninja"
wants "doctor elsewhere" "$said" "test    on Debian 12: cmake"
[ ! -e "$scratch/apt" ] || wants "doctor" "apt-get was called" "nothing installed"

[ $faults = 0 ] && echo "book: all is well"
