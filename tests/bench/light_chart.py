#!/usr/bin/env python3
"""Charts the methods for many lamps against the number of lamps, and the grid of clusters.

Lamps: processor time of a frame over that without lamps (`orris chart`, interleaved) is what shading costs, as nothing
is made anew while the camera stands still; what it takes longer while the camera turns is culling (runs of `orris
render`, processor time); lights a pixel are counted by LIGHT_DEBUG. Grid: tiles times slices, linear and logarithmic,
shading, lights a pixel and entries of all lists.

Writes lamps.csv, lamps.svg, grid.csv and grid.svg into the folder. A second run of the same command goes on where the
first one ended. Needs matplotlib (python3-matplotlib)."""

import argparse
import csv
import json
import pathlib
import resource
import struct
import subprocess
import zlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from chart_runs import frame_times, lamp_field  # noqa: E402

METHODS = ["CLUSTERED", "TILED", "DEFERRED", "FORWARD"]
LAMPS = [16, 64, 256, 1024, 4096, 16384]
COMMON = ["GI_METHOD=NONE", "SHADOW_METHOD=NONE", "DIRECT_LIGHT=NONE", "LIGHT_CAPACITY=16384", "LIGHT_LIST=2048"]
COLUMNS, SLICES, SLICING = [8, 16, 20, 32], [8, 16, 24, 32], ["LINEAR", "LOGARITHMIC"]
TURN = 24  # frames


def kept(path, make):
    """What `make` gave, from the file where it is there."""
    if not path.exists():
        path.write_text(json.dumps(make()))
    return json.loads(path.read_text())


def mean_of(path):
    """Mean of the first channel of a TIFF of floats, as `--dump` writes it: little endian, deflated strips, the bytes of
    a row by weight and as differences (predictor 3)."""
    data = path.read_bytes()
    start = struct.unpack_from("<I", data, 4)[0]
    tags = {}
    for i in range(struct.unpack_from("<H", data, start)[0]):
        tag, kind, length, value = struct.unpack_from("<HHII", data, start + 2 + 12 * i)
        long = kind == 4
        inline = length * (4 if long else 2) <= 4
        tags[tag] = (struct.unpack_from(f"<{length}{'I' if long else 'H'}", data, start + 10 + 12 * i if inline else value)
                     if kind in (3, 4) else ())
    width, channels = tags[256][0], tags[277][0]
    assert tags[259] == (8,) and tags[317] == (3,)
    total, samples = 0.0, width * channels
    for place, length in zip(tags[273], tags[279]):
        strip = zlib.decompress(data[place:place + length])
        for row in range(0, len(strip), 4 * samples):
            values = bytearray(strip[row:row + 4 * samples])
            for i in range(channels, len(values)):
                values[i] = (values[i] + values[i - channels]) & 255
            for i in range(0, samples, channels):
                total += struct.unpack(">f", bytes(values[i + weight * samples] for weight in range(4)))[0]
    return total / (width * tags[257][0])


def count(args, world, settings):
    """Lights a pixel of the whole picture, entries of all lists, the longest one."""
    dump = args.folder / "count.tif"
    done = subprocess.run([args.orris, "render", args.pack, world, "-o", args.folder / "count.png", "--size", args.size,
                           "--frames", "1", "--dump", f"colortex0={dump}", "--json", "--set", *COMMON, *settings,
                           "LIGHT_DEBUG=COUNT"], check=True, text=True, stdout=subprocess.PIPE)
    state = json.loads(done.stdout)["counters"]["light_state"]
    return {"lights": 1000 * mean_of(dump), "entries": state[5], "longest": state[4]}


def processor_seconds(args, world, method, frames):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([args.orris, "render", args.pack, world, "-o", args.folder / "cull.png", "--size", args.size,
                    "--frames", str(frames), "--quiet", "--set", *COMMON, f"LIGHT_METHOD={method}"], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def culling(args, lamps, method):
    """Milliseconds a frame of making the lists: turning less standing still, the least of the rounds."""
    worlds = [lamp_field(lamps, args.folder, turn) for turn in (TURN, 0)]
    rounds = [[processor_seconds(args, world, method, TURN) for world in worlds] for _ in range(args.cull_rounds)]
    return 1e3 * (min(r[0] for r in rounds) - min(r[1] for r in rounds)) / TURN


def lamp_rows(args):
    """Rows of lamps, method, ms of shading, ms of culling, lights a pixel, entries, longest list."""
    for lamps in LAMPS:
        world = lamp_field(lamps, args.folder)
        methods = [m for m in METHODS if lamps <= args.most_asked or m in ("CLUSTERED", "TILED")]
        times = frame_times(args.orris, args.pack, world, args.folder / f"chart{lamps}",
                            [f"LIGHT_METHOD=NONE,{','.join(methods)}"], size=args.size, settings=COMMON,
                            baseline="LIGHT_METHOD=NONE", reference="LIGHT_METHOD=CLUSTERED",
                            rounds=args.rounds if lamps <= 1024 else 2)
        # Any method collects the lamps in a shadow pass; what is left over a picture without is light.
        for method in methods:
            listed = method in ("CLUSTERED", "TILED")
            counts = (kept(args.folder / f"count{lamps}-{method}.json",
                           lambda: count(args, world, [f"LIGHT_METHOD={method}"])) if listed
                      else {"lights": lamps, "entries": 0, "longest": 0})
            cull = kept(args.folder / f"cull{lamps}-{method}.json", lambda: culling(args, lamps, method)) if listed else 0
            yield [lamps, method, times[f"LIGHT_METHOD={method}"] - times["LIGHT_METHOD=NONE"], cull,
                   counts["lights"], counts["entries"], counts["longest"]]


def grid_rows(args):
    """Rows of slicing, columns, slices, ms of shading, lights a pixel, entries."""
    world = lamp_field(args.grid_lamps, args.folder)
    for slicing in SLICING:
        times = frame_times(args.orris, args.pack, world, args.folder / f"grid-{slicing}",
                            ["LIGHT_COLUMNS", "LIGHT_SLICES=" + ",".join(map(str, SLICES))], size=args.size,
                            settings=[*COMMON, "LIGHT_METHOD=CLUSTERED", f"LIGHT_SLICING={slicing}"],
                            baseline="LIGHT_COLUMNS=16,LIGHT_SLICES=24", rounds=args.rounds)
        for columns in COLUMNS:
            for slices in SLICES:
                settings = [f"LIGHT_COLUMNS={columns}", f"LIGHT_SLICES={slices}"]
                counts = kept(args.folder / f"grid{columns}-{slices}-{slicing}.json",
                              lambda: count(args, world, ["LIGHT_METHOD=CLUSTERED", f"LIGHT_SLICING={slicing}", *settings]))
                milliseconds = next(ms for label, ms in times.items() if set(settings) <= set(label.split()))
                yield [slicing, columns, slices, milliseconds, counts["lights"], counts["entries"]]


def write(path, head, rows):
    with path.open("w", newline="") as file:
        csv.writer(file).writerows([head, *[[round(c, 4) if isinstance(c, float) else c for c in row] for row in rows]])


def draw_lamps(rows, path, size):
    figure, (cost, lights) = plt.subplots(1, 2, figsize=(9.6, 4.2), layout="constrained")
    for index, method in enumerate(METHODS):
        own = [row for row in rows if row[1] == method]
        cost.plot([r[0] for r in own], [max(r[2], 0.01) for r in own], "-o", ms=4, color=f"C{index}", label=f"{method}, shade")
        if any(r[3] for r in own):
            cost.plot([r[0] for r in own], [max(r[3], 0.01) for r in own], ":s", ms=3, color=f"C{index}",
                      label=f"{method}, cull")
        lights.plot([r[0] for r in own], [r[4] for r in own], "-o", ms=4, color=f"C{index}", label=method)
    for axes in (cost, lights):
        axes.set(xscale="log", yscale="log", xlabel="lamps")
        axes.set_xscale("log", base=2)
        axes.grid(True, which="both", alpha=0.2)
        axes.legend(fontsize=7)
    cost.set_ylabel("ms of processor time over no lamps")
    lights.set_ylabel("lights asked a pixel")
    figure.suptitle(f"lamp_field, {size}", fontsize=10)
    figure.savefig(path, dpi=100)


def draw_grid(rows, path, lamps, size):
    figure, (cost, lights) = plt.subplots(1, 2, figsize=(9.6, 4.2), layout="constrained")
    for style, slicing in (("-", "LOGARITHMIC"), (":", "LINEAR")):
        for index, columns in enumerate(COLUMNS):
            own = [row for row in rows if row[0] == slicing and row[1] == columns]
            label = f"{columns} columns, {slicing.lower()}"
            cost.plot([r[2] for r in own], [r[3] for r in own], style + "o", ms=4, color=f"C{index}", label=label)
            lights.plot([r[5] / 1000 for r in own], [r[4] for r in own], style + "o", ms=4, color=f"C{index}", label=label)
    cost.set(xlabel="slices", ylabel="ms of a frame, camera at rest")
    lights.set(xlabel="entries of all lists, thousands", ylabel="lights asked a pixel", xscale="log")
    for axes in (cost, lights):
        axes.grid(True, which="both", alpha=0.2)
    lights.legend(fontsize=7)
    figure.suptitle(f"{lamps} lamps, {size}: tiles and slices", fontsize=10)
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", default=["lamps", "grid"], choices=["lamps", "grid"])
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--rounds", type=int, default=4)
    parser.add_argument("--cull-rounds", type=int, default=3)
    parser.add_argument("--most-asked", type=int, default=16384, help="lamps beyond which no method asks all of them")
    parser.add_argument("--grid-lamps", type=int, default=4096)
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    if "lamps" in args.only:
        rows = list(lamp_rows(args))
        write(args.folder / "lamps.csv", ["lamps", "method", "shade_ms", "cull_ms", "lights", "entries", "longest"], rows)
        draw_lamps(rows, args.folder / "lamps.svg", args.size)
    if "grid" in args.only:
        rows = list(grid_rows(args))
        write(args.folder / "grid.csv", ["slicing", "columns", "slices", "ms", "lights", "entries"], rows)
        draw_grid(rows, args.folder / "grid.svg", args.grid_lamps, args.size)


if __name__ == "__main__":
    main()
