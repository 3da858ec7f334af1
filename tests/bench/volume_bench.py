#!/usr/bin/env python3
"""How the cost of the floodfill grows with the lit volume: closed rooms with pillars and lamps that fill volumes of
VOXEL_SIZE^3, the last of 256 x 128 x 256, all of whose bricks are made to step. Writes OUT.csv and draws OUT.svg and OUT.png by gnuplot.

Processor time by pass (`orris render --timings`), the least of the frames: what else runs only adds."""

import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

from voxel_bench import LIST, copy_of, room_world

SIZES = [32, 48, 64, 96, 128, 256]
HIGHEST = 128
FACES_MOST = 128  # side of the largest volume of the face cache
STEP = ("prepare",)
LIGHT = ("deferred", "prepare", "shadowcomp")  # and not deferred6, which lights by it
METHODS = ["BOUNCE_1", "FLOODFILL", "FACE_CACHE"]
PLOT = """set datafile separator ','
set logscale xy
set format x '10^{{%T}}'
set xlabel 'lit cells'
set ylabel 'milliseconds of processor time'
set key bottom right
set grid
set terminal {terminal}
set output '{out}'
step(x) = {first} * x / {cells}
plot step(x) title 'linear in the first' lc 'gray' dt 2, \\
  '{csv}' skip 1 using 2:3 with linespoints title 'a step', \\
  '' skip 1 using 2:5 with linespoints title 'rays, BOUNCE_1' noenhanced, \\
  '' skip 1 using 2:6 with linespoints title 'rays and step, FLOODFILL' noenhanced, \\
  '' skip 1 using 2:7 with linespoints title 'rays and faces, FACE_CACHE' noenhanced
"""


def render(args, pack, world, size, method, folder):
    """Milliseconds by frame and pass, and the counters of the last frame."""
    table = folder / "times.csv"
    done = subprocess.run([args.orris, "render", pack, world, "-o", folder / "picture.png", "--size", args.size,
                           "--frames", str(args.frames), "--json", "--timings", table, "--set", f"VOXEL_SIZE={size}",
                           f"GI_METHOD={method}", f"SHADOW_RESOLUTION={2048 if size <= 128 else 4096}",
                           "SHADOW_DISTANCE=128.0", "FLOODFILL_INTERVAL=1"],
                          check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    frames = {}
    with table.open() as file:
        for row in csv.DictReader(file):
            passes = frames.setdefault(int(row["frame"]), {})
            passes[row["step"]] = passes.get(row["step"], 0) + float(row["processor_milliseconds"])
    return frames, json.loads(done.stdout).get("counters", {})


def least(frames, names):
    """Of a frame but the first four, in which caches fill and distances are made."""
    return min(sum(ms for name, ms in passes.items() if name.startswith(names) and name != "deferred6")
               for frame, passes in frames.items() if frame >= 4)


def rows(args, folder):
    forced = copy_of(args.pack, folder / "all", [(LIST, "(all || restless.light || restless.blocks)", "true")])
    for size in SIZES:
        height = min(size, HIGHEST)
        world = room_world(folder / f"room{size}", size, height)
        cells = (size - 6) ** 2 * (height - 6)
        step, listed = render(args, forced, world, size, "FLOODFILL", folder)
        row = {"size": size, "lit cells": cells, "step ms": round(least(step, STEP), 3),
               "bricks": listed["flood_state"][0]}
        for method in METHODS:
            if method == "FACE_CACHE" and size > FACES_MOST:
                row[method] = ""
                continue
            pack = forced if method == "FLOODFILL" else args.pack
            frames = step if method == "FLOODFILL" else render(args, pack, world, size, method, folder)[0]
            row[method] = round(least(frames, LIGHT), 3)
        print(row, flush=True)
        yield row


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path, help="without its ending")
    parser.add_argument("--size", default="80x45")
    parser.add_argument("--frames", type=int, default=14)
    args = parser.parse_args()
    table = args.out.with_suffix(".csv")
    with tempfile.TemporaryDirectory() as name:
        found = list(rows(args, pathlib.Path(name)))
    with table.open("w", newline="") as file:
        writer = csv.DictWriter(file, found[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(found)
    for ending, terminal in (("svg", "svg size 640,420"), ("png", "pngcairo size 640,420")):
        script = PLOT.format(terminal=terminal, out=args.out.with_suffix("." + ending), csv=table,
                             first=found[0]["step ms"], cells=found[0]["lit cells"])
        subprocess.run(["gnuplot"], input=script, text=True, check=True)


if __name__ == "__main__":
    main()
