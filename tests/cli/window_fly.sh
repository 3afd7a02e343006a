#!/usr/bin/env bash
# Flying by hand in the real window: what moves the view and what does not. usage: xvfb-run … window_fly.sh WOLD MAKE_SMALL_WORLD OUT
set -euo pipefail
wold=$1 make_small_world=$2 out=$3
source "$(dirname "$0")/real_window.sh"

duplicated() { titled '*\**' || { xdotool key --delay 120 ctrl+d; sleep 1; titled '*\**'; }; }
saved_copy() { [ "$(objects "$home/again")" -gt "$before" ]; }

world=$home/world
"$make_small_world" "$world"
calm "$world"
read -r x y left top width height < <(place_of viewport "" viewport "$world")
read -r search_x search_y _ < <(place_of hierarchy "Search objects" text "$world")
view_rect_of "$x" "$y" "$left" "$top" "$width" "$height"
sky_x=$((x - 300)) sky_y=$((top + 60))

start_in "$world"
xdotool mousemove $sky_x $sky_y
still "$home/rest.png"

# The right button hides the pointer; W flies; letting go brings the pointer back to where it was.
xdotool mousedown 3
until_true 30 "a hidden pointer" pointer_hidden
xdotool keydown w
until_true 60 "flying" view_differs "$home/rest.png"
sleep 0.5
xdotool keyup w mouseup 3
until_true 30 "a pointer that is seen again" pointer_shown
until_true 10 "a pointer where it was" pointer_at $sky_x $sky_y
still "$out/flown.png"
same "$home/rest.png" "$out/flown.png" && fail "the view is where it was"

# Looking around.
xdotool mousedown 3
until_true 30 "a hidden pointer" pointer_hidden
xdotool mousemove_relative 40 10
until_true 30 "looking" view_differs "$out/flown.png"
xdotool mouseup 3
until_true 30 "a pointer that is seen again" pointer_shown
still "$out/looked.png"

# On a slow machine: the way of the pointer to the press is no look. Not to the very pixel where the look before began:
# GLFW 3.3 put the pointer back there, and takes a move that ends there for its own.
freeze
xdotool mousemove $x $y mousemove $((sky_x + 5)) $sky_y mousedown 3
thaw
until_true 30 "a hidden pointer" pointer_hidden
sleep 0.5
xdotool mouseup 3
until_true 30 "a pointer that is seen again" pointer_shown
until_true 30 "the menu that a press at rest opens" view_differs "$out/looked.png"
xdotool key --delay 120 Escape
still "$out/pressed.png"
same "$out/looked.png" "$out/pressed.png" || fail "the pointer's way to the press was a look: $(difference "$out/looked.png" "$out/pressed.png")"

# A key that was held when the window lost the keyboard is not held for ever.
xdotool mousedown 3
until_true 30 "a hidden pointer" pointer_hidden
xdotool keydown s
until_true 60 "flying back" view_differs "$out/looked.png"
xdotool windowfocus "$(xdotool search --maxdepth 0 --name '.*' 2>/dev/null | head -1)"
xdotool keyup s mouseup 3
still "$out/focus-lost.png"
xdotool windowfocus "$window"
still "$home/focus-again.png"
same "$out/focus-lost.png" "$home/focus-again.png" || fail "the view flies on after the keyboard was away"

# Letters that are typed do not fly.
xdotool mousemove "$search_x" "$search_y" click 1
sleep 1
xdotool type --delay 80 wasdqe
still "$out/typed.png"
same "$out/focus-lost.png" "$out/typed.png" || fail "typing moved the view"
xdotool key Escape

# A click counts where it was made, though the pointer went on before the editor could look; and as it was made, though
# Ctrl was let go since: one beside everything takes nothing from the selection then.
quit
"$make_small_world" "$home/again"
calm "$home/again"
before=$(objects "$home/again")
start_in "$home/again"
still "$home/rest.png"
freeze
xdotool mousemove "$x" "$y" click 1 mousemove $sky_x $sky_y
thaw
sleep 1
freeze
xdotool keydown ctrl click 1 keyup ctrl
thaw
sleep 1
until_true 30 "a duplicate of what was clicked" duplicated
xdotool key --delay 120 ctrl+q
sleep 2
alive || fail "it ended without asking about unsaved changes"
picture "$out/asked.png"
xdotool key --delay 120 Escape
sleep 1
xdotool key --delay 120 ctrl+s
until_true 30 "a saved copy" saved_copy
quit
echo "window_fly: ok; the pictures lie in $out"
