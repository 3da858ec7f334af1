#!/usr/bin/env python3
"""What the reference pack's voxel programs cost beside their published forms, on a software rasteriser.

Prints one line of JSON, nanoseconds of processor time and what they are over the published form: a step of the floodfill for each cell of a volume of
VOLUME^3 (atlas, texelFetch and pow; image with all bricks; with 5 % of them; at rest), and a ray (cell by cell;
in leaps). Settings take turns; a time is that of a long run less that of a short one, and less that of the same
frames without the step or ray. Prints the least of the rounds: other work on the machine only adds."""

import argparse
import json
import pathlib
import resource
import shutil
import subprocess
import tempfile

PROGRAMS = "shaders/program"
LIST = f"{PROGRAMS}/floodfill/image_list.glsl"
GI = "shaders/include/gi/gather.glsl"
FEATURES = "shaders/include/derived/features.glsl"
CHANGES = "(HAS_FACE_CACHE || HAS_FLOOD_IMAGE || HAS_DISTANCES)"


def copy_of(pack, folder, edits):
    shutil.copytree(pack, folder)
    for file, before, after in edits:
        path = folder / file
        text = path.read_text()
        assert text.count(before) == 1, (file, before)
        path.write_text(text.replace(before, after))
    return folder


def processor_seconds(args, pack, options, size, frames, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([args.orris, "render", pack, args.world, "-o", folder / "picture.png", "--size", size,
                    "--frames", str(frames), "--quiet", "--set", "SHADOW_RESOLUTION=2048", *options],
                   check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def measure(args, cases, size, count, folder, without):
    """Nanoseconds of each of `count` things in a frame, by case; `without`: cases that have none, by what they are taken off from."""
    found = {name: [] for name in cases}
    for pack, options in cases.values():
        processor_seconds(args, pack, options, size, 2, folder)  # fills the driver's cache of programs
    for _ in range(args.rounds):
        for name, (pack, options) in cases.items():
            seconds = [processor_seconds(args, pack, options, size, frames, folder)
                       for frames in (4, 4 + args.frames)]
            found[name].append((seconds[1] - seconds[0]) / args.frames)
    least = {name: min(values) for name, values in found.items()}
    return {name: round((least[name] - least[none]) / count * 1e9, 1) for name, none in without.items()}


def room_world(folder, size, height=None):
    """A closed room that fills a volume of size x height x size, with a pillar and a lamp every 16 blocks; the eye is in its
    middle. As high as wide by default."""
    last, top = size - 5, (height or size) - 5
    places = [i for i in range(8, last - 5, 16) if abs(i - size // 2) > 2]
    pillars = [{"box": "red_concrete", "min": [x, 1, z], "max": [x + 1, top * 2 // 3, z + 1]} for x in places for z in places]
    lamps = {"block": "sea_lantern", "at": [[x + 4, top, z + 4] for x in places for z in places]}
    folder.mkdir()
    middle, level = size / 2 - 1.5, (height or size) / 2 - 1.5
    (folder / "world.json").write_text(json.dumps({
        "size": [last + 1, top + 1, last + 1],
        "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [last, top, last]}, *pillars, lamps],
        "cameras": [{"name": "middle", "position": [middle, level, middle], "yaw": 150, "pitch": 10, "fov": 90}],
        "environment": {"time": 18000}}))
    return folder


def step_cases(args, folder):
    """
    >>> args = argparse.Namespace(pack=pathlib.Path(__file__).parents[2] / "shaderpack", volume=64)
    >>> with tempfile.TemporaryDirectory() as name:
    ...     list(step_cases(args, pathlib.Path(name)))
    ['published', 'again', 'all bricks', '5 % of the bricks', 'none', 'as it is']
    """
    bricks = "(all || restless.light || restless.blocks)"
    forced = [copy_of(args.pack, folder / name, [(LIST, bricks, text)])
              for name, text in (("all", "true"), ("some", "brick % 20 == 0"), ("none", "false"))]
    common = ["GI_METHOD=FLOODFILL", f"VOXEL_SIZE={args.volume}", "FLOODFILL_INTERVAL=1"]
    return {"published": (args.pack, [*common, "FLOODFILL_STORAGE=ATLAS_2D"]),
            "again": (args.pack, [*common, "FLOODFILL_STORAGE=ATLAS_2D"]),
            "all bricks": (forced[0], common), "5 % of the bricks": (forced[1], common),
            "none": (forced[2], common), "as it is": (args.pack, common)}


def ray_cases(args, folder):
    """Four rays a pixel that find a hit and nothing of its light; none, to take the rest of the pass off.

    >>> args = argparse.Namespace(pack=pathlib.Path(__file__).parents[2] / "shaderpack", volume=64)
    >>> with tempfile.TemporaryDirectory() as name:
    ...     list(ray_cases(args, pathlib.Path(name)))
    ['no cells', 'cells', 'no leaps', 'leaps']
    """
    loop = "    for (int bounce = 0; bounce < gi_bounces; ++bounce) {\n"
    ray = ("    Hit only = trace_from_face(origin, cosine_direction(normal, next_random().xy));\n"
           "    if (viewWidth > 0.0) return only.position + vec3(only.found);\n" + loop)
    none = "    if (viewWidth > 0.0) return cosine_direction(normal, next_random().xy);\n" + loop
    # Without this cells would know fewer shapes than leaps.
    shapes = [(file, CHANGES, "(HAS_VOXELS)") for file in (FEATURES, "shaders/shaders.properties")]
    rays = copy_of(args.pack, folder / "rays", [(GI, loop, ray), *shapes])
    empty = copy_of(args.pack, folder / "none", [(GI, loop, none), *shapes])
    common = ["GI_METHOD=BOUNCE_1", "GI_SAMPLES=4", "TEMPORAL_ACCUMULATION=false", f"VOXEL_SIZE={args.volume}"]
    grid, distance = [*common, "RAY_WALK=GRID"], [*common, "RAY_WALK=DISTANCE"]
    return {"no cells": (empty, grid), "cells": (rays, grid), "no leaps": (empty, distance), "leaps": (rays, distance)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("world", type=pathlib.Path, help="or 'room': a closed one that fills the volume")
    parser.add_argument("--volume", type=int, default=128, help="VOXEL_SIZE")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--frames", type=int, default=20)
    parser.add_argument("--only", choices=["steps", "rays"])
    args = parser.parse_args()
    result = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if str(args.world) == "room":
            args.world = room_world(folder / "room", args.volume)
        if args.only != "rays":
            cases = step_cases(args, folder)
            result["step"] = measure(args, cases, "16x9", args.volume ** 3, folder, {name: "none" for name in cases})
        if args.only != "steps":
            result["ray"] = measure(args, ray_cases(args, folder), "320x180", 4 * 320 * 180, folder,
                                    {"cells": "no cells", "leaps": "no leaps"})
    for kind, published in (("step", "published"), ("ray", "cells")):
        if kind in result:
            result[f"{kind} over {published}"] = {name: round(value / result[kind][published], 2)
                                                 for name, value in result[kind].items()}
    print(json.dumps(result))


if __name__ == "__main__":
    main()
