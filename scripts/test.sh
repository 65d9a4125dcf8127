#!/bin/sh
# Sets everything up, then passes the tests: sh scripts/test.sh [options of pytest]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/scripts/setup.sh"
set_up_gl
set_up test
exec "$python" "$root/scripts/check.py" "$@"
