#!/usr/bin/env python3
"""How much of the sun the pack lets through glass, panes, leaves and water, beside the path tracer: a row a block and time.

A floor of white concrete with the block above it, seen from below the block. A share is the mean of the pictures over that of
the bare floor, direct sunlight alone: of several pictures, as one shows a few holes and a part of the next. What stands in PAGE between the comments `shares` and `end of shares` is written anew."""

import argparse
import datetime
import json
import pathlib
import subprocess
import sys
import tempfile

from study_page import commit_of, markdown_table, with_part

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "app"))
from exr_file import read_exr  # noqa: E402

BOUND = 0.02
TIMES = (1500, 2500, 4000, 6000, 9500)
METHODS = ("MAP_PCF", "VOLUME_AUTO")
SIZE = "256x144"
# Of the eye, in x: over one period of the longest pattern, that of panes when the sun is lowest.
PLACES = (16, 16.6, 17.2, 17.8)
ROOF = '{{"box": "{0}", "min": [0, 4, 0], "max": [31, 4, 31]}}'
WALLS = ('{{"box": "{0}", "min": [12, 1, 0], "max": [12, 14, 31]}}, '
         '{{"box": "{0}", "min": [20, 1, 0], "max": [20, 14, 31]}}')
ARMS = "[north=true,south=true]"
BARE = ""
SCENES = {
    "glass": ROOF.format("glass"),
    "panes": WALLS.format("glass_pane" + ARMS),
    "red stained glass": ROOF.format("red_stained_glass"),
    "lime stained panes": WALLS.format("lime_stained_glass_pane" + ARMS),
    "leaves": ROOF.format("oak_leaves"),
    "water": ROOF.format("water"),
    "pool": '{"box": "water", "min": [0, 1, 0], "max": [31, 3, 31]}',
}


def world(things, time, x):
    """
    >>> json.loads(world(SCENES["panes"], 4000, 17))["blocks"][1]["box"]
    'glass_pane[north=true,south=true]'
    >>> len(json.loads(world(BARE, 4000, 17))["blocks"])
    1
    """
    blocks = ", ".join(filter(None, ['{"box": "white_concrete", "min": [0, 0, 0], "max": [31, 0, 31]}', things]))
    camera = f'{{"name": "eye", "position": [{x}, 3.2, 16], "target": [{x + .01}, 0, 16], "fov": 100}}'
    return (f'{{"size": [32, 16, 32], "blocks": [{blocks}], "cameras": [{camera}], '
            f'"environment": {{"time": {time}}}}}')


def trace_flags():
    return ["--size", SIZE, "--bounces", "0", "--samples", "2", "--set", "GI_METHOD=NONE"]


def render_flags(method, direct):
    return ["--size", SIZE, "--frames", "1", "--set", "GI_METHOD=BOUNCE_1", f"SHADOW_METHOD={method}",
            f"DIRECT_LIGHT={direct}"]


def mean(path):
    """Of the picture, by channel."""
    picture = read_exr(path)[2]
    return [sum(map(sum, picture[channel])) / sum(map(len, picture[channel])) for channel in "RGB"]


def run(*command):
    subprocess.run(command, check=True, capture_output=True)


def traced(args, folder):
    run(args.orris, "trace", folder, "-o", folder / "r.exr", "--quiet", *trace_flags())
    return mean(folder / "r.exr")


def drawn(args, folder, method):
    """The frame less what it has without the sun."""
    parts = []
    for direct in ("PHONG", "NONE"):
        run(args.orris, "render", args.pack, folder, "-o", folder / "f.png", "--dump", f"colortex0={folder / 'f.exr'}",
            "--quiet", *render_flags(method, direct))
        parts.append(mean(folder / "f.exr"))
    return [lit - unlit for lit, unlit in zip(*parts)]


def measured(args, things, time):
    """Means of the pictures, of the path tracer and of each method."""
    sums = []
    for x in PLACES:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "world.json").write_text(world(things, time, x))
            sums.append([traced(args, folder)] + [drawn(args, folder, method) for method in METHODS])
    return [[sum(values) / len(PLACES) for values in zip(*means)] for means in zip(*sums)]


def shares(lit, bare):
    """
    >>> shares([[1.0, 2.0]], [[2.0, 2.0]])
    [[0.5, 1.0]]
    """
    return [[a / b for a, b in zip(*pair)] for pair in zip(lit, bare)]


def worst(row):
    """Largest difference from the path tracer.

    >>> round(worst([[.5, .5], [.51, .5], [.5, .47]]), 3)
    0.03
    """
    return max(abs(a - b) for other in row[1:] for a, b in zip(row[0], other))


def table(rows):
    heads = ["block", "time", "path tracer, R G B", *(f"`{method}`" for method in METHODS), "largest difference"]
    cells = [[name, time, *(" ".join(f"{value:.3f}" for value in values) for values in row), f"{worst(row):.3f}"]
             for name, time, row in rows]
    return markdown_table(heads, cells)


def summary(rows):
    """
    >>> summary([("glass", 6000, [[.5], [.51]]), ("water", 6000, [[.5], [.53]])])
    '1 of 2 rows within 0.02; the others: water at 6000 (0.030).'
    """
    missed = [f"{name} at {time} ({worst(row):.3f})" for name, time, row in rows if worst(row) > BOUND]
    return f"{len(rows) - len(missed)} of {len(rows)} rows within {BOUND}; the others: {', '.join(missed) or 'none'}."


def commands():
    return "\n".join(["    orris trace WORLD -o r.exr " + " ".join(trace_flags()),
                      "    orris render shaderpack WORLD -o f.png --dump colortex0=f.exr "
                      + " ".join(render_flags(METHODS[0], "PHONG"))])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--blocks", nargs="+", choices=SCENES, default=list(SCENES))
    parser.add_argument("--times", nargs="+", type=int, default=TIMES)
    args = parser.parse_args()
    rows = []
    for time in args.times:
        bare = measured(args, BARE, time)
        for name in args.blocks:
            rows.append((name, time, shares(measured(args, SCENES[name], time), bare)))
    rows.sort(key=lambda row: (list(SCENES).index(row[0]), row[1]))
    made = f"Commit {commit_of(args.pack)}, {datetime.date.today().isoformat()}."
    text = "\n\n".join([commands(), f"{summary(rows)} {made}", table(rows)])
    args.page.write_text(with_part(args.page.read_text(), "shares", text))
    print(summary(rows))


if __name__ == "__main__":
    main()
