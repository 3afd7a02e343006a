#!/usr/bin/env bash
# The real window, as a person uses it: under an X server, driven by xdotool. Opens a world, clicks an object, duplicates
# it, saves, takes a picture of the screen, and quits. usage: xvfb-run … window.sh WOLD MAKE_SMALL_WORLD OUT
set -euo pipefail
wold=$1 make_small_world=$2 out=$3
mkdir -p "$out"
home=$(mktemp -d)
editor=
finish() { [ -z "$editor" ] || kill "$editor" 2>/dev/null || true; rm -rf "$home"; }
trap finish EXIT
export HOME=$home XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=$home/cache
unset WAYLAND_DISPLAY
world=$home/world
scene=$world/scenes/main.scene.json
fail() { echo "window: $1" >&2; cat "$home/log" >&2 || true; exit 1; }
until_true() { # SECONDS WHAT COMMAND…
    local end=$((SECONDS + $1)) what=$2
    shift 2
    until "$@"; do [ $SECONDS -lt $end ] || fail "$what did not happen"; sleep 0.2; done
}
objects() { grep -c '"template":' "$scene" || true; }
picture() { import -silent -window root "$1"; }

"$make_small_world" "$world"
before=$(objects)

# Where the viewport is in a window of this size, by the same editor without a window.
echo '{"wait": 5}' > "$home/events.jsonl"
"$wold" edit "$world" --headless --replay "$home/events.jsonl" --size 1280x720 --ui-map "$home/map.json" --quiet
read -r x y < <(python3 - "$home/map.json" <<'PY'
import json, sys
rect = next(i["rect"] for i in json.load(open(sys.argv[1])) if i["panel"] == "viewport" and i["kind"] == "viewport")
print(int(rect[0] + rect[2] / 2), int(rect[1] + rect[3] / 2))
PY
)

"$wold" edit "$world" --size 1280x720 --record "$home/recorded.jsonl" > "$home/log" 2>&1 &
editor=$!
until_true 60 "a window" xdotool search --onlyvisible --name 'Small' > "$home/window"
window=$(head -1 "$home/window")
xdotool windowfocus "$window"
sleep 2
picture "$out/window-open.png"

xdotool mousemove "$x" "$y"
sleep 0.5
xdotool mousedown 1
sleep 0.3
xdotool mouseup 1
sleep 1
xdotool key --delay 120 ctrl+d
sleep 1
picture "$out/window-duplicated.png"
until_true 10 "the mark of unsaved changes in the title" sh -c "xdotool getwindowname $window | grep -q '[*•]'"
xdotool key --delay 120 ctrl+s
until_true 20 "a saved copy" sh -c "[ \$(grep -c '\"template\":' $scene) -eq $((before + 1)) ]"
picture "$out/window-saved.png"

xdotool key --delay 120 ctrl+q
until_true 20 "the end of the editor" sh -c "! kill -0 $editor 2>/dev/null"
wait "$editor" || fail "the editor ended with $?"
editor=
[ -f "$home/config/wold/settings.json" ] || fail "no settings were written"
cmp -s "$out/window-open.png" "$out/window-duplicated.png" && fail "the window did not change"

# What was recorded does the same again, without a window.
rm -rf "$world"
"$make_small_world" "$world"
"$wold" edit "$world" --headless --replay "$home/recorded.jsonl" --size 1280x720 --quiet || fail "the recording does not replay"
[ "$(objects)" -eq $((before + 1)) ] || { cat "$home/recorded.jsonl"; fail "the recording does something else"; }
echo "window: ok; the pictures lie in $out"
