#!/usr/bin/env python3
"""cycles_compare.py PROGRAM SOURCE: `orris trace` beside Blender's Cycles, which renders an `orris world --export`.

Prints a table by scene: the ratio Cycles / trace of the whole picture by channel, and of tiles of it. Two rows each:

shared    Cycles has what pack and reference agree on: lamps light evenly in their listed colour, small ones as balls,
          and the sun on what the camera sees is reflected by Phong's formula (a share of .1 in a lobe).
physical  lamps light as they are drawn, and every surface is Lambert's.

Both have one ray through the middle of each pixel. Cycles reads the texel that it meets where the trace blends the
rasteriser's levels, of the same mean: tiles of many pixels do not see that. Pixels that show a lamp itself do, whose
texture is all they show; they are left out.
With --check it fails where, in the row `shared`, the picture is more than 2 % off or a tile more than that and three
standard errors.
Ends with 77 where Blender or its numpy is absent.
"""
import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "app"))
from exr_file import read_exr  # noqa: E402

VIEWS = ["cornell:front", "deep_hall:mouth", "h4_house:inside"]
SKIPPED = 77
BAR = 0.02
# Of pack and tracer: shaderpack/shaders/include/brdf/direct.glsl.
PHONG_SHARE, PHONG_EXPONENT = 0.1, 5


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("source", type=Path)
    parser.add_argument("--view", action="append", help="WORLD:CAMERA; default " + " ".join(VIEWS))
    parser.add_argument("--size", default="192x144")
    parser.add_argument("--tile", type=int, default=48, help="pixels a side")
    parser.add_argument("--samples", type=int, default=128, help="a pixel, of either renderer")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--keep", type=Path, help="folder for exports, pictures and tiles.json")
    parser.add_argument("--blender", default="blender")
    parser.add_argument("--check", action="store_true")
    return parser.parse_args()


def beside(blender):
    """The environment for Blender, which takes the modules of the first python3 on PATH: that of its own folder."""
    return {**os.environ, "PATH": f"{Path(shutil.which(blender)).resolve().parent}:{os.environ['PATH']}"}


def missing(blender):
    """Why there is nothing to compare with; None when there is."""
    if shutil.which(blender) is None:
        return f"there is no {blender} (Debian: blender)"
    asked = "import numpy; print('numpy found')"
    found = subprocess.run([blender, "-b", "-noaudio", "--factory-startup", "--python-expr", asked],
                           capture_output=True, text=True, check=False, env=beside(blender))
    return None if "numpy found" in found.stdout else "Blender's Python has no numpy (Debian: python3-numpy)"


def run(command, environment=None):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, env=environment)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.returncode}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}")
    return done.stdout


def picture(planes, layer, names="RGB"):
    """Pixels as triples, row by row."""
    rows = [planes[f"{layer}{name}"] for name in names]
    return [list(zip(*line)) for line in zip(*rows)]


def add(*terms):
    """Sum of (factor, picture)."""
    height, width = len(terms[0][1]), len(terms[0][1][0])
    return [[tuple(sum(factor * image[y][x][c] for factor, image in terms) for c in range(3)) for x in range(width)]
            for y in range(height)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def unit(v):
    length = math.sqrt(dot(v, v)) or 1
    return tuple(x / length for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def turned(q, v):
    """A vector by a quaternion x, y, z, w."""
    x, y, z, w = q
    u = (x, y, z)
    t = tuple(2 * c for c in cross(u, v))
    return tuple(v[i] + w * t[i] + cross(u, t)[i] for i in range(3))


def to_blender(v):
    return v[0], -v[2], v[1]


def glb_json(path):
    data = path.read_bytes()
    return json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])


def phong(sun, planes, scene, camera):
    """The sun on what the camera sees, by Phong's formula: from Lambert's, albedo, normals and places of Cycles."""
    nodes = {node["name"]: node for node in scene["nodes"]}
    if "sun or moon" not in nodes:
        return sun
    to_sun = to_blender(turned(nodes["sun or moon"]["rotation"], (0, 0, 1)))
    eye = to_blender(nodes[camera]["translation"])
    albedo = picture(planes, "ViewLayer.DiffCol.")
    normal, place = (picture(planes, f"ViewLayer.{name}.", "XYZ") for name in ("Normal", "Position"))
    result = []
    for y, line in enumerate(sun):
        result.append([])
        for x, lit in enumerate(line):
            n = normal[y][x]
            to_eye = unit(tuple(eye[i] - place[y][x][i] for i in range(3)))
            mirrored = tuple(2 * dot(n, to_sun) * n[i] - to_sun[i] for i in range(3))
            lobe = max(dot(mirrored, to_eye), 0) ** PHONG_EXPONENT * (PHONG_EXPONENT + 2) / 2
            result[-1].append(tuple(
                value * (1 - PHONG_SHARE + PHONG_SHARE * lobe / max(albedo[y][x][c], 1e-4)) if value > 0 else 0
                for c, value in enumerate(lit)))
    return result


def tiles(image, edge, lamps):
    """Means of squares, left to right, top to bottom; of those that are mostly lamp, None."""
    means = []
    for top in range(0, len(image) - edge + 1, edge):
        for left in range(0, len(image[0]) - edge + 1, edge):
            pixels = [image[y][x] for y in range(top, top + edge) for x in range(left, left + edge) if not lamps[y][x]]
            means.append(tuple(sum(pixel[c] for pixel in pixels) / len(pixels) for c in range(3))
                         if 2 * len(pixels) >= edge * edge else None)
    return means


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def judged(halves, traced, edge, lamps):
    """Ratios of the picture and of tiles, with their standard errors from two halves of each renderer."""
    parts = [[[tile for tile in tiles(half, edge, lamps) if tile] for half in pair] for pair in (halves, traced)]
    theirs, ours = ([[mean((a[c], b[c])) for c in range(3)] for a, b in zip(*pair, strict=True)] for pair in parts)
    whole = [mean(t[c] for t in theirs) / mean(t[c] for t in ours) for c in range(3)]
    ratios = [[t[c] / max(o[c], 1e-9) for c in range(3)] for t, o in zip(theirs, ours, strict=True)]
    # The halves of one tile say little of its noise; those of all tiles, as shares of their light, say it well.
    noise = math.sqrt(sum(mean(((a[c] - b[c]) / 2 / max(o[c], 1e-9)) ** 2
                               for a, b, o in zip(*pair, ours) for c in range(3)) for pair in parts))
    off = [max(abs(ratio - 1) for ratio in tile) for tile in ratios]
    return {"whole": whole, "tiles": ratios, "noise": noise, "worst": max(off), "median": sorted(off)[len(off) // 2],
            "within": mean(value <= BAR for value in off)}


def has_lamps(scene):
    lights = scene.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    return (any("emissiveFactor" in material for material in scene["materials"])
            or any(light["type"] == "point" for light in lights))


def cycles(options, glb, camera, row, stem):
    """Two halves of a picture by Cycles, and its sun alone: the channels of each."""
    outs = [f"{stem}_{row}_{name}.exr" for name in ("a", "b", "sun")]
    renders = [{"out": outs[i], "samples": options.samples // 2, "seed": 11 + i, "sun_only": False} for i in (0, 1)]
    renders.append({"out": outs[2], "samples": 1, "seed": 5, "sun_only": True})
    job = Path(f"{stem}_{row}.json")
    size = [int(side) for side in options.size.split("x")]
    job.write_text(json.dumps({"scene": str(glb), "camera": camera, "size": size,
                               "threads": options.threads, "physical": row == "physical", "renders": renders}))
    said = run([options.blender, "-b", "-noaudio", "--factory-startup", "-P", HERE / "cycles_render.py", "--", job],
               beside(options.blender))
    if "CYCLES DONE" not in said:
        sys.exit(f"Blender did not finish {job}:\n{said[-3000:]}")
    return [read_exr(Path(out))[2] for out in outs]


def compare(options, view, folder):
    world, camera = view.split(":")
    stem, glb = folder / f"{world}_{camera}", folder / f"{world}.glb"
    traced = Path(f"{stem}_trace.exr")
    path = options.source / "worlds" / world
    run([options.program, "world", path, "--export", glb])
    run([options.program, "trace", path, "--camera", camera, "-o", traced, "--size", options.size,
         "--samples", options.samples, "--jobs", options.threads])
    reference = read_exr(traced)[2]
    halves = [picture(reference, "first."), picture(reference, "second.")]
    scene, result, planes = glb_json(glb), {}, None
    for row in ("shared", "physical"):
        if planes is None or has_lamps(scene):
            planes = cycles(options, glb, camera, row, stem)
        pictures = [picture(one, "ViewLayer.Combined.") for one in planes]
        if row == "shared":
            shaded = phong(pictures[2], planes[2], scene, camera)
            pictures = [add((1, one), (-1, pictures[2]), (1, shaded)) for one in pictures[:2]]
        glow = picture(planes[0], "ViewLayer.Emit.")
        lamps = [[any(value > 0 for value in pixel) for pixel in line] for line in glow]
        result[row] = judged(pictures[:2], halves, options.tile, lamps)
    return result


HEAD = """| view | model | picture: red, green, blue, % | tiles within 2 % | median tile, % | worst tile, % | noise, % |
| --- | --- | --- | --- | --- | --- | --- |"""


def line_of(view, row, found):
    whole = ", ".join(f"{100 * (ratio - 1):+.2f}" for ratio in found["whole"])
    numbers = " | ".join(f"{100 * found[name]:.2f}" for name in ("median", "worst", "noise"))
    return f"| {view.replace(':', ', ')} | {row} | {whole} | {100 * found['within']:.0f} % | {numbers} |"


def disagreement(shared):
    """What is off in a row `shared`; None when nothing is."""
    whole = max(abs(ratio - 1) for ratio in shared["whole"])
    if whole <= BAR and shared["worst"] <= BAR + 3 * shared["noise"]:
        return None
    return f"the picture is {100 * whole:.2f} % off, a tile {100 * shared['worst']:.2f} %"


def main():
    options = arguments()
    reason = missing(options.blender)
    if reason:
        print(f"skipped: {reason}")
        return SKIPPED
    results = {}
    with tempfile.TemporaryDirectory() as temporary:
        folder = (options.keep or Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        print(HEAD)
        for view in options.view or VIEWS:
            results[view] = compare(options, view, folder)
            for row, found in results[view].items():
                print(line_of(view, row, found), flush=True)
        (folder / "tiles.json").write_text(json.dumps(results, indent=1))
    problems = [f"{view}: {problem}" for view, result in results.items() if (problem := disagreement(result["shared"]))]
    print("\n".join(problems))
    return 1 if options.check and problems else 0


if __name__ == "__main__":
    sys.exit(main())
