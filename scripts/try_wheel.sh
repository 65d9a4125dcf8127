#!/bin/sh
# Builds the wheel, installs it into an empty environment below FOLDER and runs it from there: sh scripts/try_wheel.sh FOLDER
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/scripts/setup.sh"
folder=$(cd "$1" && pwd)
set_up_gl
set_up_packages test
"$python" -m pip wheel --quiet --disable-pip-version-check --no-deps --no-build-isolation --wheel-dir "$folder" "$root"
"$python" -m venv --clear "$folder/empty"
pip="$folder/empty/bin/python -m pip --disable-pip-version-check"
$pip install --quiet --no-input --require-hashes --only-binary :all: -r "$root/requirements/play.txt"
$pip install --quiet --no-input --no-deps "$folder"/topple-*.whl
$pip check    # the wheel asks for nothing that the lock does not hold
cd "$folder"
"$folder/empty/bin/python" -m game.warm_up
"$folder/empty/bin/topple" --headless --input performer:waving --seconds 0.5 --size 320x180 --quality low --picture wheel.png --report wheel.json
test -s wheel.png
test -s wheel.json
