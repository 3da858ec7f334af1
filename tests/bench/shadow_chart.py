#!/usr/bin/env python3
"""Charts what shadow maps cost beside how many pixels they get wrong, shadow volumes among them.

Maps of 256 to 4096 texels with each filter and bias, and shadow volumes by each method: processor time of a frame over
that without shadows (`orris chart`, interleaved); pixels on the wrong side of a mask by rays to the sun (`orris trace --shadow-mask`), on its
edges and inside; and the rms error of a picture of direct sunlight alone beside `orris trace --bounces 0`, over its mean. Writes shadows.csv
and shadows.png into the folder. A second run of the same command goes on where the first one ended. Needs matplotlib (python3-matplotlib)."""

import argparse
import csv
import json
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from chart_runs import SOURCE, frame_times  # noqa: E402

sys.path.insert(0, str(SOURCE / "tests" / "app"))
from exr_file import read_exr  # noqa: E402

TEXELS = [256, 512, 1024, 2048, 4096]
# Name -> settings; one line of the chart each.
KINDS = {
    "1 texel": ["SHADOW_METHOD=MAP"],
    "1 texel, hardware": ["SHADOW_METHOD=MAP", "SHADOW_COMPARE=HARDWARE"],
    "3 x 3": ["SHADOW_METHOD=MAP_PCF"],
    "3 x 3, hardware": ["SHADOW_METHOD=MAP_PCF", "SHADOW_COMPARE=HARDWARE"],
}
BIASES = {"normal offset": "SHADOW_BIAS=NORMAL_OFFSET", "published bias": "SHADOW_BIAS=PUBLISHED"}
SUN_ALONE = ["AMBIENT_MINIMUM=0.0", "SKY_STRENGTH=0.0"]
VOLUMES = {"volumes, z-pass": "VOLUME_ZPASS", "volumes, z-fail": "VOLUME_ZFAIL", "volumes, automatic": "VOLUME_AUTO"}


def render(args, picture, settings, more=()):
    subprocess.run([args.orris, "render", args.pack, args.world, "-o", picture, *args.view, "--frames", "2", "--quiet", *more,
                    "--set", "GI_METHOD=NONE", *settings], check=True)


def measure_errors(args, settings, mask):
    """Wrong pixels on edges and inside, and of how many."""
    picture = args.folder / "shown.png"
    render(args, picture, ["SHADOW_VIEW=true", *settings])
    done = subprocess.run([args.orris, "compare", picture, mask, "--mask", "--json"], check=True, text=True,
                          stdout=subprocess.PIPE)
    found = json.loads(done.stdout)
    return found["edge"], found["interior"], found["pixels"]


def values_of(path):
    """Red, green and blue of all pixels, one after the other."""
    picture = read_exr(path)[2]
    return [value for channel in "RGB" for row in picture[channel] for value in row]


def rms_error(values, reference):
    """Over the mean of the reference.

    >>> rms_error([1.0, 3.0], [2.0, 2.0])
    0.5
    """
    squares = sum((a - b) ** 2 for a, b in zip(values, reference, strict=True))
    return (squares / len(reference)) ** 0.5 / (sum(reference) / len(reference))


def measure_light(args, settings, reference):
    dump = args.folder / "lit.exr"
    render(args, args.folder / "lit.png", [*SUN_ALONE, *settings], ["--dump", f"colortex0={dump}"])
    return round(rms_error(values_of(dump), reference), 4)


def measure(args):
    """Rows of kind, bias, texels, ms, edge, interior, pixels, rms."""
    mask, traced = args.folder / "mask.png", args.folder / "traced.exr"
    subprocess.run([args.orris, "trace", args.world, "--shadow-mask", "-o", mask, *args.view, "--quiet"], check=True)
    subprocess.run([args.orris, "trace", args.world, "-o", traced, *args.view, "--bounces", "0", "--samples", "2", "--quiet",
                    "--set", "GI_METHOD=NONE", *SUN_ALONE], check=True)
    reference = values_of(traced)
    rows = []

    def add(kind, bias, texels, settings, milliseconds):
        rows.append([kind, bias, texels, round(milliseconds, 3), *measure_errors(args, settings, mask),
                     measure_light(args, settings, reference)])

    def chart(name, axes, settings, baseline):
        return frame_times(args.orris, args.pack, args.world, args.folder / name, axes, size=args.size, camera=args.camera,
                           rounds=args.rounds, settings=["GI_METHOD=NONE", *settings], baseline=baseline)

    # Without shadows in each run: costs are given over it.
    for bias, bias_setting in BIASES.items():
        for compare in ("TEXEL", "HARDWARE"):
            times = chart(f"{bias.split()[0]}-{compare}", ["SHADOW_METHOD=NONE,MAP,MAP_PCF", "SHADOW_RESOLUTION"],
                          [bias_setting, f"SHADOW_COMPARE={compare}"], "SHADOW_METHOD=NONE,SHADOW_RESOLUTION=256")
            none = sum(ms for label, ms in times.items() if "SHADOW_METHOD=NONE" in label) / len(TEXELS)
            for kind, settings in KINDS.items():
                for texels in TEXELS if ("hardware" in kind) == (compare == "HARDWARE") else []:
                    asked = {settings[0], f"SHADOW_RESOLUTION={texels}"}
                    own = next(ms for label, ms in times.items() if asked <= set(label.split()))
                    add(kind, bias, texels, [*settings, bias_setting, f"SHADOW_RESOLUTION={texels}"], own - none)
    times = chart("volumes", ["SHADOW_METHOD=NONE," + ",".join(VOLUMES.values())], [], "SHADOW_METHOD=NONE")
    for kind, method in VOLUMES.items():
        setting = f"SHADOW_METHOD={method}"
        add(kind, "", 0, [setting], times[setting] - times["SHADOW_METHOD=NONE"])
    return rows


def draw(rows, path, title):
    figure, panels = plt.subplots(1, 3, figsize=(13.2, 4.4), layout="constrained", sharey=True)
    for axes, column, name, least in ((panels[0], 4, "wrong pixels on edges (none: 0.5)", 0.5),
                                      (panels[1], 5, "wrong pixels inside (none: 0.5)", 0.5),
                                      (panels[2], 7, "rms error of direct sunlight over its mean", 0)):
        for style, bias in (("-", "normal offset"), (":", "published bias")):
            for index, kind in enumerate(KINDS):
                line = [row for row in rows if row[0] == kind and row[1] == bias]
                axes.plot([max(row[column], least) for row in line], [row[3] for row in line], style + "o", ms=4,
                          color=f"C{index}", label=f"{kind}, {bias}")
                for row in line if kind == "3 x 3" and style == "-" else []:
                    axes.annotate(str(row[2]), (max(row[column], least), row[3]), fontsize=7, xytext=(4, 3),
                                  textcoords="offset points")
        for marker, kind in zip("^v*", VOLUMES):
            for row in rows:
                if row[0] == kind:
                    axes.plot([max(row[column], least)], [row[3]], "k" + marker, ms=9, label=kind)
        axes.set(xscale="log", yscale="log", xlabel=name)
        axes.grid(True, which="both", alpha=0.2)
    panels[0].set_ylabel("ms of processor time over no shadows")
    panels[2].legend(fontsize=7)
    figure.suptitle(title, fontsize=10)
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--world", type=pathlib.Path, default=SOURCE / "worlds/pillars")
    parser.add_argument("--camera", default="above")
    parser.add_argument("--size", default="480x270")
    parser.add_argument("--rounds", type=int, default=4)
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    args.view = ["--camera", args.camera, "--size", args.size]
    rows = measure(args)
    with (args.folder / "shadows.csv").open("w", newline="") as file:
        csv.writer(file).writerows([["filter", "bias", "texels", "ms", "edge", "interior", "pixels", "rms"], *rows])
    draw(rows, args.folder / "shadows.png",
         f"{args.world.name}, {args.camera}, {args.size}: maps of 256 to 4096 texels, and shadow volumes")


if __name__ == "__main__":
    main()
