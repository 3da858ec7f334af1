#!/usr/bin/env python3
"""What a frame costs in a settled scene beside one in which a block comes or goes every frame.

Prints one line of JSON: medians in milliseconds of processor time and their ratio, of the programs that keep the volume (prepare*,
shadowcomp*), of all global illumination (with deferred* less the last), and of whole frames. Frames 260 to 279 of
WORLD are the settled ones; then, at AT, a lamp comes and goes."""

import argparse
import collections
import csv
import json
import pathlib
import statistics
import subprocess
import tempfile

SETTLED, CHANGING = range(260, 280), range(281, 320)
VOLUME = ("prepare", "shadowcomp")
PARTS = {"volume": lambda step: step.startswith(VOLUME),
         "gi": lambda step: step.startswith((*VOLUME, "deferred")) and step != "deferred6",
         "frame": lambda step: True}


def changing_world(path, at):
    world = json.loads((path / "world.json").read_text())
    world["events"] = [{"frame": frame, "set": {"at": at, "block": "sea_lantern" if frame % 2 else "air"}}
                       for frame in CHANGING]
    return json.dumps(world)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack")
    parser.add_argument("world", type=pathlib.Path)
    parser.add_argument("--at", type=int, nargs=3, default=[8, 5, 9])
    parser.add_argument("--size", default="160x90")
    # Means that are full before the settled frames.
    parser.add_argument("--set", nargs="+", default=["GI_METHOD=FACE_CACHE", "TEMPORAL_FRAMES=64"])
    args = parser.parse_args()
    frames = collections.defaultdict(lambda: collections.defaultdict(float))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "world.json").write_text(changing_world(args.world, args.at))
        subprocess.run([args.orris, "render", args.pack, folder, "-o", folder / "picture.png", "--size", args.size,
                        "--frames", str(CHANGING.stop), "--timings", folder / "times.csv", "--quiet", "--set",
                        *args.set], check=True)
        for row in csv.DictReader((folder / "times.csv").open()):
            frames[int(row["frame"])][row["step"]] += float(row["processor_milliseconds"])
    result = {}
    for part, belongs in PARTS.items():
        settled, changing = (statistics.median(sum(ms for step, ms in frames[frame].items() if belongs(step))
                                               for frame in which) for which in (SETTLED, CHANGING))
        result[part] = {"settled": round(settled, 2), "changing": round(changing, 2),
                        "ratio": round(settled / changing, 2)}
    print(json.dumps(result))


if __name__ == "__main__":
    main()
