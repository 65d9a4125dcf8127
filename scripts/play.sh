#!/bin/sh
# Sets everything up, then starts the game: sh scripts/play.sh [options of run_game.py]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/scripts/setup.sh"
case " $* " in
    *" --no-draw "*) ;;    # needs no graphics
    *) set_up_gl ;;
esac
set_up play
exec "$python" "$root/run_game.py" "$@"
