#!/usr/bin/env bash
# The real window draws only when there is something to see: none while nobody touches it, some when the pointer comes or a
# shader's file changes. Counted in frames, never in time. usage: xvfb-run … window_idle.sh WOLD MAKE_SMALL_WORLD OUT
set -euo pipefail
wold=$1 make_small_world=$2 out=$3
source "$(dirname "$0")/real_window.sh"

frames() { sed -n 's/.*the window rests after \([0-9]*\) frames.*/\1/p' "$home/log" | tail -1; }
drawn_since() { [ "$(frames)" -gt "$1" ]; }

source_folder=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$home/resources/app" "$home/resources/renderer" "$home/resources/projects"
cp -r "$source_folder/app/lang" "$home/resources/app/"
cp -r "$source_folder/renderer/shaders" "$home/resources/renderer/"
cp -r "$source_folder/projects/empty" "$home/resources/projects/"
export WOLD_RESOURCES=$home/resources

"$make_small_world" "$home/small"
xdotool mousemove 700 300
start "$home/small"
until_true 60 "the world" titled 'Small *'
until_true 120 "rest" rested
sleep 7 # the message that it was opened goes
before=$(frames)
sleep 5
[ "$(frames)" = "$before" ] || fail "frames were drawn though nothing happened: $before, then $(frames)"

xdotool mousemove 720 310
until_true 60 "drawing after the pointer moved" drawn_since "$before"
sleep 7
before=$(frames)
touch "$home/resources/renderer/shaders/tone_map.frag.glsl"
until_true 60 "drawing after a shader was written" drawn_since "$before"
quit
echo "window_idle: ok"
