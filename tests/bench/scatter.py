#!/usr/bin/env python3
"""Makes a project of many objects on level ground, for measuring. usage: tests/bench/scatter.py FOLDER COUNT

The objects are those of projects/forest-3, about as dense, along a spiral from the middle: a smaller world is the
inner part of a larger one, and the camera "view" and the path "turn" see the same five hundred or so in each.
"""
import json
import math
import pathlib
import random
import shutil
import struct
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SPACING = 8.2  # m
WEIGHTS = {"Tree1": 18, "Tree2": 17, "Tree3": 17, "AutumnTree1": 17, "AutumnTree2": 18, "DeadTree": 4, "FirTree": 4, "Rock2": 3,
           "DeadBranch": 2}
GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))


def level_png(side):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows = bytes((1 + 2 * side) * side)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 16, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def object_lines(count):
    dice = random.Random(1)
    names = dice.choices(list(WEIGHTS), weights=list(WEIGHTS.values()), k=count)
    for i, name in enumerate(names):
        radius = SPACING / math.sqrt(math.pi) * math.sqrt(i + 0.5)
        x = radius * math.cos(i * GOLDEN_ANGLE) + dice.uniform(-2, 2)
        z = radius * math.sin(i * GOLDEN_ANGLE) + dice.uniform(-2, 2)
        size = round(dice.uniform(0.85, 1.18), 2)
        yield (f'{{"id":{i + 1},"template":"{name}","position":[{x:.2f},-0.4,{z:.2f}],"rotation":[0,{dice.uniform(-180, 180):.1f},0],'
               f'"scale":[{size},{size},{size}]}}')


def make(folder, count):
    forest = ROOT / "projects/forest-3"
    for part in ("templates", "models"):
        (folder / part).mkdir(parents=True)
        suffix = ".json" if part == "templates" else ".glb"
        for name in WEIGHTS:
            shutil.copy(forest / part / (name + suffix), folder / part)
    shutil.copytree(forest / "environments", folder / "environments")
    for part in ("scenes", "terrain"):
        (folder / part).mkdir()
    (folder / "terrain/level.png").write_bytes(level_png(257))
    keys = [{"time": i, "eye": [0, 60, 0], "yaw": i * 15, "pitch": -50, "fov": 60} for i in range(4)]
    (folder / "project.json").write_text(json.dumps({
        "format": "wold-project", "version": 1, "name": f"Scatter {count}", "start": "main",
        "scenes": [{"name": "main", "file": "scenes/main.scene.json"}], "templates": list(WEIGHTS),
        "cameras": [{"name": "view", **{key: value for key, value in keys[0].items() if key != "time"}}],
        "paths": [{"name": "turn", "keys": keys}]}))
    head = {"format": "wold-scene", "version": 1, "environment": "environments/main.json",
            "terrain": {"height_map": "terrain/level.png", "metres_per_texel": 40, "origin": [-5120, -5120], "min_height": 0,
                        "max_height": 100, "layers": [{"name": "Ground", "colour": [0.12, 0.1, 0.06]}]}}
    with open(folder / "scenes/main.scene.json", "w") as file:
        file.write(json.dumps(head, indent=2)[:-2] + ',\n  "objects": [\n')
        file.write(",\n".join(object_lines(count)))
        file.write("\n]}\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    make(pathlib.Path(sys.argv[1]), int(sys.argv[2]))
