#!/usr/bin/env python3
"""Does `orris` cost more than another build of it, say of an earlier commit?

    tests/bench/paired_programs.py A/orris B/orris validate PACK...
    tests/bench/paired_programs.py A/orris B/orris render PACK WORLD [--frames 150]

Runs both in turns and counts processor time, with that of their workers: of `validate` all of it, with an empty cache of results;
of `render` the middle frame of a run after the first ten, on the software rasteriser without threads. Prints the medians of both and
that of B / A over the rounds with its 95 % interval by a bootstrap. A status other than 0 and 1 ends it."""

import argparse
import csv
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

from paired_packs import interval

WARM_FRAMES = 10


def processor_seconds(command, folder):
    env = dict(os.environ, ORRIS_CACHE=str(folder / "cache"), LP_NUM_THREADS="0")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(command)}: {done.returncode}\n{done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def validation(program, pack):
    with tempfile.TemporaryDirectory() as folder:
        return processor_seconds([program, "validate", pack], pathlib.Path(folder))


def frame(program, args):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        processor_seconds([program, "render", args.pack, args.world, "-o", str(folder / "a.png"), "--size", args.size,
                           "--frames", str(args.frames), "--timings", str(folder / "t.csv")], folder)
        frames = {}
        with open(folder / "t.csv", encoding="utf-8") as rows:
            for row in csv.DictReader(rows):
                number = int(row["frame"])
                frames[number] = frames.get(number, 0) + float(row["processor_milliseconds"])
    return statistics.median(time for number, time in frames.items() if number >= WARM_FRAMES)


def compare(name, unit, programs, rounds, measure):
    times = {program: [] for program in programs}
    for number in range(rounds):
        for program in programs[::1 if number % 2 else -1]:
            times[program].append(measure(program))
    one, other = (times[program] for program in programs)
    ratios = [b / a for a, b in zip(one, other)]
    low, high = interval(ratios)
    print(f"{name}: {statistics.median(one):.2f} and {statistics.median(other):.2f} {unit}, "
          f"B / A {statistics.median(ratios):.3f} [{low:.3f}, {high:.3f}]", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("one", help="A")
    parser.add_argument("other", help="B")
    commands = parser.add_subparsers(dest="command", required=True)
    validate = commands.add_parser("validate")
    validate.add_argument("packs", nargs="+")
    render = commands.add_parser("render")
    render.add_argument("pack")
    render.add_argument("world")
    render.add_argument("--size", default="160x90")
    render.add_argument("--frames", type=int, default=150)
    for command in (validate, render):
        command.add_argument("--rounds", type=int, default=5)
    args = parser.parse_args()
    programs = [args.one, args.other]
    if args.command == "render":
        compare(args.pack, "ms a frame", programs, args.rounds, lambda program: frame(program, args))
    for pack in args.packs if args.command == "validate" else []:
        compare(pack, "s", programs, args.rounds, lambda program, pack=pack: validation(program, pack))


if __name__ == "__main__":
    main()
