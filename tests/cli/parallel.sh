#!/usr/bin/env bash
# A sequence of pictures shared out by GNU parallel, as the manual says it, is the one that a single call draws.
# usage: parallel.sh WOLD MAKE_SMALL_WORLD
set -euo pipefail
wold=$1 make_small_world=$2
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export HOME=$home XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=${XDG_CACHE_HOME:-$home/cache}
"$make_small_world" "$home/world"
mkdir "$home/alone" "$home/shared"
export wold draw="render $home/world --headless --path flight --size 160x90 --quiet"
$wold $draw --frames 0..7 --out "$home/alone/f.png"
export shared=$home/shared
seq 0 3 7 | parallel --will-cite -j 2 '$wold $draw --frames {}..$(({} + 2 < 7 ? {} + 2 : 7)) --out $shared/f.png'
for picture in "$home"/alone/*.png; do
    cmp "$picture" "$shared/$(basename "$picture")"
done
[ "$(ls "$shared" | wc -l)" = 8 ]
echo "parallel: ok"
