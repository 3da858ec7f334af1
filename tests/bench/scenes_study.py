#!/usr/bin/env python3
"""What each method of global illumination costs and how wrong it is in the scenes of worlds/: a row a scene and method.

One run of `orris chart --scenes`, so that bias, noise, costs, lag and memory of a row are of one setting; one a scene of the
bias of the face cache alone, with references and runs as many as a scene needs, after 200 frames and where means are full; and one
of the face cache with many rays and no filter, as in random rooms (rooms_study.py). What stands in PAGE between the comments
`scenes` and `end of scenes`, `default` and `end of default`, `bias` and `end of bias` is written anew."""

import concurrent.futures
import csv
import datetime
import pathlib
import subprocess

import rooms_study
from study_page import CHANNELS, ENDS, as_typed, commit_of, interval, markdown_table, parser_of, rms_of, with_part

SCENES = ("glazed_house@ground", "deep_hall@back", "bend_grey@bend", "bend_white@bend", "lava_cave@lava", "glow_floor@room",
          "nether_room@lake", "street@street", "forest_floor@floor", "bay@shore", "snow_hut@inside", "chapel@nave",
          "h4_house@inside", "h4_house@outside")
OUTDOORS = ("street@street", "forest_floor@floor", "bay@shore", "h4_house@outside")
# Fewer frames than means take to be full: of a picture that rests eighths are drawn.
AS_TRACED = ["--set", "AMBIENT_MINIMUM=0.0", "DIRECT_LIGHT=NONE", "WATER_WAVES=false"]
COSTS = ["--size", "160x90", "--axis", "GI_METHOD=BOUNCE_1,FLOODFILL,FACE_CACHE", "--buffer", "colortex0", "--clock", "cpu",
         "--runs", "4", "--warm-up", "200", "--frames", "64", "--rounds", "8", "--visit", "4", "--trace-seconds", "40",
         "--trace-noise", "0.0001", *AS_TRACED]
DEFAULT = ["--size", "160x90", "--axis", "GI_METHOD=FACE_CACHE", "--buffer", "colortex0", "--no-costs", "--trace-noise", "0.0001"]
# After 200 frames, and where means of TEMPORAL_FRAMES frames are full.
WARM_UPS = (200, 2060)
# Of a reference: more where few paths find the light, less where all do.
TRACE_SECONDS = {"bend_white@bend": 600, "chapel@nave": 400, "lava_cave@lava": 200, "bay@shore": 100,
                 **dict.fromkeys(("street@street", "forest_floor@floor", "h4_house@inside", "h4_house@outside", "glow_floor@room"), 60)}
# More where the brightness of the whole picture wanders from run to run.
RUNS = {"deep_hall@back": 24, "bend_white@bend": 16}
BIAS = [*rooms_study.EFFORTS[0], *rooms_study.BIAS]


def table(rows):
    heads = ["scene", "method", *(f"rms bias, {channel}" for channel in CHANNELS), "signed mean", "noise of a frame", "cost",
             "editing", "moving", "lag, frames", "MB"]
    cells = [[f"`{row['scene']}`, `{row['camera']}`", f"`{method_of(row)}`", *(interval(rms_of(row, channel)) for channel in CHANNELS),
              f"{float(row['signed_luminance']):+.3f}", f"{float(row['noise_luminance']):.2f}",
              interval([float(row[name]) for name in ("ratio", "ratio_low", "ratio_high")], 2),
              f"{float(row['editing_ratio']):.2f}", f"{float(row['moving_ratio']):.2f}",
              row["lag"] if int(row["lag"]) >= 0 else "", f"{float(row['megabytes']):.1f}"] for row in rows]
    return markdown_table(heads, cells)


def method_of(row):
    """
    >>> method_of({"setting": "GI_METHOD=FACE_CACHE"})
    'FACE_CACHE'
    """
    return row["setting"].removeprefix("GI_METHOD=")


def within_goals(rows):
    """
    >>> row = lambda scene, camera, high: {"scene": scene, "camera": camera, "setting": "GI_METHOD=FACE_CACHE",
    ...     **{f"rms{end}_{channel}": high for channel in CHANNELS for end in ENDS}}
    >>> print(within_goals([row("a", "room", ".02"), row("b", "room", ".04"), row("bay", "shore", ".04")]))
    `FACE_CACHE`: upper end of every channel at most .03 (outdoors .05) in 2 of 3 scenes; beyond: `b`, `room`.
    """
    rows = [row for row in rows if method_of(row) == "FACE_CACHE"]

    def limit(row):
        return 0.05 if scene_of(row) in OUTDOORS else 0.03

    beyond = [row for row in rows if max(rms_of(row, channel)[2] for channel in CHANNELS) > limit(row)]
    names = "; ".join(f"`{row['scene']}`, `{row['camera']}`" for row in beyond) or "none"
    return (f"`FACE_CACHE`: upper end of every channel at most .03 (outdoors .05) in {len(rows) - len(beyond)} of {len(rows)} scenes; "
            f"beyond: {names}.")


def goals(rows):
    cached = [row for row in rows if method_of(row) == "FACE_CACHE"]
    return (f"{within_goals(rows)} Cost at most 1.10 in {sum(float(row['ratio']) <= 1.1 for row in cached)}, while a block changes in "
            f"every frame at most 1.25 in {sum(float(row['editing_ratio']) <= 1.25 for row in cached)}.")


def table_of_bias(rows):
    heads = ["scene", "time", *(f"rms bias, {channel}" for channel in CHANNELS), "signed mean, luminance", "noise of the reference"]
    cells = [[f"`{row['scene']}`, `{row['camera']}`", row["time"], *(interval(rms_of(row, channel)) for channel in CHANNELS),
              interval([float(row[f"signed{end}_luminance"]) for end in ENDS]), f"{float(row['reference_noise']):.4f}"]
             for row in rows]
    return markdown_table(heads, cells)


def measured(args, part, flags):
    """What the command prints, its rows, and the lines of the page that say how they were made."""
    folder = args.folder / part
    words = [word for scene in args.only.split(",") for word in ("--scenes", f"worlds/{scene}")] + ["-o"]
    budget = ["--budget", args.budget] if args.budget else []
    folder.mkdir(parents=True, exist_ok=True)
    summary = subprocess.run([args.orris, "chart", args.pack, *words, str(folder), *flags, *budget], check=True,
                             stdout=subprocess.PIPE, text=True).stdout
    typed = as_typed([args.orris, "chart", pathlib.Path(args.pack).name, *words, "scenes", *flags])
    date = f"Commit {commit_of(args.pack)}, {datetime.date.today().isoformat()}."
    with (folder / "scenes.csv").open() as file:
        return summary, list(csv.DictReader(file)), [typed, date]


def seconds_of(scene):
    return TRACE_SECONDS.get(scene, 300)


def default_flags(scene, warm_up, runs, frames):
    """
    >>> default_flags("bay@shore", 200, 4, 64)[-12:-4]
    ['--runs', '4', '--warm-up', '200', '--frames', '64', '--trace-seconds', '100']
    """
    return [*DEFAULT, "--runs", str(runs), "--warm-up", str(warm_up), "--frames", str(frames), "--trace-seconds",
            str(seconds_of(scene)), *AS_TRACED]


def default_row(args, scene, warm_up, runs, frames=64):
    """The row of the face cache; its reference stays in the folder of the scene."""
    folder = args.folder / "default" / scene.replace("@", "_")
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([args.orris, "chart", args.pack, "--scenes", f"worlds/{scene}", "-o", str(folder),
                    *default_flags(scene, warm_up, runs, frames)], check=True, stdout=subprocess.DEVNULL)
    with (folder / "scenes.csv").open() as file:
        return next(csv.DictReader(file))


def table_of_default(rows, commit):
    heads = ["scene", "runs", *(f"rms bias, {channel}" for channel in CHANNELS), "signed mean, luminance", "traced, s",
             "noise of the reference", "commit"]
    cells = [[f"`{row['scene']}`, `{row['camera']}`", row["runs"], *(interval(rms_of(row, channel)) for channel in CHANNELS),
              interval([float(row[f"signed{end}_luminance"]) for end in ENDS]), seconds_of(scene_of(row)),
              f"{float(row['reference_noise']):.4f}", commit] for row in rows]
    return markdown_table(heads, cells)


def scene_of(row):
    return f"{row['scene']}@{row['camera']}"


def measure_default(args):
    """References one after the other, since two at once are noisier; then runs, two scenes at a time."""
    scenes = args.only.split(",")
    for scene in scenes:
        default_row(args, scene, 2, 3, 2)
    blocks = []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for warm_up in WARM_UPS:
            rows = list(pool.map(lambda scene: default_row(args, scene, warm_up, RUNS.get(scene, 4)), scenes))
            blocks += [f"After {warm_up} frames: {within_goals(rows)}", table_of_default(rows, commit_of(args.pack))]
    typed = as_typed([args.orris, "chart", pathlib.Path(args.pack).name, "--scenes", "worlds/SCENE@CAMERA", "-o", "scenes", *DEFAULT,
                      "--runs", "RUNS", "--warm-up", "FRAMES", "--frames", "64", "--trace-seconds", "SECONDS", *AS_TRACED])
    write_part(args.page, "default", [typed, f"{datetime.date.today().isoformat()}.", *blocks])


def write_part(page, part, blocks):
    page.write_text(with_part(page.read_text(), part, "\n\n".join(blocks)))


def main():
    parser = parser_of(__doc__, "build/scenes")
    parser.add_argument("--only", default=",".join(SCENES), help="scenes, separated by commas")
    parser.add_argument("--parts", default="scenes,default,bias")
    parser.add_argument("--budget", help="begin no scene of a part after this time, 60m")
    args = parser.parse_args()
    if "scenes" in args.parts:
        summary, rows, lines = measured(args, "scenes", COSTS)
        block = "\n".join("    " + line for line in summary.splitlines() if not line.startswith("wrote"))
        write_part(args.page, "scenes", [*lines, goals(rows), block, table(rows)])
    if "default" in args.parts:
        measure_default(args)
    if "bias" in args.parts:
        _, rows, lines = measured(args, "bias", BIAS)
        write_part(args.page, "bias", [*lines, within_goals(rows), table_of_bias(rows)])


if __name__ == "__main__":
    main()
