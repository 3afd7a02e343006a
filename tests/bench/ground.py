#!/usr/bin/env python3
"""Makes a project with nothing but ground, as ground_bench measures it.

usage: tests/bench/ground.py FOLDER SIDE

Mountains of SIDE x SIDE points, a metre apart, from sums of sines, smoother the closer one looks as weathered ground is, as a PNG
of 16 bits. Beyond 4096 points they are mirrored, each piece a little higher than the one before: so no piece packs as the copy of
another, and a map of 16385 takes a minute.
"""
import array
import json
import math
import pathlib
import struct
import sys
import zlib


def rows(side):
    waves = [(2 * math.pi / (3000 / 1.9**i), 350 / 2.2**i, i * 1.7) for i in range(9)]
    along = [[math.sin(k * x + p) for x in range(side)] for k, _, p in waves]
    for z in range(side):
        line = [0.0] * side
        for i, (k, size, phase) in enumerate(waves):
            turned = math.sin(k * z * 1.3 + phase * 2) * size
            own, shifted = along[i], along[max(i - 1, 0)]
            other = math.cos(k * z * 0.7 + phase) * size * 0.5
            line = [h + turned * a + other * b for h, a, b in zip(line, own, shifted)]
        yield array.array("H", [min(65535, max(0, int((h + 1200) / 2400 * 65535))) for h in line])


PIECE = 4096


def spread(value, size, count):
    """The value of `size` bytes in each of `count` places of one long number."""
    return int.from_bytes(value.to_bytes(size, "big") * count, "big")


def wide_rows(side):
    """The rows of the map, as numbers of 16-bit digits: all texels of a piece are raised by one addition."""
    piece = min(side, PIECE)
    ahead, back = [], []
    for line in rows(piece):
        line.byteswap()
        ahead.append(int.from_bytes(line.tobytes(), "big"))
        line.reverse()
        back.append(int.from_bytes(line.tobytes(), "big"))
    ones = spread(1, 2, piece)
    for z in range(side):
        down, row = divmod(z, piece)
        row = row if down % 2 == 0 else piece - 1 - row
        line = b"".join(((back if across % 2 else ahead)[row] + ones * (7 * across + 13 * down)).to_bytes(piece * 2, "big")
                        for across in range(-(-side // piece)))
        yield int.from_bytes(line[:side * 2], "big")


def png(side):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    size = side * 2
    high = spread(0x80, 1, size)
    low = high ^ spread(0xFF, 1, size)
    packer, body, above = zlib.compressobj(1), [], 0
    for line in wide_rows(side):  # filter 2, less the row above: every byte by itself, as borrows end at its highest bit
        filtered = ((line | high) - (above & low)) ^ ((line ^ above ^ high) & high)
        body.append(packer.compress(b"\2" + filtered.to_bytes(size, "big")))
        above = line
    body.append(packer.flush())
    header = struct.pack(">IIBBBBB", side, side, 16, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", b"".join(body)) + chunk(b"IEND", b"")


def make(folder, side):
    folder = pathlib.Path(folder)
    for name in ("scenes", "environments", "templates", "terrain"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    write = lambda name, value: (folder / name).write_text(json.dumps(value))
    write("project.json", {"format": "wold-project", "version": 1, "name": "Ground", "start": "main", "scenes": [{"name": "main", "file": "scenes/main.scene.json"}],
                           "templates": [], "cameras": [{"name": "walker", "eye": [0, 400, 0]}]})
    write("environments/main.json", {"format": "wold-environment", "version": 1})
    write("scenes/main.scene.json", {"format": "wold-scene", "version": 1, "environment": "environments/main.json",
                                     "terrain": {"height_map": "terrain/heights.png", "metres_per_texel": 1, "origin": [-side / 2, -side / 2], "min_height": 0,
                                                 "max_height": 2400, "layers": []}, "objects": []})
    (folder / "terrain/heights.png").write_bytes(png(side))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    make(sys.argv[1], int(sys.argv[2]))
