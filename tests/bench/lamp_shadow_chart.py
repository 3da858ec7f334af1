#!/usr/bin/env python3
"""Charts what rays to the strongest lamps (LIGHT_SHADOWS) cost beside how wrong the direct light of all lamps stays.

Rooms with walls and several lamps, no other light, against a trace of the lamps' direct light (`orris trace --bounces 1`):
processor time of a frame by `orris chart`, interleaved, and the rms of (x - r) / (r + 0.02 mean r). Writes
lamp-shadows.csv and lamp-shadows.png into the folder. A second run of the same command goes on where the first one
ended. Needs matplotlib (python3-matplotlib)."""

import argparse
import csv
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from chart_runs import SOURCE, rows_of, run_chart  # noqa: E402

SCENES = [("rooms", "above"), ("rooms", "door"), ("lamps", "row"), ("lamps", "hall"), ("h6_hall", "hall")]
RAYS = [0, 1, 2, 4, 8]
LAMPS_ALONE = ["AMBIENT_MINIMUM=0.0", "SKY_STRENGTH=0.0", "DIRECT_LIGHT=NONE"]
COMMON = ["GI_METHOD=NONE", "SHADOW_METHOD=NONE", "LIGHT_METHOD=CLUSTERED", *LAMPS_ALONE]


def measure(args, world, camera):
    """Rows of scene, rays, ms, signed mean of the errors, rms."""
    scene = f"{world}-{camera}"
    picture = args.folder / f"{scene}.exr"
    subprocess.run([args.orris, "trace", SOURCE / "worlds" / world, "-o", picture, "--camera", camera, "--size", args.size,
                    "--bounces", "1", "--noise", "0.01", "--seconds", str(args.seconds), "--quiet", "--set", *LAMPS_ALONE],
                   check=True)
    run_chart(args.orris, args.pack, SOURCE / "worlds" / world, args.folder / scene,
              ["LIGHT_SHADOWS=" + ",".join(map(str, RAYS))], size=args.size, camera=camera, settings=COMMON,
              baseline="LIGHT_SHADOWS=0", reference=picture, rounds=args.rounds, more=["--buffer", "colortex0", "--metric", "bias"])
    for row in rows_of(args.folder / scene, "settings.csv"):
        yield [scene, int(row["setting"].split("=")[1]), float(row["ms"]), float(row["signed_bias"]), float(row["bias"])]


def draw(rows, path, size):
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for index, scene in enumerate(dict.fromkeys(row[0] for row in rows)):
        own = [row for row in rows if row[0] == scene]
        axes.plot([r[4] for r in own], [r[2] for r in own], "-o", ms=4, color=f"C{index}", label=scene)
        for row in own:
            axes.annotate(str(row[1]), (row[4], row[2]), fontsize=8, xytext=(4, 3), textcoords="offset points")
    axes.set(xlabel="error of the lamps' direct light, rms of relative errors", ylabel="ms of processor time a frame",
             title=f"rays to so many lamps, {size}", ylim=(0, None), xscale="log")
    axes.title.set_fontsize(10)
    axes.grid(True, alpha=0.2)
    axes.legend(fontsize=8)
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--seconds", type=int, default=30, help="for each trace")
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    rows = [row for world, camera in SCENES for row in measure(args, world, camera)]
    with (args.folder / "lamp-shadows.csv").open("w", newline="") as file:
        csv.writer(file).writerows([["scene", "rays", "ms", "signed_bias", "bias"], *rows])
    draw(rows, args.folder / "lamp-shadows.png", args.size)


if __name__ == "__main__":
    main()
