#!/usr/bin/env python3
"""Runs every fuzz target of a build with the preset `fuzz` and keeps what it finds.

    tests/fuzz/nightly.py build/fuzz --minutes 240 --kept fuzz-kept [--only NAME]... [--shard i/n] [--jobs N]

The minutes are shared by the targets. FOLDER/corpus/NAME keeps inputs that reach something new, with which the next run
begins, FOLDER/found/ those that fail, FOLDER/runs.csv a row for each target and run. A finding makes the status 1."""
import argparse
import csv
import datetime
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

CORPORA = Path(__file__).resolve().parent / "corpus"
FIELDS = ["date", "target", "inputs", "seconds", "megabytes", "edges", "findings"]
LONGEST_INPUT, MOST_MEGABYTES, LONGEST_SECONDS = 1024, 4096, 25


def last_number(pattern, log):
    """The number of the last line that fits, 0 where none does.

    >>> last_number(r"cov: (\\d+)", "#1 cov: 12 ft: 3\\n#9 cov: 40 ft: 3")
    40
    """
    found = re.findall(pattern, log)
    return int(found[-1]) if found else 0


def row_of(target, log, findings, seconds):
    return {"date": datetime.date.today().isoformat(), "target": target,
            "inputs": last_number(r"number_of_executed_units:\s+(\d+)", log), "seconds": round(seconds),
            "megabytes": last_number(r"peak_rss_mb:\s+(\d+)", log), "edges": last_number(r"cov: (\d+)", log),
            "findings": findings}


def run_target(program, kept, seconds):
    name = program.name.removeprefix("fuzz_")
    corpus, found = kept / "corpus" / name, kept / "found"
    corpus.mkdir(parents=True, exist_ok=True)
    found.mkdir(exist_ok=True)
    before = set(found.glob(f"{name}-*"))
    # libFuzzer writes into the first folder.
    folders = [corpus] + [CORPORA / name] * (CORPORA / name).is_dir()
    begin = datetime.datetime.now()
    done = subprocess.run(
        [program, f"-max_total_time={seconds}", f"-max_len={LONGEST_INPUT}", "-entropic=0", "-reload=0",
         f"-rss_limit_mb={MOST_MEGABYTES}", f"-timeout={LONGEST_SECONDS}", "-print_final_stats=1",
         f"-artifact_prefix={found}/{name}-", *folders],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False, errors="replace", text=True)
    (kept / f"{name}.log").write_text(done.stderr)
    new = sorted(set(found.glob(f"{name}-*")) - before)
    for path in new:
        print(f"{name} fails: {path}", flush=True)
    if done.returncode != 0 and not new:
        print(f"{name} ends with {done.returncode}: {kept / f'{name}.log'}", flush=True)
    elapsed = (datetime.datetime.now() - begin).total_seconds()
    return row_of(name, done.stderr, max(len(new), int(done.returncode != 0)), elapsed)


def append(path, rows):
    is_new = not path.exists()
    with open(path, "a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, FIELDS)
        if is_new:
            writer.writeheader()
        writer.writerows(rows)


def table(path, rows):
    with open(path, encoding="utf-8") as file:
        inputs = [(row["target"], int(row["inputs"])) for row in csv.DictReader(file)]
    lines = ["| target | inputs | all runs | a second | most MB | edges | findings |", "| --- | --- | --- | --- | --- | --- | --- |"]
    for row in rows:
        total = sum(count for target, count in inputs if target == row["target"])
        rate = row["inputs"] // max(row["seconds"], 1)
        lines.append(f"| `{row['target']}` | {row['inputs']} | {total} | {rate} | {row['megabytes']} | {row['edges']} | {row['findings']} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("--minutes", type=float, default=60, help="of each process, for all its targets")
    parser.add_argument("--kept", type=Path, default=Path("fuzz-kept"), metavar="FOLDER")
    parser.add_argument("--only", action="append", metavar="NAME")
    parser.add_argument("--shard", default="1/1", help="i/n: each n-th target, from the i-th")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    options = parser.parse_args()
    index, shards = map(int, options.shard.split("/"))
    programs = [program for program in sorted(options.build.resolve().glob("tests/fuzz/fuzz_*"))
                if not options.only or program.name.removeprefix("fuzz_") in options.only][index - 1::shards]
    if not programs:
        sys.exit(f"{options.build}/tests/fuzz has no such target: cmake --preset fuzz && cmake --build --preset fuzz")
    kept = options.kept.resolve()
    kept.mkdir(parents=True, exist_ok=True)
    seconds = max(1, round(options.minutes * 60 * options.jobs / len(programs)))
    with ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda program: run_target(program, kept, seconds), programs))
    append(kept / "runs.csv", rows)
    print(table(kept / "runs.csv", rows))
    return int(any(row["findings"] for row in rows))


if __name__ == "__main__":
    sys.exit(main())
