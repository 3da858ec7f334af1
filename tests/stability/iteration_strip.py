#!/usr/bin/env python3
"""The floodfill of a world after 1, 2, 4 ... steps as a strip of pictures: a horizontal slice of the grid through
the layer of the camera above, the brightest of all layers below it.

    tests/stability/iteration_strip.py build/release/orris shaderpack worlds/cornell docs/results/floodfill-steps.png

Every picture is a dump of the atlas of FLOODFILL_STORAGE=ATLAS_2D after so many frames with a step in each."""

import argparse
import pathlib
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

VOLUME, COLUMNS = 64, 16  # ATLAS_COLUMNS of include/derived/sizes.glsl


def layers(args, frames, folder):
    """Light by layer, z and x, after `frames` steps."""
    dump = folder / "atlas.png"
    subprocess.run([args.orris, "render", args.pack, args.world, "-o", folder / "picture.png", "--size", "16x9",
                    "--frames", str(frames), "--quiet", "--dump", f"colortex4={dump}", "--set", "GI_METHOD=FLOODFILL",
                    "FLOODFILL_STORAGE=ATLAS_2D", "FLOODFILL_INTERVAL=1", f"VOXEL_SIZE={VOLUME}"], check=True)
    # Rows of a picture run down, those of the atlas up.
    atlas = plt.imread(dump)[::-1, :, :3]
    rows = atlas.shape[0] // VOLUME
    tiles = atlas.reshape(rows, VOLUME, COLUMNS, VOLUME, 3).swapaxes(1, 2)
    return tiles.reshape(rows * COLUMNS, VOLUME, VOLUME, 3)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("orris")
    parser.add_argument("pack")
    parser.add_argument("world")
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--steps", type=int, nargs="+", default=[1, 2, 4, 8, 16, 32])
    args = parser.parse_args()
    figure, axes = plt.subplots(2, len(args.steps), figsize=(2.2 * len(args.steps), 4.8), squeeze=False)
    with tempfile.TemporaryDirectory() as name:
        for column, steps in enumerate(args.steps):
            light = layers(args, steps, pathlib.Path(name))
            if column == 0:
                last = layers(args, max(args.steps), pathlib.Path(name)).max(axis=3)
                low, high = (limit(np.argwhere(last > 0.02), axis=0) for limit in (np.min, np.max))
            light = light[:, low[1]:high[1] + 1, low[2]:high[2] + 1]
            shown = (light[VOLUME // 2], light[low[0]:high[0] + 1].max(axis=1))
            for axis, picture, origin in zip(axes[:, column], shown, ("upper", "lower")):
                axis.imshow(np.sqrt(picture), origin=origin, interpolation="nearest")
                axis.set_xticks([])
                axis.set_yticks([])
            axes[0, column].set_title(f"{steps} step{'s' if steps > 1 else ''}")
    axes[0, 0].set_ylabel("from above, the camera's layer")
    axes[1, 0].set_ylabel("from the side, brightest of all")
    figure.tight_layout()
    figure.savefig(args.picture, dpi=80)


if __name__ == "__main__":
    main()
