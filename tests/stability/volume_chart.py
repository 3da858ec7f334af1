#!/usr/bin/env python3
"""Charts what shadow volumes cost and how often they are wrong: z-pass, z-fail and automatic choice
over casters, pixels and places of the eye. Writes a table (.csv) and a picture beside it.

Costs are interleaved rounds of orris chart, processor time; wrong pixels are those of orris compare
--mask against orris trace --shadow-mask. Needs matplotlib (python3-matplotlib)."""

import argparse
import csv
import json
import pathlib
import re
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

METHODS = ["VOLUME_ZPASS", "VOLUME_ZFAIL", "VOLUME_AUTO"]
NAMES = {"VOLUME_ZPASS": "z-pass", "VOLUME_ZFAIL": "z-fail", "VOLUME_AUTO": "automatic"}
TIME = 3000
HALL = [{"box": "stone", "min": [0, 0, 0], "max": [31, 1, 31]},
        {"box": "stone", "min": [4, 9, 4], "max": [27, 9, 27]},
        {"box": "stone", "min": [15, 2, 15], "max": [16, 8, 16]},
        {"box": "stone", "min": [6, 2, 20], "max": [8, 5, 22]}]


def hills(width):
    """Generated ground with trees, seen from above one side; casters grow with its area."""
    return {"size": [width, 16, width],
            "blocks": [{"generate": {"terrain": {"seed": 3, "seaLevel": 1, "relief": 9,
                                                 "trees": 0.4}}}],
            "environment": {"time": TIME},
            "cameras": [{"name": "eye", "position": [width / 2, 22, width + 6], "yaw": 180,
                         "pitch": 24}]}


def hall(position, yaw, pitch):
    """A roof on a post: outside, at the rim of its shadow, within."""
    return {"size": [32, 16, 32], "blocks": HALL, "environment": {"time": TIME},
            "cameras": [{"name": "eye", "position": position, "yaw": yaw, "pitch": pitch}]}


CASES = [("blocks along a side", str(n), hills(n), "160x90") for n in (16, 32, 64, 96)] + [
    ("picture, 64 blocks", size, hills(64), size) for size in ("80x45", "160x90", "320x180", "640x360")
] + [("eye", "above", hall([16, 14, 34], 180, 30), "160x90"),
     ("eye", "beside", hall([30.3, 4.2, 30.4], 140, 5), "160x90"),
     ("eye", "in shadow", hall([12.3, 4.2, 12.4], 330, 10), "160x90"),
     ("eye", "under the roof", hall([20.3, 7.8, 18.4], 150, 50), "160x90")]


def run(*words, may_fail=False):
    done = subprocess.run([str(word) for word in words], check=False, text=True,
                          capture_output=True)
    if done.returncode != 0 and not may_fail:
        raise SystemExit(f"{' '.join(done.args)}\n{done.stderr}")
    return done


def costs(args, world, size, folder):
    """{method: (milliseconds a frame, multiple of z-pass, its 95 % interval)}"""
    run(args.orris, "chart", args.pack, world, "-o", folder, "--size", size, "--set",
        "GI_METHOD=NONE", "--axis", "SHADOW_METHOD=" + ",".join(METHODS), "--baseline",
        "SHADOW_METHOD=VOLUME_ZPASS", "--reference", "SHADOW_METHOD=VOLUME_ZFAIL",
        "--reference-frames", 2, "--warm-up", 2, "--frames", 2, "--rounds", args.rounds,
        "--visit", 3, "--clock", "cpu", "--quiet")
    with open(folder / "settings.csv", newline="") as file:
        return {re.search(r"VOLUME_[A-Z]+", row["setting"]).group():
                [row["ms"], row["ratio"] or "1", row["ratio_low"], row["ratio_high"]]
                for row in csv.DictReader(file) if "VOLUME_" in row["setting"]}


def wrong(args, world, size, folder):
    """{method: (pixels wrong on edges, inside, of how many)}"""
    mask = folder / "mask.png"
    run(args.orris, "trace", world, "--size", size, "--shadow-mask", "-o", mask)
    found = {}
    for method in METHODS:
        picture = folder / (method + ".png")
        run(args.orris, "render", args.pack, world, "--size", size, "--frames", 1, "-o", picture,
            "--set", "GI_METHOD=NONE", "SHADOW_METHOD=" + method, "SHADOW_VIEW=true")
        counts = json.loads(run(args.orris, "compare", "--mask", picture, mask, "--json",
                              may_fail=True).stdout)
        found[method] = [counts["edge"], counts["interior"], counts["pixels"]]
    return found


def measure(args, folder):
    rows = []
    for axis, place, world, size in CASES:
        if size in args.without:
            continue
        path = folder / "world"
        path.mkdir(exist_ok=True)
        (path / "world.json").write_text(json.dumps(world))
        case = folder / f"case{len(rows)}"
        case.mkdir()
        cost, errors = costs(args, path, size, case / "chart"), wrong(args, path, size, case)
        rows += [[axis, place, NAMES[m], *cost[m], *errors[m]] for m in METHODS]
        print(*rows[-3:], sep="\n", flush=True)
    return rows


def draw(rows, path):
    axes_names = list(dict.fromkeys(row[0] for row in rows))
    figure, plots = plt.subplots(2, len(axes_names), figsize=(9.6, 5.2), layout="constrained",
                                 sharey="row", squeeze=False)
    for column, name in enumerate(axes_names):
        places = list(dict.fromkeys(row[1] for row in rows if row[0] == name))
        for method, mark in zip(NAMES.values(), "os^"):
            mine = [row for row in rows if row[0] == name and row[2] == method]
            plots[0][column].plot(places, [float(row[4]) for row in mine], mark + "-", label=method)
            plots[1][column].plot(places, [100 * (row[7] + row[8]) / row[9] for row in mine],
                                  mark + "-")
        plots[0][column].grid(alpha=0.3)
        plots[0][column].tick_params(axis="x", labelbottom=False)
        plots[1][column].grid(alpha=0.3)
        plots[1][column].set_yscale("symlog", linthresh=0.1)
        plots[1][column].set_xlabel(name)
        plots[1][column].tick_params(axis="x", labelrotation=20)
    plots[0][0].set_ylabel("cost of a frame / z-pass")
    plots[1][0].set_ylabel("wrong pixels, %")
    plots[0][0].legend()
    figure.savefig(path, dpi=80)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack")
    parser.add_argument("out", help="picture, .png or .svg; the table gets the same name")
    parser.add_argument("--rounds", type=int, default=8)
    parser.add_argument("--without", nargs="*", default=[], help="sizes of pictures to leave out")
    args = parser.parse_args()
    out = pathlib.Path(args.out)
    with tempfile.TemporaryDirectory() as folder:
        rows = measure(args, pathlib.Path(folder))
    with open(out.with_suffix(".csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["axis", "place", "method", "ms", "cost", "cost_low", "cost_high",
                        "edge", "interior", "pixels"])
        table.writerows(rows)
    draw(rows, out)


if __name__ == "__main__":
    main()
