#!/usr/bin/env bash
# Opening in the real window: a large world is cancelled and another opened instead, the large one is opened after all, and
# one with a damaged model is opened without it. usage: xvfb-run … window_loading.sh WOLD MAKE_SMALL_WORLD OUT
set -euo pipefail
wold=$1 make_small_world=$2 out=$3
source "$(dirname "$0")/real_window.sh"

"$make_small_world" "$home/small"
"$make_small_world" "$home/large"
"$make_small_world" "$home/damaged"
python3 - "$home/large" <<'PY'
import re, sys
project, scene = sys.argv[1] + "/project.json", sys.argv[1] + "/scenes/main.scene.json"
text = open(project).read()
open(project, "w").write(text.replace('"Small"', '"Large"'))
lines = open(scene).read().split("\n")
last = max(i for i, line in enumerate(lines) if '"template":' in line)
one = next(line for line in lines if '"template":' in line).rstrip(",")
extra = [re.sub(r'"id": *\d+', f'"id": {100 + i}',
                re.sub(r'"position": *\[[^]]*\]', f'"position":[{i % 447 * 4 - 900},0,{i // 447 * 4 - 1800}]', one))
         for i in range(200_000)]
if not lines[last].endswith(","):
    extra = [line if i == len(extra) - 1 else line + "," for i, line in enumerate(extra)]
    lines[last] += ","
else:
    extra = [line + "," for line in extra]
lines[last + 1:last + 1] = extra
open(scene, "w").write("\n".join(lines))
PY
mkdir -p "$XDG_CONFIG_HOME/wold"
echo "{\"version\": 1, \"recent\": [\"$home/small\"]}" > "$XDG_CONFIG_HOME/wold/settings.json"

# Escape while it is being read: the window answers, shows its first page again, and opens another world.
start "$home/large"
freeze
xdotool key Escape
thaw
sleep 3
until_true 60 "a window without a world" titled Wold
sleep 3
titled Wold || fail "what was cancelled has been opened: $(title)"
picture "$out/cancelled.png"
xdotool mousemove 350 330 # the first card under "Recent projects"
sleep 1
xdotool click 1
until_true 60 "opening another world" titled 'Small *'
quit

# All of it: the dialog says how far it is, then the world is there.
start "$home/large"
for i in 1 2 3; do picture "$out/loading-$i.png"; sleep 0.3; done
until_true 120 "opening a large world" titled 'Large *'
quit

# A damaged model is a message; everything else goes on.
head -c 100 "$home/damaged/models/crate.glb" > "$home/cut" && mv "$home/cut" "$home/damaged/models/crate.glb"
before=$(objects "$home/damaged")
start "$home/damaged"
until_true 60 "the world" titled 'Small *'
sleep 2
picture "$out/damaged.png"
grep -q 'crate.glb' "$home/log" || fail "nobody was told of the damaged model"
copied() { titled '*\**' || { xdotool key --delay 120 ctrl+a; xdotool key --delay 120 ctrl+d; sleep 1; titled '*\**'; }; }
saved() { [ "$(objects "$home/damaged")" -gt "$before" ]; }
until_true 30 "duplicating" copied
xdotool key --delay 120 ctrl+s
until_true 30 "saving" saved
quit

# A project that cannot be read at all: a message, and the window stays.
echo '{"name": ' > "$home/small/project.json"
start "$home/small"
until_true 60 "a word about the broken project" grep -q 'project.json:' "$home/log"
sleep 1
picture "$out/broken.png"
alive || fail "it ended"
xdotool key --delay 120 Return
quit
echo "window_loading: ok; the pictures lie in $out"
