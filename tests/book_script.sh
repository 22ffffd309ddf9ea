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
said=$("$book/book" small 2 2>&1) && wants "small 2" "code 0" "a refusal"
wants "small 2" "$said" "chapter 2 has no small program; there are: 1"
printf '// Chapter 2 in one file, grown from chapter 1.\nint two;\n' >"$book/chapters/02_two/small.cpp"
said=$("$book/book" small 2 --diff 2>&1 || true)
wants "small 2 --diff" "$said" "-int one;"
wants "small 2 --diff" "$said" "+int two;"
said=$("$book/book" small 1 --diff 2>&1) && wants "small 1 --diff" "code 0" "a refusal"
wants "small 1 --diff" "$said" "chapters/01_one/small.cpp grew from no other"
wants "small" "$("$book/book" small 2>&1)" "Chapter 2 in one file, grown from chapter 1."
said=$("$book/book" small 9 2>&1) && wants "small 9" "code 0" "a refusal"
wants "small 9" "$said" "there are: 1 2"
printf '#!/bin/sh\nexit 1\n' >"$scratch/tools/g++"
said=$("$book/book" small 2 2>&1) && wants "small 2 that is wrong" "code 0" "a refusal"
wants "small 2 that is wrong" "$said" "chapters/02_two/small.cpp does not compile"

# The reader's own headers: a list of one chapter, a program of tests that fails one of three.
cp -r "$(dirname "$script")/tests/mine" "$scratch/mine_tool"
mkdir -p "$book/tests/mine" "$book/build/mine/bin"
cp "$scratch/mine_tool/mine.py" "$book/tests/mine/"
printf 'in     chapters/01_one/idea.hpp\nempty  half  return 0;\n' >"$book/tests/mine/01.txt"
printf 'int half(int x)\n{\n    return x / 2;\n}\n' >"$book/chapters/01_one/idea.hpp"
printf '#!/bin/sh\necho "tags $1"\necho "test cases:  3 |  2 passed | 1 failed"\nexit 1\n' >"$book/build/mine/bin/test_01_one"
chmod +x "$book/build/mine/bin/test_01_one"
said=$("$book/book" test 1 --mine 2>&1) && wants "test 1 --mine" "code 0" "a refusal"
wants "test 1 --mine before it is begun" "$said" "begin with ./book mine 1"
said=$("$book/book" test 2 --mine 2>&1) && wants "test 2 --mine" "code 0" "a refusal"
wants "test 2 --mine" "$said" "chapter 2 has no header to write yourself"
wants "mine 1" "$("$book/book" mine 1)" "write half()"
wants "the emptied header" "$(cat "$book/mine/chapters/01_one/idea.hpp")" "return 0;"
said=$("$book/book" test 1 --mine 2>&1) && wants "test 1 --mine" "code 0" "code 1"
wants "test 1 --mine" "$said" "tags [idea]"
wants "test 1 --mine" "$said" "chapter 1: 2 of 3 idea tests pass"
wants "mine" "$("$book/book" mine)" "0 of 1 functions begun; 2 of 3 idea tests pass"
said=$("$book/book" test 1 2 --mine 2>&1) && wants "test 1 2 --mine" "code 0" "a refusal"
wants "test 1 2 --mine" "$said" "takes the number of one chapter"

[ $faults = 0 ] && echo "book: all is well"
