#!/usr/bin/env python3
"""Does a frame of one pack cost more than that of another, say of itself at an earlier commit (`git archive COMMIT shaderpack`)?

Each run (`bench_packs`) is a process that draws A, B and A again in turns and counts processor time. Where in memory its
pictures lie stays for a run, so several runs with other places are what counts: prints the median over the runs of B / A
and its 95 % interval by a bootstrap, and the same of A with itself."""

import argparse
import json
import os
import random
import statistics
import subprocess


def interval(values, seed=1):
    """2.5 % and 97.5 % of the bootstrapped median."""
    rng = random.Random(seed)
    medians = sorted(statistics.median(rng.choices(values, k=len(values))) for _ in range(4000))
    return medians[100], medians[3899]


def summary(name, ratios):
    low, high = interval(ratios)
    return f"{name}: {statistics.median(ratios):.4f} [{low:.4f}, {high:.4f}]"


def run(args, number):
    """Milliseconds of A, ratio B / A, ratio A / A. Every second run loads them in another order."""
    packs = [args.pack, args.other, args.pack] if number % 2 else [args.pack, args.pack, args.other]
    env = dict(os.environ, ORRIS_RUN="x" * (97 * number % 4096))  # moves the stack
    done = subprocess.run([args.bench, args.world, args.size, str(args.rounds), *packs, "--", *args.set], check=True,
                          text=True, stdout=subprocess.PIPE, env=env)
    first, second, third = json.loads(done.stdout)
    other, again = (second, third) if number % 2 else (third, second)
    # A twice: the better half of what A costs.
    return first["milliseconds"], 2 * other["ratio"] / (1 + again["ratio"]), again["ratio"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bench", help="bench_packs")
    parser.add_argument("pack", help="A")
    parser.add_argument("other", help="B")
    parser.add_argument("world")
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--rounds", type=int, default=12, help="of a run")
    parser.add_argument("--runs", type=int, default=16)
    parser.add_argument("--set", nargs="*", default=[], metavar="NAME=VALUE")
    args = parser.parse_args()
    runs = [run(args, number) for number in range(args.runs)]
    print(f"A: {statistics.median(r[0] for r in runs):.2f} ms of processor time a frame")
    print(summary("B / A", [r[1] for r in runs]))
    print(summary("A / A", [r[2] for r in runs]))


if __name__ == "__main__":
    main()
