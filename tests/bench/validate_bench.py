#!/usr/bin/env python3
"""Times `orris validate PACK` beside starting glslangValidator once for each stage of the same texts.

    tests/bench/validate_bench.py build/release/orris PACK [--runs 5]

The texts are those that `--patched` writes: includes and directives resolved, as the driver gets
them. glslangValidator is started once for each of them, on one core and on all cores; the three are
run in turn, so that what else the machine does hits them alike. Printed are medians, the least and
the most, and the ratio within each round. `orris validate` does more in its time: it reads the pack,
preprocesses, links, and runs its own checks. Exit status: 1 when a tool does not accept the texts.
"""
import argparse
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

STAGES = {".vsh": "vert", ".fsh": "frag", ".gsh": "geom", ".csh": "comp",
          ".tcs": "tesc", ".tes": "tese"}


def run(command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)


def validate(orris, pack, *flags):
    done = run([orris, "validate", pack, "--quiet", *flags])
    if done.returncode not in (0, 1):
        sys.exit(f"orris validate ended with {done.returncode}:\n{done.stdout}")
    return done


def compile_alone(texts, processes):
    """One glslangValidator a text, `processes` at a time; the texts that it refuses."""
    def one(text):
        return run(["glslangValidator", "-S", STAGES[text.suffix], str(text)]).returncode
    with ThreadPoolExecutor(processes) as pool:
        return [text for text, status in zip(texts, pool.map(one, texts)) if status]


def timed(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def row(name, seconds, ratios):
    line = f"{name:<34}{statistics.median(seconds):9.2f}{min(seconds):9.2f}{max(seconds):9.2f}"
    if ratios:
        line += f"{statistics.median(ratios):9.2f}{min(ratios):9.2f}{max(ratios):9.2f}"
    print(line)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("orris")
    parser.add_argument("pack")
    parser.add_argument("--runs", type=int, default=5)
    args = parser.parse_args()
    if not shutil.which("glslangValidator"):
        sys.exit("glslangValidator is not installed (package glslang-tools)")
    cores = len(os.sched_getaffinity(0))
    with tempfile.TemporaryDirectory() as folder:
        validate(args.orris, args.pack, "--patched", folder)
        texts = sorted(p for p in pathlib.Path(folder).rglob("*") if p.suffix in STAGES)
        refused = compile_alone(texts, cores)
        contenders = {
            "orris validate": lambda: validate(args.orris, args.pack),
            f"glslangValidator, {cores} at a time": lambda: compile_alone(texts, cores),
            "glslangValidator, one at a time": lambda: compile_alone(texts, 1),
        }
        seconds = {name: [] for name in contenders}
        for _ in range(args.runs):
            for name, work in contenders.items():
                seconds[name].append(timed(work))
    base = seconds["orris validate"]
    print(f"{pathlib.Path(args.pack).name}: {len(texts)} stages, {args.runs} rounds, {cores} cores")
    print(f"{'':<34}{'median s':>9}{'least':>9}{'most':>9}{'ratio':>9}{'least':>9}{'most':>9}")
    for name, values in seconds.items():
        row(name, values, [] if values is base else [v / b for v, b in zip(values, base)])
    for text in refused[:5]:
        print(f"refused by glslangValidator: {text.relative_to(folder)}")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
