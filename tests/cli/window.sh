#!/usr/bin/env bash
# The real window, as a person uses it: under an X server, driven by xdotool. Opens a world, clicks an object, duplicates
# it, saves, takes a picture of the screen, and quits. usage: xvfb-run … window.sh WOLD MAKE_SMALL_WORLD OUT
set -euo pipefail
wold=$1 make_small_world=$2 out=$3
source "$(dirname "$0")/real_window.sh"

world=$home/world
"$make_small_world" "$world"
calm "$world"
before=$(objects "$world")
read -r x y left top width height < <(place_of viewport "" viewport "$world")
view_rect_of "$x" "$y" "$left" "$top" "$width" "$height"
saved_copy() { [ "$(objects "$world")" -eq $((before + 1)) ]; }

start_in "$world" --record "$home/recorded.jsonl"
xdotool mousemove "$x" "$y"
still "$home/rest.png"
picture "$out/window-open.png"
xdotool mousedown 1
sleep 0.3
xdotool mouseup 1
until_true 30 "an outline around what was clicked" view_differs "$home/rest.png"
sleep 0.5
xdotool key --delay 120 ctrl+d
until_true 30 "the mark of unsaved changes in the title" titled '*\**'
picture "$out/window-duplicated.png"
xdotool key --delay 120 ctrl+s
until_true 30 "a saved copy" saved_copy
picture "$out/window-saved.png"
quit
[ -f "$home/config/wold/settings.json" ] || fail "no settings were written"

# What was recorded does the same again, without a window.
rm -rf "$world"
"$make_small_world" "$world"
"$wold" edit "$world" --headless --replay "$home/recorded.jsonl" --size 1280x720 --quiet || fail "the recording does not replay"
saved_copy || { cat "$home/recorded.jsonl"; fail "the recording does something else"; }
echo "window: ok; the pictures lie in $out"
