#!/bin/sh
# The film of the front page beside this script, light.gif and dark.gif, and still.svg for readers for whom nothing may move:
# docs/front/film.sh build/release/bin
set -eu
programs=$(cd "$1" && pwd)
cd "$(dirname "$0")"
scene="--scene wrecker --set rows=14 --headless"
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
for room in light dark; do
    dark=
    [ $room = light ] || dark=--dark
    # shellcheck disable=SC2086 # six seconds: 60 steps and 30 pictures a second
    "$programs/19_engine" $scene --steps 359 --record "$frames/$room" --every 2 $dark
    ../../book film "$frames/$room" $room.gif
done
# shellcheck disable=SC2086
"$programs/19_engine" $scene --steps 76 --svg still.svg
