#!/usr/bin/env python3
"""What the reference pack's voxel programs cost beside their published forms, on the driver at hand.

Prints one line of JSON: a step of the floodfill in a volume of VOLUME^3 (atlas, texelFetch and pow; image
with all bricks; with 5 % of them), and a ray (cell by cell; in leaps). Settings take turns; of each the least
and the median of all frames are told, as the wall clock of a busy machine errs to one side."""

import argparse
import csv
import json
import pathlib
import shutil
import statistics
import subprocess
import tempfile

PROGRAMS = "shaders/program"
LIST = f"{PROGRAMS}/p1_floodfill_list.glsl"
GI = f"{PROGRAMS}/d0_gi.glsl"


def copy_of(pack, folder, edits):
    shutil.copytree(pack, folder)
    for file, before, after in edits:
        path = folder / file
        text = path.read_text()
        assert text.count(before) == 1, (file, before)
        path.write_text(text.replace(before, after))
    return folder


def times(args, pack, world, size, options, steps, wanted, folder):
    """Milliseconds of the steps together, of each frame that is wanted."""
    table = folder / "times.csv"
    subprocess.run([args.orris, "render", pack, world, "-o", folder / "picture.png", "--size", size,
                    "--frames", str(args.frames), "--timings", table, "--quiet", "--set",
                    "SHADOW_RESOLUTION=2048", *options], check=True)
    frames = {}
    for row in csv.DictReader(table.open()):
        if row["step"] in steps:
            frames.setdefault(int(row["frame"]), []).append(float(row["milliseconds"]))
    return [sum(parts) for frame, parts in frames.items() if wanted(frame)]


def measure(args, cases, steps, wanted, world, size, folder):
    found = {name: [] for name in cases}
    for _ in range(args.rounds):
        for name, (pack, options) in cases.items():
            found[name] += times(args, pack, world, size, options, steps, wanted, folder)
    return {name: {"least": round(min(v), 3), "median": round(statistics.median(v), 3)}
            for name, v in found.items()}


def ratios(result, of):
    base = result[of]
    return {name: {kind: round(v[kind] / base[kind], 3) for kind in v} for name, v in result.items()}


def step_cases(args, folder):
    bricks = "(all || is_active(brick))"
    forced = [copy_of(args.pack, folder / name, [(LIST, bricks, text)])
              for name, text in (("all", "true"), ("some", "brick % 20 == 0"))]
    common = ["GI_METHOD=FLOODFILL", f"VOXEL_SIZE={args.volume}", "FLOODFILL_INTERVAL=1"]
    return {"published": (args.pack, [*common, "FLOODFILL_STORAGE=ATLAS_2D"]),
            "again": (args.pack, [*common, "FLOODFILL_STORAGE=ATLAS_2D"]),
            "all bricks": (forced[0], common), "5 % of the bricks": (forced[1], common),
            "at rest or in motion": (args.pack, common)}


def ray_cases(args, folder):
    """Four rays a pixel that find a hit and nothing of its light; none, to take the rest of the pass off."""
    loop = "    for (int bounce = 0; bounce < gi_bounces; ++bounce) {\n"
    ray = ("    Hit only = trace(origin, cosine_direction(normal, next_random().xy));\n"
           "    if (viewWidth > 0.0) return only.position + vec3(only.found);\n" + loop)
    none = "    if (viewWidth > 0.0) return cosine_direction(normal, next_random().xy);\n" + loop
    rays = copy_of(args.pack, folder / "rays", [(GI, loop, ray)])
    empty = copy_of(args.pack, folder / "none", [(GI, loop, none)])
    common = ["GI_METHOD=BOUNCE_1", "GI_SAMPLES=4", "TEMPORAL_ACCUMULATION=false"]
    return {"none": (empty, [*common, "RAY_WALK=GRID"]), "cells": (rays, [*common, "RAY_WALK=GRID"]),
            "leaps": (rays, [*common, "RAY_WALK=DISTANCE"])}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("world", type=pathlib.Path)
    parser.add_argument("--volume", type=int, default=128, help="VOXEL_SIZE of the steps")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--frames", type=int, default=8)
    parser.add_argument("--only", choices=["steps", "rays"])
    args = parser.parse_args()
    result = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if args.only != "rays":
            steps = measure(args, step_cases(args, folder), {"prepare", "prepare1", "prepare2"},
                            lambda frame: frame > 1, args.world, "64x36", folder)
            result["step"] = {"milliseconds": steps, "over published": ratios(steps, "published")}
        if args.only != "steps":
            rays = measure(args, ray_cases(args, folder), {"deferred"}, lambda frame: frame > 1,
                           args.world, "320x180", folder)
            for kind in ("least", "median"):
                none = rays["none"][kind]
                for case in ("cells", "leaps"):
                    rays[case][kind] = round(rays[case][kind] - none, 3)
            result["ray"] = {"milliseconds": rays, "over cells": ratios(rays, "cells")["leaps"]}
    print(json.dumps(result))


if __name__ == "__main__":
    main()
