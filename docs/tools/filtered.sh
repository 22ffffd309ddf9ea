#!/bin/sh
# filtered.sh FILE: what docs/tools/doxygen_filter.py --all build/docs/filtered has made of a file of the book.
exec cat "build/docs/filtered${1#"$(pwd -P)"}"
