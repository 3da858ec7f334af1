#!/usr/bin/env python3
"""How wrong a pack is in random rooms, and what it costs beside one bounce: a row a room, in a page of docs/results.

Bias by `orris chart --scenes random:SEED:1`, cost by `orris chart random:SEED`, both at the pack's default settings but for
what BIAS and COST set. A room whose interval leaves open whether it is within the goal is measured anew with the next of
EFFORTS. Rows stay in FOLDER and keep commit and date; rooms that have one are not measured again, so that the command can be
interrupted. What stands in PAGE between the comments `rooms` and `end of rooms` is written anew."""

import csv
import datetime
import json
import pathlib
import shutil
import subprocess
import time

from study_page import CHANNELS, ENDS, as_typed, commit_of, interval, markdown_table, parser_of, rms_of, with_part

GOAL = 0.03
# What a frame costs at this size depends little on rays: 128 a pixel, and 8 to each face in each frame. The mean that values
# of faces approach does not depend on how many are updated in a frame and by how many rays, as an update is linear in them.
BIAS = ["--size", "16x9", "--warm-up", "160", "--trace-noise", "0.0001", "--no-costs", "--buffer", "colortex0", "--axis",
        "GI_METHOD=FACE_CACHE", "--set", "AMBIENT_MINIMUM=0.0", "DIRECT_LIGHT=NONE", "GI_FILTER=false",
        "GI_SAMPLES=128", "FACE_SHARE=1", "FACE_RAYS=8", "WATER_WAVES=false"]
# Noise of the reference is that of bright pixels, and dark ones count by their own light: so tracing takes its whole time.
# Five runs rather than four: Student's factor falls from 3.2 to 2.8.
EFFORTS = [["--runs", "5", "--frames", "128", "--trace-seconds", "60"],
           ["--runs", "8", "--frames", "256", "--trace-seconds", "120"],
           ["--runs", "12", "--frames", "640", "--trace-seconds", "240"],
           ["--runs", "30", "--frames", "640", "--trace-seconds", "900"]]
COST = ["--size", "160x90", "--axis", "GI_METHOD=BOUNCE_1,FACE_CACHE", "--clock", "cpu", "--reference",
        "GI_METHOD=FACE_CACHE", "--reference-frames", "2", "--warm-up", "60", "--frames", "2", "--rounds", "12", "--visit", "3"]


def upper_end(row):
    """Of the worst channel.

    >>> upper_end({"red": [0, 0, .02], "green": [0, 0, .04], "blue": [0, 0, .01]})
    0.04
    """
    return max(row[channel][2] for channel in CHANNELS)


def estimate(row):
    return max(row[channel][0] for channel in CHANNELS)


def is_decided(row):
    """Is the room within the goal, or beyond it, by a whole interval?

    >>> is_decided({"red": [.02, .01, .025], "green": [0, 0, .02], "blue": [0, 0, .01]})
    True
    >>> is_decided({"red": [.02, .01, .04], "green": [0, 0, .02], "blue": [0, 0, .01]})
    False
    >>> is_decided({"red": [.05, .04, .06], "green": [0, 0, .04], "blue": [0, 0, .01]})
    True
    """
    return upper_end(row) <= GOAL or any(row[channel][1] > GOAL for channel in CHANNELS)


def seeds(rows):
    return ", ".join(str(row["seed"]) for row in rows) or "none"


def summary(rows):
    """
    >>> row = lambda seed, value, high: {"seed": seed, **{channel: [value, 0, high] for channel in CHANNELS}}
    >>> print(summary([row(1, .01, .02), row(3, .02, .04), row(5, .06, .08)]))
    1 of 3 rooms have the upper end of every channel at most .03: 1. Estimates at most .03, intervals too wide: 3. Estimates above .03: 5.
    """
    meet = [row for row in rows if upper_end(row) <= GOAL]
    wide = [row for row in rows if row not in meet and estimate(row) <= GOAL]
    miss = [row for row in rows if row not in meet and row not in wide]
    return (f"{len(meet)} of {len(rows)} rooms have the upper end of every channel at most .03: {seeds(meet)}. "
            f"Estimates at most .03, intervals too wide: {seeds(wide)}. Estimates above .03: {seeds(miss)}.")


def table(rows):
    heads = ["seed", "time", "rms bias, red", "green", "blue", "signed mean, luminance", "noise of the reference", "effort",
             "cost over `BOUNCE_1`", "commit", "date"]
    cells = [[row["seed"], row["time"], *(interval(row[channel]) for channel in CHANNELS), interval(row["signed"]),
              f"{row['reference']:.4f}", row["effort"], interval(row["cost"], 2) if row["cost"] else "", row["commit"], row["date"]]
             for row in rows]
    return markdown_table(heads, cells)


def command(orris, pack, scene, flags):
    return as_typed([orris, "chart", pathlib.Path(pack).name, *scene.split(), "-o", "rooms", *flags])


def keep_samples(before, folder):
    """Tracing goes on where that of the folder `before` ended: more samples of the same picture are as good as others."""
    (folder / "settings").mkdir(parents=True, exist_ok=True)
    for checkpoint in (before / "settings").glob("*.trace"):
        if not (folder / "settings" / checkpoint.name).exists():
            shutil.copy(checkpoint, folder / "settings")


def bias_of(args, seed, effort):
    folder = args.folder / f"{seed}-bias-{effort}"
    keep_samples(args.folder / f"{seed}-bias-{effort - 1}", folder)
    subprocess.run([args.orris, "chart", args.pack, "--scenes", f"random:{seed}:1", "-o", folder, "--quiet", *EFFORTS[effort - 1],
                    *BIAS], check=True)
    with (folder / "scenes.csv").open() as file:
        measured = next(csv.DictReader(file))
    row = {channel: rms_of(measured, channel) for channel in CHANNELS}
    row["signed"] = [float(measured[f"signed{end}_luminance"]) for end in ENDS]
    return row | {"time": int(measured["time"]), "reference": float(measured["reference_noise"])}


def cost_of(args, seed, folder):
    text = subprocess.run([args.orris, "chart", args.pack, f"random:{seed}", "-o", folder, "--json", *COST], check=True,
                          capture_output=True, text=True).stdout
    point = next(point for point in json.loads(text)["points"] if "FACE_CACHE" in point["setting"])
    return [point["ratio"], *point["ratioInterval"]]


def measure(args, seed, in_time):
    """The row of a room: what is kept of it, and where there is time and need, measured further."""
    kept = args.folder / f"{seed}.json"
    row = json.loads(kept.read_text()) if kept.exists() else {"seed": seed, "effort": 0, "cost": None}
    while in_time() and row["effort"] < args.efforts and not (row["effort"] and is_decided(row)):
        row["effort"] += 1
        row |= bias_of(args, seed, row["effort"])
        row |= {"commit": commit_of(args.pack), "date": datetime.date.today().isoformat()}
        kept.write_text(json.dumps(row))
    if args.costs and not row["cost"]:
        row["cost"] = cost_of(args, seed, args.folder / f"{seed}-cost")
        kept.write_text(json.dumps(row))
    return row


def main():
    parser = parser_of(__doc__, "build/rooms")
    parser.add_argument("--first", type=int, default=1, help="seed; odd ones are held out")
    parser.add_argument("--rooms", type=int, default=50)
    parser.add_argument("--efforts", type=int, default=len(EFFORTS), choices=range(1, len(EFFORTS) + 1))
    parser.add_argument("--costs", action="store_true", help="measure costs, too")
    parser.add_argument("--minutes", type=float, default=1e9, help="begin no measurement after so long")
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    begun, rows = time.monotonic(), []

    def in_time():
        return time.monotonic() - begun < 60 * args.minutes

    for seed in range(args.first, args.first + 2 * args.rooms, 2):
        if (args.folder / f"{seed}.json").exists() or in_time():
            rows.append(measure(args, seed, in_time))
            text = "\n\n".join([*(command(args.orris, args.pack, "--scenes random:SEED:1", [*effort, *BIAS]) for effort in EFFORTS),
                                command(args.orris, args.pack, "random:SEED", COST), summary(rows), table(rows)])
            args.page.write_text(with_part(args.page.read_text(), "rooms", text))


if __name__ == "__main__":
    main()
