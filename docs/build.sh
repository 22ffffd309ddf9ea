#!/bin/sh
# Builds the site of the book: build/docs/html/index.html.
#
#     docs/build.sh          check the texts, build the site, check the site
#     docs/build.sh check    only check the texts (needs nothing but python3)
#     docs/build.sh sync     fill the quoted code in from the sources, make the index of terms, the tables of chapter 19 and the drawing
#                            of the architecture
#     docs/build.sh test     test these tools themselves
#     docs/build.sh sentences    the table of what can be dragged in the texts, tests/small/sentences.csv (needs node)
#     docs/build.sh pdf [N]      print the site that is built, or chapter N of it: build/docs/book.pdf, build/docs/chapter_N.pdf
#     docs/build.sh site ADDRESS    where the site is published: the front page's link to play; `none` for nowhere
#
# DOXYGEN_AWESOME=FOLDER names another place of doxygen-awesome-css.
set -eu
cd "$(dirname "$0")/.."

say() { printf 'docs: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }
need() { command -v "$1" >/dev/null 2>&1 || fail "$1 is missing ($2); on Debian: apt-get install $3"; }

# Tools leave no __pycache__ in the book.
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE

# What a text says, and what its page would write, is the same.
sentences() { python3 docs/tools/sentences.py | node docs/web/test/sentences.mjs "$@"; }

# Print pages of the site: all, or those of one chapter.
print_site() {
    need node "it drives the browser" nodejs
    command -v "${CHROMIUM:-chromium}" >/dev/null 2>&1 || fail "chromium is missing (it prints); on Debian: apt-get install chromium"
    [ -f build/docs/html/index.html ] || fail "there is no site to print; ./book docs builds it"
    pdf=build/docs/${1:+chapter_}${1:-book}.pdf
    cp docs/theme/print.css build/docs/html/
    python3 docs/tools/print_pages.py build/docs/html ${1:+"$1"}
    [ -n "${1:-}" ] || say "printing the whole book: some minutes"
    node docs/web/print.mjs build/docs/html "$pdf"
    rm -f build/docs/html/print.html build/docs/html/print.css
}

check_texts() {
    faulty=0
    python3 docs/tools/sync_snippets.py --check || faulty=1
    python3 docs/tools/make_index.py --check || faulty=1
    python3 chapters/19_engine/benchmark/make_table.py --check || faulty=1
    python3 chapters/26_four_ways/benchmark/make_table.py --check || faulty=1
    python3 chapters/30_elastic_bodies/benchmark/make_table.py --check || faulty=1
    python3 docs/architecture/draw.py --check docs/architecture/figures/architecture.svg || faulty=1
    python3 docs/tools/check_version.py || faulty=1
    python3 docs/tools/check_text.py || faulty=1
    python3 docs/tools/redirects.py --check || faulty=1
    ! command -v node >/dev/null 2>&1 || sentences || faulty=1
    return $faulty
}

find_theme() {
    for theme in "${DOXYGEN_AWESOME:-}" /usr/share/doxygen-awesome-css /usr/local/share/doxygen-awesome-css; do
        [ -n "$theme" ] && [ -r "$theme/doxygen-awesome.css" ] && return 0
    done
    fail "doxygen-awesome-css is missing (the theme of the site); on Debian: apt-get install doxygen-awesome-css, elsewhere set DOXYGEN_AWESOME to its folder"
}

need python3 "it runs the checks" python3
case "${1:-build}" in
check) check_texts; say "the texts are in order"; exit 0 ;;
sync)
    python3 docs/tools/sync_snippets.py
    python3 docs/tools/make_index.py
    python3 chapters/19_engine/benchmark/make_table.py
    python3 chapters/26_four_ways/benchmark/make_table.py
    python3 chapters/30_elastic_bodies/benchmark/make_table.py
    exec python3 docs/architecture/draw.py docs/architecture/figures/architecture.svg
    ;;
test) exec python3 docs/tools/test_tools.py ;;
sentences) sentences --write; exit ;;
pdf) shift && print_site "$@"; exit ;;
site) shift && exec python3 docs/tools/site_address.py "$@" ;;
build) ;;
*) fail "knows build, check, sync, test, sentences, pdf and site, not '$1'" ;;
esac

need doxygen "it writes the site" doxygen
need dot "it draws the include graphs" graphviz
need bibtex "it sets the bibliography" texlive-binaries
find_theme

check_texts

rm -rf build/docs
mkdir -p build/docs/awesome
cp "$theme"/*.css "$theme"/*.js build/docs/awesome/

# The demos, where ./book web has built the programs for the pages: a still picture of each.
if [ -d build/web/demos ] && command -v node >/dev/null 2>&1; then
    python3 docs/tools/demos.py >build/docs/demos.list
    mkdir -p build/docs/demos
    node docs/web/stills.mjs build/web/demos build/docs/demos <build/docs/demos.list || fail "a demo can't be shown"
    if [ -f build/web/race/race.js ]; then
        cp build/web/race/race.js build/docs/demos/
        box2d=build/peers/node_modules/box2d3-wasm
        [ ! -d $box2d ] || python3 docs/race/pack_box2d.py $box2d build/docs/demos/box2d3_wasm.js
    fi
    say "with the demos of build/web"
else
    say "without demos: ./book web builds them"
fi

python3 docs/tools/doxygen_filter.py --all build/docs/filtered
# bibtex of a bare texlive-binaries has no configuration: it finds its files by these two.
BIBINPUTS=.: BSTINPUTS=.: doxygen docs/Doxyfile >build/docs/doxygen.log 2>&1 || {
    cat build/docs/doxygen.log >&2
    fail "Doxygen found faults"
}
python3 docs/tools/finish_html.py build/docs/html build/docs/book.tag
python3 docs/tools/search_texts.py build/docs/html build/docs/book.tag
# Numbers that can be dragged: the models that the pages name.
cp docs/web/sentence.js docs/web/sentence.css build/docs/html/
for name in $(grep -oh 'src="sentence_[^"]*[.]js' build/docs/html/*.html | sort -u | sed 's/.*sentence_\(.*\)\.js/\1/'); do
    cp "chapters/$name/sentence.js" "build/docs/html/sentence_$name.js"
done
if [ -d build/docs/demos ]; then
    mkdir -p build/docs/html/demos
    for script in unpack join machine painter demo cards; do cp docs/web/$script.js build/docs/html/; done
    cp docs/web/demo.css build/docs/html/
    # Only what a page shows.
    for name in $(grep -oh 'src="demos/[^"]*"' build/docs/html/*.html | sort -u | cut -d'"' -f2); do
        cp "build/docs/$name" "build/docs/html/$name"
    done
    for name in $(grep -oh 'data-program="[^"]*"' build/docs/html/*.html | sort -u | cut -d'"' -f2); do
        cp "build/web/demos/$name.js" build/docs/html/demos/
    done
    if [ -f build/docs/demos/race.js ]; then
        cp docs/race/race.js docs/race/box2d.js docs/race/race.css build/docs/html/
        for name in race box2d3_wasm; do
            [ ! -f build/docs/demos/$name.js ] || cp build/docs/demos/$name.js build/docs/html/demos/
        done
    fi
fi
# Old addresses of chapters lead on.
python3 docs/tools/redirects.py build/docs/html
python3 docs/tools/check_html.py build/docs/html
say "the site is build/docs/html/index.html"
