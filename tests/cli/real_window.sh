# Sourced by the tests of the real window: an editor under an X server, driven by xdotool and seen through pictures of the
# screen. Needs $wold, $make_small_world and $out. Everything waits for what it wants to see, so a busy machine only takes longer.
mkdir -p "$out"
home=$(mktemp -d)
editor=
finish() { [ -z "$editor" ] || { kill -CONT "$editor"; kill "$editor"; } 2>/dev/null || true; rm -rf "$home"; }
trap finish EXIT
export HOME=$home XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=${XDG_CACHE_HOME:-$home/cache}
unset WAYLAND_DISPLAY
name=$(basename "$0" .sh)
fail() { echo "$name: $1" >&2; cat "$home/log" >&2 || true; picture "$out/failed.png" || true; exit 1; }
until_true() { # SECONDS WHAT COMMAND…
    local end=$((SECONDS + $1 * ${WOLD_TEST_PATIENCE:-1})) what=$2
    shift 2
    until "$@"; do [ $SECONDS -lt "$end" ] || fail "$what did not happen"; sleep 0.2; done
}
picture() { import -silent -window root "$1"; }
objects() { grep -c '"template":' "$1/scenes/main.scene.json" || true; }

# The middle of a widget in a window of 1280x720, by the same editor without a window. PANEL LABEL KIND EDIT-ARGUMENT…
place_of() {
    local panel=$1 label=$2 kind=$3
    shift 3
    echo '{"wait": 5}' > "$home/events.jsonl"
    "$wold" edit "$@" --headless --replay "$home/events.jsonl" --size 1280x720 --ui-map "$home/map.json" --quiet
    python3 - "$home/map.json" "$panel" "$label" "$kind" <<'PY'
import json, sys
panel, label, kind = sys.argv[2:]
rect = next(i["rect"] for i in json.load(open(sys.argv[1]))
            if i["panel"] == panel and i["kind"] == kind and label in ("", i["label"]))
print(int(rect[0] + rect[2] / 2), int(rect[1] + rect[3] / 2), *map(int, rect))
PY
}

calm() { # WORLD: clouds that move by themselves are no sign of anything
    sed -i 's/"speed": *[0-9.]*/"speed": 0/' "$1/environments/day.json"
}
# Of one quality: `auto` goes on to a lower one on a busy machine, and the picture changes with it.
start() { # EDIT-ARGUMENT…: the editor, in $window as soon as it is on the screen
    "$wold" edit "$@" --quality medium --size 1280x720 --log debug > "$home/log" 2>&1 &
    editor=$!
    until_true 60 "a window" sh -c "xdotool search --onlyvisible --name Wold > $home/window"
    window=$(head -1 "$home/window")
    xdotool windowfocus "$window"
}
# Before its first frame an editor has nothing that could be clicked, and while it opens a world it takes no clicks: once
# it waits for somebody it has opened it. Needs $view_rect.
rested() { grep -q "the window rests after" "$home/log"; }
seen() { rested && picture "$home/now.png" && view "$home/now.png" && [ "$(identify -format %k "$home/now.png")" -gt 200 ]; }
start_in() { # WORLD EDIT-ARGUMENT…: until it is seen
    start "$@"
    until_true 60 "the world" titled 'Small *'
    until_true 120 "a picture of the world" seen
}
title() { xdotool getwindowname "$window"; }
titled() { [[ "$(title)" == $1 ]]; } # PATTERN
alive() { kill -0 "$editor" 2>/dev/null; }
ended() { ! alive; }
ended_by_key() { ended || { xdotool key --delay 120 ctrl+q; sleep 1; ended; }; }
quit() {
    until_true 60 "the end of the editor" ended_by_key
    wait "$editor" || fail "the editor ended with $?"
    editor=
}

# What happens between these two, the editor sees within one frame, as on a machine that draws slowly.
freeze() { kill -STOP "$editor"; }
thaw() { kill -CONT "$editor"; }

view_rect_of() { # X Y LEFT TOP WIDTH HEIGHT of the viewport: without the overlays at its edges
    view_rect=$(($5 - 40))x$(($6 - 140))+$(($3 + 20))+$(($4 + 90))
}
view() { convert "$1" -crop "$view_rect" +repage "$1"; }
still() { # FILE: the viewport, once it has stopped changing: two frames may be more than a second apart on a busy machine
    local end=$((SECONDS + 60 * ${WOLD_TEST_PATIENCE:-1})) alike=0
    picture "$1" && view "$1"
    while [ $alike -lt 3 ]; do
        sleep 0.7
        picture "$home/next.png" && view "$home/next.png"
        if same "$1" "$home/next.png"; then alike=$((alike + 1)); else alike=0; fi
        [ $SECONDS -lt $end ] || fail "the view does not come to rest"
        mv "$home/next.png" "$1"
    done
}
same() { [ "$(compare -metric AE "$1" "$2" null: 2>&1)" = 0 ]; }
difference() { # A B: how many pixels differ, and where, of a failure that nobody sees
    convert "$1" "$2" -compose difference -composite -threshold 0 -trim -format '%[fx:mean*w*h] pixels within %wx%h%O' info:
}
view_differs() { picture "$home/now.png" && view "$home/now.png" && ! same "$1" "$home/now.png"; } # FROM

# The pixels of the pointer's image that can be seen.
pointer_pixels() {
    python3 - <<'PY'
import ctypes
class Image(ctypes.Structure):
    _fields_ = [(n, t) for n, t in [("x", ctypes.c_short), ("y", ctypes.c_short), ("width", ctypes.c_ushort),
                ("height", ctypes.c_ushort), ("xhot", ctypes.c_ushort), ("yhot", ctypes.c_ushort),
                ("serial", ctypes.c_ulong), ("pixels", ctypes.POINTER(ctypes.c_ulong))]]
x11, fixes = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXfixes.so.3")
x11.XOpenDisplay.restype = ctypes.c_void_p
fixes.XFixesGetCursorImage.restype = ctypes.POINTER(Image)
fixes.XFixesGetCursorImage.argtypes = [ctypes.c_void_p]
image = fixes.XFixesGetCursorImage(x11.XOpenDisplay(None)).contents
print(sum(image.pixels[i] >> 24 & 255 > 0 for i in range(image.width * image.height)))
PY
}
pointer_hidden() { [ "$(pointer_pixels)" = 0 ]; }
pointer_shown() { ! pointer_hidden; }
pointer_at() { [ "$(xdotool getmouselocation | cut -d' ' -f1,2)" = "x:$1 y:$2" ]; }
