#!/usr/bin/env bash
# `cmake --install` gives a program that finds what it ships with. usage: install.sh CMAKE BUILD
set -euo pipefail
cmake=$1 build=$2
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
"$cmake" --install "$build" --prefix "$prefix" > "$prefix/log"
unset DISPLAY WAYLAND_DISPLAY
# Where the sources lie on this machine they would be found first.
export WOLD_RESOURCES=$prefix/share/wold HOME=$prefix
"$prefix/bin/wold" new "$prefix/mine" --from empty
"$prefix/bin/wold" render "$prefix/mine" --out "$prefix/mine.png" --size 64x36 --quiet
"$prefix/bin/wold" check "$prefix/share/wold/projects/valley"
test -s "$prefix/mine.png"
