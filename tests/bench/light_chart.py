#!/usr/bin/env python3
"""Charts the methods for many lamps against the number of lamps, and the grid of clusters.

Processor time of passes. Lamps: `shade` is what the passes that light (deferred6, and what is drawn) take over the same
without lamps (`orris chart`, interleaved); `cull` what making the lists takes in each frame of a turning camera
(`orris render --timings`, shadowcomp3 to 6); `collect` what the shadow pass takes that finds the lamps. Lights a pixel and
entries are counted by LIGHT_DEBUG. Grid: the same for columns times slices, linear and logarithmic.

Writes lamps.csv, lamps.png, grid.csv and grid.png into the folder. A second run of the same command goes on where the
first one ended, as does one after --budget seconds; what is not measured yet is left out. Needs matplotlib
(python3-matplotlib)."""

import argparse
import csv
import json
import pathlib
import statistics
import struct
import subprocess
import time
import zlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from chart_runs import lamp_field, pass_times, run_chart  # noqa: E402

METHODS = ["CLUSTERED", "TILED", "DEFERRED", "FORWARD"]
LISTED = ["CLUSTERED", "TILED"]
LAMPS = [16, 64, 256, 1024, 4096, 16384]
COMMON = ["GI_METHOD=NONE", "SHADOW_METHOD=NONE", "DIRECT_LIGHT=NONE", "LIGHT_CAPACITY=16384", "LIGHT_LIST=2048"]
COLUMNS, SLICES, SLICING = [8, 16, 20, 32], [1, 8, 16, 24, 32], ["LINEAR", "LOGARITHMIC"]
LIGHTING = ("deferred6",)  # passes in which lamps shine, as their names begin
FORWARD_LIGHTING = ("gbuffers_terrain", "deferred6")
CULLING = ["shadowcomp3", "shadowcomp4", "shadowcomp5", "shadowcomp6"]
TURN = 12  # frames


class Clock:
    """Of a run that may end early."""

    def __init__(self, budget):
        self.end = time.monotonic() + budget if budget else None

    def left(self):
        """Seconds; 0 without a budget."""
        return max(self.end - time.monotonic(), 1) if self.end else 0

    def over(self):
        return self.end is not None and time.monotonic() >= self.end


def kept(args, name, make):
    """What `make` gave, from the file where it is there; None when there is no time left to make it."""
    path = args.folder / f"{name}.json"
    if not path.exists():
        if args.clock.over():
            return None
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


def culling(args, lamps, settings):
    """Milliseconds a frame of making the lists while the camera turns; the first frame makes the table, too."""
    path = args.folder / "cull.csv"
    subprocess.run([args.orris, "render", args.pack, lamp_field(lamps, args.folder, TURN), "-o", args.folder / "cull.png",
                    "--size", args.size, "--frames", str(TURN), "--quiet", "--timings", path, "--set", *COMMON, *settings],
                   check=True)
    frames = {}
    with path.open() as file:
        for row in csv.DictReader(file):
            if row["step"] in CULLING and int(row["frame"]) > 0:
                frames[row["frame"]] = frames.get(row["frame"], 0) + float(row["processor_milliseconds"])
    return statistics.median(frames.values())


def sum_of(passes, names):
    """Milliseconds of the passes whose names begin so."""
    return sum(ms for name, ms in passes.items() if name.startswith(names))


def shading(passes, dark, method):
    """Milliseconds that lamps add to the passes of a frame; `dark`: the passes without lamps."""
    names = FORWARD_LIGHTING if method == "FORWARD" else LIGHTING
    return sum_of(passes, names) - sum_of(dark, names)


def lamp_rows(args):
    """Rows of lamps, method, ms of shading, culling and collecting, lights a pixel, entries, longest list."""
    for lamps in LAMPS:
        world = lamp_field(lamps, args.folder)
        # Those that ask every lamp take seconds a frame: few turns, and no others that wait for them.
        few = lamps > 1024
        for methods, rounds in ((["CLUSTERED", "TILED"], args.rounds), (["DEFERRED"], 2 if few else args.rounds),
                                (["FORWARD"], 1 if few else 2)):
            folder = args.folder / f"chart{lamps}-{methods[0]}"
            if not args.clock.over():
                run_chart(args.orris, args.pack, world, folder, [f"LIGHT_METHOD=NONE,{','.join(methods)}"],
                          size=args.size, settings=COMMON, baseline="LIGHT_METHOD=NONE",
                          reference=f"LIGHT_METHOD={methods[0]}", rounds=rounds, visit=1 if few else 2,
                          seconds=args.clock.left())
            passes = pass_times(folder)
            for method in methods:
                found = passes.get(f"LIGHT_METHOD={method}")
                cull, counts = 0, {"lights": lamps, "entries": 0, "longest": 0}
                if method in LISTED:
                    cull = kept(args, f"cull{lamps}-{method}", lambda: culling(args, lamps, [f"LIGHT_METHOD={method}"]))
                    counts = kept(args, f"count{lamps}-{method}", lambda: count(args, world, [f"LIGHT_METHOD={method}"]))
                if found and cull is not None and counts:
                    yield [lamps, method, shading(found, passes["LIGHT_METHOD=NONE"], method), cull, sum_of(found, ("shadow_",)),
                           counts["lights"], counts["entries"], counts["longest"]]


def grid_rows(args):
    """Rows of slicing, columns, slices, ms of shading and culling, lights a pixel, entries."""
    world = lamp_field(args.grid_lamps, args.folder)
    folder = args.folder / "grid"
    axes = ["LIGHT_COLUMNS=" + ",".join(map(str, COLUMNS)), "LIGHT_SLICES=" + ",".join(map(str, SLICES)),
            "LIGHT_SLICING=" + ",".join(SLICING)]
    if not args.clock.over():
        run_chart(args.orris, args.pack, world, folder, axes, size=args.size,
                  settings=[*COMMON, "LIGHT_METHOD=CLUSTERED"],
                  baseline="LIGHT_COLUMNS=16,LIGHT_SLICES=24,LIGHT_SLICING=LOGARITHMIC", rounds=args.rounds, visit=1,
                  seconds=args.clock.left())
    times = pass_times(folder)
    for slicing in SLICING:
        for columns in COLUMNS:
            for slices in SLICES:
                settings = [f"LIGHT_COLUMNS={columns}", f"LIGHT_SLICES={slices}", f"LIGHT_SLICING={slicing}"]
                asked, name = ["LIGHT_METHOD=CLUSTERED", *settings], f"grid{columns}-{slices}-{slicing}"
                found = next((passes for label, passes in times.items() if set(settings) <= set(label.split())), None)
                counts = kept(args, "count-" + name, lambda: count(args, world, asked))
                cull = kept(args, "cull-" + name, lambda: culling(args, args.grid_lamps, asked))
                if found and counts and cull is not None:
                    yield [slicing, columns, slices, found["deferred6"], cull, counts["lights"], counts["entries"]]


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
        lights.plot([r[0] for r in own], [r[5] for r in own], "-o", ms=4, color=f"C{index}", label=method)
    for axes in (cost, lights):
        axes.set_xscale("log", base=2)
        axes.set(yscale="log", xlabel="lamps")
        axes.grid(True, which="both", alpha=0.2)
        axes.legend(fontsize=7)
    cost.set_ylabel("ms of processor time a frame")
    lights.set_ylabel("lights asked a pixel")
    figure.suptitle(f"lamp_field, {size}: shading, and making the lists anew", fontsize=10)
    figure.savefig(path, dpi=100)


def draw_grid(rows, path, lamps, size):
    figure, panels = plt.subplots(1, 3, figsize=(12.6, 4.2), layout="constrained")
    for style, slicing in (("-", "LOGARITHMIC"), (":", "LINEAR")):
        for index, columns in enumerate(COLUMNS):
            own = [row for row in rows if row[0] == slicing and row[1] == columns]
            look = {"ms": 4, "color": f"C{index}", "label": f"{columns} columns, {slicing.lower()}"}
            panels[0].plot([r[2] for r in own], [r[3] for r in own], style + "o", **look)
            panels[1].plot([r[2] for r in own], [r[3] + r[4] for r in own], style + "o", **look)
            panels[2].plot([r[6] / 1000 for r in own], [r[5] for r in own], style + "o", **look)
    panels[0].set(xlabel="slices", ylabel="ms of lighting, camera at rest")
    panels[1].set(xlabel="slices", ylabel="ms of lighting and lists, camera in motion")
    panels[2].set(xlabel="entries of all lists, thousands", ylabel="lights asked a pixel", xscale="log")
    for axes in panels:
        axes.grid(True, which="both", alpha=0.2)
    panels[2].legend(fontsize=7)
    figure.suptitle(f"{lamps} lamps, {size}: columns and slices", fontsize=10)
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", default=["lamps", "grid"], choices=["lamps", "grid"])
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--grid-lamps", type=int, default=4096)
    parser.add_argument("--budget", type=float, default=0, help="seconds after which nothing more is begun; 0: none")
    args = parser.parse_args()
    args.clock = Clock(args.budget)
    args.folder.mkdir(parents=True, exist_ok=True)
    if "lamps" in args.only:
        rows = list(lamp_rows(args))
        write(args.folder / "lamps.csv",
              ["lamps", "method", "shade_ms", "cull_ms", "collect_ms", "lights", "entries", "longest"], rows)
        draw_lamps(rows, args.folder / "lamps.png", args.size)
    if "grid" in args.only:
        rows = list(grid_rows(args))
        write(args.folder / "grid.csv", ["slicing", "columns", "slices", "shade_ms", "cull_ms", "lights", "entries"], rows)
        draw_grid(rows, args.folder / "grid.png", args.grid_lamps, args.size)
    if args.clock.over():
        print("the time is over: the same command goes on")


if __name__ == "__main__":
    main()
