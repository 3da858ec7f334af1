#!/usr/bin/env python3
"""Damages copies of real packs at random and runs `orris validate` on them.

Each run must end in time and memory, without a signal, with status 0 to 3; each error and warning must
have a place or be about the whole pack, and none may be longer than 100 lines.

  mutated_packs.py build/release/orris PACKS/ --count 1000 --seed 1 [--shard i/n]
"""
import argparse
import json
import os
import random
import shutil
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "mutation"))
from hostile_test import LONGEST_MESSAGE_LINES, Outcome  # noqa: E402
from pack_view import copy_pack, find_packs  # noqa: E402

TEXTS = {".vsh", ".fsh", ".gsh", ".csh", ".tcs", ".tes", ".glsl", ".properties", ".lang", ".inc", ".h"}
# What the readers and the preprocessor of a pack look for.
WORDS = [b"#define X X", b"#if 1 +", b"#endif\n", b"#else\n", b'#include "/', b"#include <", b"/*", b"*/", b"//", b"\\\n",
         b"{", b"}", b"((((", b"))))", b"[99999999999999999999]", b"[-1]", b"\0", b"\xff\xfe", b"\xef\xbb\xbf", b"%s%n",
         b"../../../../etc/passwd", b"RENDERTARGETS: 0,99,,", b"const int shadowMapResolution = -2147483648;",
         b"layout(local_size_x = 1000000) in;", b"#version 9999\n", b"=" * 40, b"1e999", b"\r", b"\xe2\x80\xae", b"<profile>"]
MOST_SECONDS, MOST_MEGABYTES = 60, 2048
MOST_BYTES = 1_000_000  # of shader text: larger packs take most of the time, and have no other readers


def flip(rng, data):
    for _ in range(rng.randint(1, 8)):
        if data:
            at = rng.randrange(len(data))
            data[at] ^= 1 << rng.randrange(8)


def cut(rng, data):
    begin = rng.randrange(len(data) + 1)
    del data[begin:begin + rng.choice([1, 10, 100, 10_000])]


def repeat(rng, data):
    begin = rng.randrange(len(data) + 1)
    part = data[begin:begin + rng.choice([1, 20, 400])]
    data[begin:begin] = part * rng.choice([1, 2, 50])


def insert(rng, data):
    at = rng.randrange(len(data) + 1)
    data[at:at] = rng.choice(WORDS)


def shorten(rng, data):
    del data[rng.randrange(len(data) + 1):]


def swap_lines(rng, data):
    lines = data.split(b"\n")
    a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]
    data[:] = b"\n".join(lines)


def replace_number(rng, data):
    digits = [i for i, c in enumerate(data) if 48 <= c <= 57]
    if digits:
        at = rng.choice(digits)
        data[at:at + 1] = rng.choice([b"0", b"-1", b"4294967296", b"99999999999999999999", b"1e40", b"0x"])


CHANGES = [flip, cut, repeat, insert, insert, shorten, swap_lines, replace_number, replace_number]


def damage(rng, shaders):
    """One to six changes in one to four files; now and then a file is renamed or lost."""
    files = sorted(path for path in shaders.rglob("*") if path.suffix in TEXTS and path.is_file())
    done = []
    for path in rng.sample(files, min(len(files), rng.randint(1, 4))):
        data = bytearray(path.read_bytes())
        for _ in range(rng.randint(1, 6)):
            change = rng.choice(CHANGES)
            change(rng, data)
            done.append(f"{change.__name__} {path.relative_to(shaders)}")
        path.write_bytes(data)
        if rng.random() < .05:
            path.rename(path.with_name(rng.choice(["x", "final", "composite99", "a b"]) + path.suffix))
            done.append(f"rename {path.relative_to(shaders)}")
    return done


def problems_of(outcome):
    found = []
    if outcome.hung:
        found.append("no end")
    elif not 0 <= outcome.status <= 3:
        found.append(f"status {outcome.status}")
    if outcome.seconds > MOST_SECONDS:
        found.append(f"{outcome.seconds:.1f} s of processor time")
    if outcome.megabytes > MOST_MEGABYTES:
        found.append(f"{outcome.megabytes:.0f} MB")
    return found


def message_problems(report, unlocated):
    """Of the JSON report. Counts the ids of what has no place in `unlocated`."""
    found = []
    for d in (d for pack in report["packs"] for d in pack["diagnostics"]):
        if d["severity"] == "note":
            continue
        text = "\n".join([d["message"], d.get("hint") or "", *(d.get("notes") or [])])
        if text.count("\n") >= LONGEST_MESSAGE_LINES:
            found.append(f"a message [{d['id']}] of {text.count(chr(10)) + 1} lines")
        if not d.get("file"):
            unlocated[d["id"]] += 1
    return found


def run(orris, source, rng, unlocated):
    """(status, problems, changes) of one damaged copy."""
    base = Path(tempfile.mkdtemp(prefix="orris-damaged-"))
    try:
        copy_pack(source, base / "pack")
        changes = damage(rng, base / "pack" / "shaders")
        report = base / "report.json"
        outcome = Outcome([orris, "validate", "pack", "--no-cache", "--report", f"json={report.name}"], base,
                          wall_seconds=10 * MOST_SECONDS)
        found = problems_of(outcome)
        if report.exists():
            found += message_problems(json.loads(report.read_text()), unlocated)
        elif outcome.status < 2:
            found.append("no report")
        return outcome.status, found, changes
    finally:
        shutil.rmtree(base, ignore_errors=True)


def size_of(pack):
    return sum(path.stat().st_size for path in (pack / "shaders").rglob("*") if path.suffix in TEXTS)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("orris")
    parser.add_argument("packs", help="folder of packs; they are copied, never changed")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shard", default="1/1", help="i/n: each n-th run, from the i-th")
    options = parser.parse_args()
    index, shards = map(int, options.shard.split("/"))
    packs = [pack for pack in find_packs(options.packs).values() if size_of(pack) <= MOST_BYTES]
    statuses, unlocated, failed = Counter(), Counter(), 0
    for number in range(index - 1, options.count, shards):
        rng = random.Random(f"{options.seed}:{number}")
        source = rng.choice(packs)
        status, found, changes = run(os.path.abspath(options.orris), source, rng, unlocated)
        statuses[status] += 1
        if found:
            failed += 1
            print(f"FAIL {number} {source}: {', '.join(found)}: {'; '.join(changes)}", flush=True)
    print(f"{sum(statuses.values())} damaged copies of {len(packs)} packs: {failed} failed; statuses "
          f"{dict(sorted(statuses.items()))}; messages without a place: {dict(unlocated)}")
    return 1 if failed or not statuses else 0


if __name__ == "__main__":
    sys.exit(main())
