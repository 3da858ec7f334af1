#!/usr/bin/env python3
"""contexts.py PROGRAM PACK...: the pictures of packs in a core and in a compatibility context.

For each pack a row of a Markdown table: how many pixels agree within 1/255, the worst channel, the
programs that the driver leaves out, and the wall time of each run. Exit status 1 when a picture agrees on less than
99.9 % of its pixels."""
import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def render(options, pack, profile, picture):
    began = time.monotonic()
    done = subprocess.run([options.program, "render", pack, options.world, "-o", picture, "--size",
                           options.size, "--frames", str(options.frames), "--context", profile,
                           "--allow-missing", "--json"], capture_output=True, text=True)
    seconds = time.monotonic() - began
    if done.returncode != 0:
        print(done.stdout[-2000:], done.stderr[-2000:], file=sys.stderr)
        return None, seconds
    return json.loads(done.stdout), seconds


def compare(options, a, b):
    # 1.1/255: a difference of exactly 1/255 must not be counted because of rounding.
    done = subprocess.run([options.program, "compare", a, b, "--threshold", str(1.1 / 255), "--json"],
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def row(options, pack, folder):
    pictures = {profile: folder / f"{pack.name}-{profile}.png" for profile in ("core", "compatibility")}
    core, core_seconds = render(options, pack, "core", pictures["core"])
    old, old_seconds = render(options, pack, "compatibility", pictures["compatibility"])
    if core is None or old is None:
        return f"| {pack.name} | failed | | | | |", False
    error = compare(options, *pictures.values())
    good = error["fractionAbove"] <= 0.001
    left_out = ", ".join(core["leftOut"]) or "-"
    return (f"| {pack.name} | {100 * (1 - error['fractionAbove']):.3f} % | "
            f"{255 * error['maxAbsolute']:.0f}/255 | {left_out} | {old_seconds:.0f} | "
            f"{core_seconds:.0f} |", good)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("packs", nargs="+", type=Path)
    parser.add_argument("--world", default="worlds/glazed_house")
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--frames", type=int, default=3)
    parser.add_argument("--keep", type=Path, help="folder to leave the pictures in")
    options = parser.parse_args()
    all_good = True
    print("| pack | within 1/255 | worst | left out | compatibility, s | core, s |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for pack in options.packs:
            line, good = row(options, pack, folder)
            print(line, flush=True)
            all_good &= good
    return 0 if all_good else 1


if __name__ == "__main__":
    sys.exit(main())
