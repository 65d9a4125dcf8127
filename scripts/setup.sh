# shellcheck shell=sh
# Sourced by play.sh, test.sh and try_wheel.sh: brings a bare computer to where Topple runs. `set_up_gl`, then `set_up play` or `set_up test`;
# $root is the project folder.
# Plain POSIX sh. TOPPLE_PYTHON names the Python to use; TOPPLE_VENV puts the environment elsewhere than .venv.

venv=${TOPPLE_VENV:-$root/.venv}
python=$venv/bin/python

say() {
    echo "topple: $*" >&2
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    else
        sudo "$@"
    fi
}

can_be_root() {
    [ "$(id -u)" = 0 ] && return 0
    command -v sudo >/dev/null || return 1
    sudo -n true 2>/dev/null && return 0
    [ -t 0 ] && [ -t 2 ]    # someone is there to type the password
}

has_gl() {
    libraries=$(PATH=$PATH:/sbin:/usr/sbin ldconfig -p 2>/dev/null) || return 0
    for library in libEGL.so.1 libGL.so.1 libX11.so.6 libXext.so.6; do
        case $libraries in
            *"$library"*) ;;
            *) return 1 ;;
        esac
    done
}

install_gl() {
    DEBIAN_FRONTEND=noninteractive
    export DEBIAN_FRONTEND
    as_root apt-get install --yes --quiet=2 --no-install-recommends libegl1 libgl1 </dev/null >/dev/null 2>&1 && return 0
    as_root apt-get update --quiet=2 </dev/null >/dev/null 2>&1 || true    # one dead repository must not stop the others
    as_root apt-get install --yes --quiet=2 --no-install-recommends libegl1 libgl1 </dev/null >&2
}

set_up_gl() {
    [ "$(uname -s)" = Linux ] || return 0
    has_gl && return 0
    if ! command -v apt-get >/dev/null; then
        say "pictures need the libraries libEGL, libGL, libX11 and libXext; please install them. Without them only --no-draw runs."
    elif ! can_be_root; then
        say "pictures need 'apt-get install --no-install-recommends libegl1 libgl1', which I have no rights for. Without it only --no-draw runs."
    else
        say "installing the graphics libraries libegl1 and libgl1 (about 50 MB, once)"
        install_gl || say "could not install libegl1 and libgl1; the lines above say why. Without them only --no-draw runs."
    fi
}

is_fit() {
    "$1" -c 'import ensurepip, sys, venv; raise SystemExit(not (3, 11) <= sys.version_info[:2] < (3, 14))' >/dev/null 2>&1
}

find_python() {
    if [ -n "${TOPPLE_PYTHON:-}" ]; then
        is_fit "$TOPPLE_PYTHON" && echo "$TOPPLE_PYTHON" && return 0
        say "TOPPLE_PYTHON=$TOPPLE_PYTHON is no Python 3.11, 3.12 or 3.13 with the venv module; name one, or unset it."
        return 1
    fi
    for candidate in python3.13 python3.12 python3.11 python3; do
        is_fit "$candidate" && echo "$candidate" && return 0
    done
    say "no Python 3.11, 3.12 or 3.13 with the venv module found; on Debian 12: apt-get install python3 python3-venv."
    return 1
}

# made-with holds the name of the Python that made the environment and the file it was: another name or file makes it anew.
is_made() {
    [ -x "$python" ] && [ -f "$venv/made-with" ] || return 1
    { read -r name && read -r file; } <"$venv/made-with" || return 1
    [ "$name" = "${TOPPLE_PYTHON:-$name}" ] && [ "$file" = "$(readlink -f "$python")" ]
}

make_venv() {
    is_made && return 0
    found=$(find_python) || return 1
    "$found" -m venv --clear "$venv" || return 1
    printf '%s\n' "$found" "$(readlink -f "$python")" >"$venv/made-with"
}

# The lock file that was installed last lies in the environment as a copy: equal means nothing is to be done.
is_installed() {
    cmp -s "$root/requirements/test.txt" "$venv/installed-test.txt" && return 0
    [ "$1" = play ] && cmp -s "$root/requirements/play.txt" "$venv/installed-play.txt"
}

install_packages() {
    say "installing the Python packages of requirements/$1.txt into $venv (once)"
    quiet=--quiet
    [ -t 2 ] && quiet=
    # shellcheck disable=SC2086 # $quiet is one word or none
    "$python" -m pip install $quiet --no-input --disable-pip-version-check --require-hashes --only-binary :all: \
        -r "$root/requirements/$1.txt" >&2 || {
        say "could not install the packages; the lines above say why. They come from the Python package index, so a network is needed."
        return 1
    }
    cp "$root/requirements/$1.txt" "$venv/installed-$1.txt"
}

# New packages compile anew. A first start would do it too, only with the player waiting, so a failure is no reason to stop here.
warm_up() {
    (cd "$root" && "$python" -m game.warm_up) || say "could not compile ahead; the lines above say why."
}

# Only the environment and the packages, nothing compiled; $fresh says whether packages came.
set_up_packages() {
    fresh=
    make_venv || exit 1
    is_installed "$1" && return 0
    install_packages "$1" || exit 1
    fresh=yes
}

set_up() {
    set_up_packages "$1"
    [ -z "$fresh" ] || warm_up
}
