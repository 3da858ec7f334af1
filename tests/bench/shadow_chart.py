#!/usr/bin/env python3
"""Charts what shadow maps cost beside how many pixels they get wrong, shadow volumes among them.

Maps of 256 to 4096 texels with each filter and bias: processor time of a frame over that without shadows (`orris
chart`, interleaved), and pixels on the wrong side of a ray-cast mask (`orris trace --shadow-mask`), on its edges and
inside. Writes shadows.csv and shadows.svg into the folder. A second run of the same command goes on where the first
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
VOLUMES = "volumes"


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

    for bias, bias_setting in BIASES.items():
        for compare in ("TEXEL", "HARDWARE"):
            # Without shadows in each run: it is what costs are told over.
            times = frame_times(args.orris, args.pack, args.world, args.folder / f"{bias.split()[0]}-{compare}",
                                ["SHADOW_METHOD=NONE,MAP,MAP_PCF,VOLUME_AUTO", "SHADOW_RESOLUTION"], size=args.size,
                                camera=args.camera, rounds=args.rounds,
                                settings=["GI_METHOD=NONE", bias_setting, f"SHADOW_COMPARE={compare}"],
                                baseline="SHADOW_METHOD=NONE,SHADOW_RESOLUTION=256",
                                reference="SHADOW_METHOD=VOLUME_AUTO,SHADOW_RESOLUTION=256")

            def over_none(method, texels):
                own = next(ms for label, ms in times.items()
                           if f"SHADOW_METHOD={method}" in label.split() and f"SHADOW_RESOLUTION={texels}" in label.split())
                none = sum(ms for label, ms in times.items() if "SHADOW_METHOD=NONE" in label) / len(TEXELS)
                return own - none

            for kind, settings in KINDS.items():
                if ("hardware" in kind) != (compare == "HARDWARE"):
                    continue
                method = settings[0].split("=")[1]
                for texels in TEXELS:
                    add(kind, bias, texels, [*settings, bias_setting, f"SHADOW_RESOLUTION={texels}"],
                        over_none(method, texels))
            if not any(row[0] == VOLUMES for row in rows):
                milliseconds = sum(over_none("VOLUME_AUTO", texels) for texels in TEXELS) / len(TEXELS)
                add(VOLUMES, "", 0, ["SHADOW_METHOD=VOLUME_AUTO"], milliseconds)
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
        for row in rows:
            if row[0] == VOLUMES:
                axes.plot([max(row[column], 0.5)], [row[3]], "k*", ms=13, label=VOLUMES)
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
    draw(rows, args.folder / "shadows.svg",
         f"{args.world.name}, {args.camera}, {args.size}: maps of 256 to 4096 texels, and shadow volumes")


if __name__ == "__main__":
    main()
