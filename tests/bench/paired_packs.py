#!/usr/bin/env python3
"""Is one pack slower than another, say than itself at an earlier commit (`git worktree add OLD COMMIT`)?

Processor time of a frame of each, a long run of `orris render` less a short one, in turns (A B B A); prints the median
of the ratios B / A, its 95 % interval by a bootstrap, and the same of A with itself."""

import argparse
import pathlib
import random
import resource
import statistics
import subprocess
import tempfile

FEW = 2  # frames of a short run


def processor_seconds(orris, pack, args, frames, picture):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([orris, "render", pack, args.world, "-o", picture, "--size", args.size, "--frames", str(frames),
                    "--quiet", *(["--set", *args.set] if args.set else [])], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def frame_time(orris, pack, args, picture):
    """Milliseconds."""
    short, long = (processor_seconds(orris, pack, args, frames, picture) for frames in (FEW, FEW + args.frames))
    return (long - short) / args.frames * 1e3


def interval(values, seed=1):
    """2.5 % and 97.5 % of the bootstrapped median."""
    rng = random.Random(seed)
    medians = sorted(statistics.median(rng.choices(values, k=len(values))) for _ in range(2000))
    return medians[50], medians[1949]


def told(name, ratios):
    low, high = interval(ratios)
    return f"{name}: {statistics.median(ratios):.3f} [{low:.3f}, {high:.3f}]"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris", help="draws A")
    parser.add_argument("pack", type=pathlib.Path, help="A")
    parser.add_argument("other", type=pathlib.Path, help="B")
    parser.add_argument("world")
    parser.add_argument("--other-orris", help="draws B; default: the same")
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--frames", type=int, default=40)
    parser.add_argument("--rounds", type=int, default=12)
    parser.add_argument("--set", nargs="*", default=[], metavar="NAME=VALUE")
    args = parser.parse_args()
    one, two = (args.orris, args.pack), (args.other_orris or args.orris, args.other)
    pairs = []
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "picture.png"
        for _ in range(args.rounds):
            a, b, b2, a2 = (frame_time(*which, args, picture) for which in (one, two, two, one))
            pairs.append((a, a2, (b + b2) / 2))
    print(f"A: {statistics.median((a + a2) / 2 for a, a2, _ in pairs):.2f} ms of processor time a frame")
    print(told("B / A", [2 * b / (a + a2) for a, a2, b in pairs]))
    print(told("A / A", [a2 / a for a, a2, _ in pairs]))


if __name__ == "__main__":
    main()
