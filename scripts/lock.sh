#!/bin/sh
# Renews the locks after a change of the dependencies in pyproject.toml; needs uv (pip install uv).
#   sh scripts/lock.sh              keeps every locked version that still fits
#   sh scripts/lock.sh --upgrade    takes the newest of everything
set -eu
cd "$(dirname "$0")/.."
uv lock --default-index https://pypi.org/simple "$@"
# The same versions for plain pip, which scripts/setup.sh uses: what the game needs, and what its tests need besides.
export_lock() {
    uv export --quiet --frozen --no-emit-project --no-annotate --no-header --format requirements.txt "$@"
}
export_lock --no-default-groups --output-file requirements/play.txt >/dev/null
export_lock --output-file requirements/test.txt >/dev/null
