#!/usr/bin/env python3
"""What the open window costs over `orris render`: processor time of a frame of each, run at once.

view_bench.py ORRIS PACK WORLD [--size 640x360] [--rounds 3] [--frames 20] [--window]

Each round runs both commands with few and with many frames; their difference is the frames alone, without what
starting takes. No panel is open, nothing is probed or watched. With --window a real one on a virtual display (Xvfb), where
all processes of the command count; without, the same in an EGL context. Exit status 1: the window costs 3 % or more of a
frame in the median of the rounds.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

FEW = 4


def processor_seconds(commands, folder):
    """Of each command, all run at once: what else the machine does meets them alike."""
    processes = [subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL) for command in commands]
    seconds = []
    for process, command in zip(processes, commands):
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            sys.exit(f"{' '.join(command)}: exit status {process.returncode}")
        seconds.append(usage.ru_utime + usage.ru_stime)
    return seconds


def ending(name, frames, folder, window):
    """So many frames, then one picture."""
    if name == "render":
        return ["--backend", "egl", "--frames", str(frames), "-o", "render.png"]
    if window:
        return ["--frames", str(frames), "--screenshot", "view.png"]
    (folder / "steps.json").write_text(json.dumps([{"frames": frames}, {"picture": "view.png"}]))
    return ["--backend", "egl", "--script", "steps.json"]


def start_display():
    """A virtual display, to which the variable DISPLAY then points."""
    read_end, write_end = os.pipe()
    display = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1920x1200x24", "-nolisten", "tcp"],
                               pass_fds=[write_end], stderr=subprocess.DEVNULL)
    os.close(write_end)
    with os.fdopen(read_end) as answer:
        os.environ["DISPLAY"] = ":" + answer.readline().strip()
    return display


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("orris", type=pathlib.Path)
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("world", type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--frames", type=int, default=20, help="more than the few that starting is measured by")
    parser.add_argument("--window", action="store_true")
    arguments = parser.parse_args()
    display = start_display() if arguments.window else None
    pack, world = str(arguments.pack.resolve()), str(arguments.world.resolve())
    common = [pack, world, "--size", arguments.size, "--quiet"]
    times = {"render": [], "view": []}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(arguments.rounds):
            few, many = (processor_seconds([[str(arguments.orris.resolve()), name, *common,
                                             *ending(name, count, pathlib.Path(folder), arguments.window)] for name in times], folder)
                         for count in (FEW, FEW + arguments.frames))
            for values, first, last in zip(times.values(), few, many):
                values.append((last - first) / arguments.frames * 1e3)
    if display:
        display.terminate()
    for name, values in times.items():
        print(f"{name}: {statistics.median(values):.2f} ms of processor time a frame, {min(values):.2f} to {max(values):.2f}")
    differences = [view - render for view, render in zip(times["view"], times["render"])]
    share = statistics.median(differences) / statistics.median(times["render"])
    print(f"the window costs {share * 100:+.2f} % of a frame")
    return 0 if share < 0.03 else 1


if __name__ == "__main__":
    sys.exit(main())
