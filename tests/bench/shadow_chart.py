#!/usr/bin/env python3
"""Charts what shadow maps cost beside how many pixels they get wrong, shadow volumes among them.

Maps of 256 to 4096 texels with each filter and bias, and shadow volumes by each method: processor time of a frame over
that without shadows (`orris chart`, interleaved), and pixels on the wrong side of a ray-cast mask (`orris trace
--shadow-mask`), on its edges and inside. Writes shadows.csv and shadows.png into the folder. A second run of the same command goes on where the first
one ended. Needs matplotlib (python3-matplotlib)."""

import argparse
import csv
import json
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from chart_runs import SOURCE, frame_times  # noqa: E402

TEXELS = [256, 512, 1024, 2048, 4096]
# Name -> settings; one line of the chart each.
KINDS = {
    "1 texel": ["SHADOW_METHOD=MAP"],
    "1 texel, hardware": ["SHADOW_METHOD=MAP", "SHADOW_COMPARE=HARDWARE"],
    "3 x 3": ["SHADOW_METHOD=MAP_PCF"],
    "3 x 3, hardware": ["SHADOW_METHOD=MAP_PCF", "SHADOW_COMPARE=HARDWARE"],
}
BIASES = {"normal offset": "SHADOW_BIAS=NORMAL_OFFSET", "published bias": "SHADOW_BIAS=PUBLISHED"}
VOLUMES = {"volumes, z-pass": "VOLUME_ZPASS", "volumes, z-fail": "VOLUME_ZFAIL", "volumes, automatic": "VOLUME_AUTO"}


def measure_errors(args, settings, mask):
    """Wrong pixels on edges and inside."""
    picture = args.folder / "shown.png"
    subprocess.run([args.orris, "render", args.pack, args.world, "-o", picture, *args.view, "--frames", "2", "--quiet",
                    "--set", "GI_METHOD=NONE", "SHADOW_VIEW=true", *settings], check=True)
    done = subprocess.run([args.orris, "compare", picture, mask, "--mask", "--json"], check=True, text=True,
                          stdout=subprocess.PIPE)
    found = json.loads(done.stdout)
    return found["edge"], found["interior"], found["pixels"]


def measure(args):
    """Rows of kind, bias, texels, ms, edge, interior, pixels."""
    mask = args.folder / "mask.png"
    subprocess.run([args.orris, "trace", args.world, "--shadow-mask", "-o", mask, *args.view, "--quiet"], check=True)
    rows = []

    def add(kind, bias, texels, settings, milliseconds):
        rows.append([kind, bias, texels, round(milliseconds, 3), *measure_errors(args, settings, mask)])

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
    figure, both = plt.subplots(1, 2, figsize=(9.6, 4.4), layout="constrained", sharey=True)
    for axes, column, name in ((both[0], 4, "wrong pixels on edges"), (both[1], 5, "wrong pixels inside")):
        for style, bias in (("-", "normal offset"), (":", "published bias")):
            for index, kind in enumerate(KINDS):
                line = [row for row in rows if row[0] == kind and row[1] == bias]
                axes.plot([max(row[column], 0.5) for row in line], [row[3] for row in line], style + "o", ms=4,
                          color=f"C{index}", label=f"{kind}, {bias}")
                for row in line if kind == "3 x 3" and style == "-" else []:
                    axes.annotate(str(row[2]), (max(row[column], 0.5), row[3]), fontsize=7, xytext=(4, 3),
                                  textcoords="offset points")
        for marker, kind in zip("^v*", VOLUMES):
            for row in rows:
                if row[0] == kind:
                    axes.plot([max(row[column], 0.5)], [row[3]], "k" + marker, ms=9, label=kind)
        axes.set(xscale="log", yscale="log", xlabel=f"{name} (none: 0.5)")
        axes.grid(True, which="both", alpha=0.2)
    both[0].set_ylabel("ms of processor time over no shadows")
    both[1].legend(fontsize=7)
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
        csv.writer(file).writerows([["filter", "bias", "texels", "ms", "edge", "interior", "pixels"], *rows])
    draw(rows, args.folder / "shadows.png",
         f"{args.world.name}, {args.camera}, {args.size}: maps of 256 to 4096 texels, and shadow volumes")


if __name__ == "__main__":
    main()
