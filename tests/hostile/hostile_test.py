#!/usr/bin/env python3
"""Runs orris on hostile inputs ("bombs") under an address-space limit.

Each must end within a processor time and a memory that do not depend on it, with status 0 to 3, no
signal, and a message with a place where it is refused; where the table names the id of a message, that
message must be there. Everything is generated into a temporary folder.

  hostile_test.py build/release/orris [--class text] [--only NAME] [--some | --all] [--print]
"""

import argparse
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import bombs_draw
import bombs_files
import bombs_options
import bombs_text
import bombs_world

CLASSES = {"text": bombs_text, "options": bombs_options, "world": bombs_world, "files": bombs_files,
           "draw": bombs_draw}
# One of each kind of limit, quick ones: part of every test run.
SOME = {"text": {"stringify-nested", "paste-doubling", "laughs", "tokens-on-a-line", "includes-double",
                 "includes-missing", "if-nested", "bracket-stray", "utf16", "errors-many"},
        "options": {"profiles-double", "profiles-circle", "profile-line-145-kb", "screens-chain",
                    "uniforms-chain-10-5", "dimensions-many", "options-10-4"},
        "world": {"keys-20-000", "fills-100", "schematic-empty-palette", "schematic-width-0x10001"},
        "files": {"links-2-27", "zip-encrypted", "zip-lzma", "zip-twice", "fifo"},
        "draw": {"dispatch-65535-2", "local-array-2-31", "shared-beyond", "uniform-array-10-8"}}
ROOT = Path(__file__).resolve().parents[2]
WORLD, PACK = ROOT / "worlds" / "cornell", ROOT / "tests" / "packs" / "clean"
# A frame may take so long. A driver reserves more addresses than it uses.
FRAME_SECONDS, DRAWING_ADDRESSES = 5, 2048
# Nine buffers of a GiB each that a pack asks for: one is made, which --memory-limit is for.
ASKED_FOR = {"buffers-huge": 1280}
ADDRESS_SPACE = 4 << 30
SECONDS, MEGABYTES, WALL_SECONDS = 5.0, 512, 120
LOCATED = re.compile(r"^\S[^:]*(:\d+)*: (error|warning|note): ", re.M)
LONGEST_MESSAGE_LINES = 100


def commands(orris: str, kind: str, path: Path, everything: bool) -> list:
    limit_words = ["--frame-limit", f"{FRAME_SECONDS}s"]

    def render(pack, world):
        return [orris, "render", str(pack), str(world), "-o", str(path.parent / "out.png"), "--size", "64x36",
                "--frames", "2", "--memory-limit", f"{DRAWING_ADDRESSES}M", *limit_words]
    if kind == "draw":
        return [render(path, WORLD), [orris, "validate", str(path), "--draw", *limit_words]]
    if kind == "world":
        return [[orris, "world", str(path), "--json"]] + ([render(PACK, path)] if everything else [])
    runs = [[orris, "validate", str(path)]]
    if everything:
        runs += [[orris, "options", str(path)], render(path, WORLD)]
    return runs


def limit() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Outcome:
    def __init__(self, command: list, folder: Path, wall_seconds: float = WALL_SECONDS):
        self.wall_seconds = wall_seconds
        with open(folder / "out", "wb") as out:
            begin = time.monotonic()
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=out,
                                       preexec_fn=limit, cwd=folder, start_new_session=True)
            self.hung = not self.wait(process, begin)
        self.text = (folder / "out").read_bytes().decode("utf-8", "replace")

    def wait(self, process, begin) -> bool:
        ended = False
        while not ended and time.monotonic() - begin < self.wall_seconds:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            ended = pid != 0
            if not ended:
                time.sleep(0.01)
        if not ended:
            os.killpg(process.pid, 9)
            _, status, usage = os.wait4(process.pid, 0)
        process.returncode = self.status = os.waitstatus_to_exitcode(status)
        self.seconds = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024
        return ended

    def problems(self, expected, measured: bool, drawing: bool, megabytes: int) -> list:
        # Loading, each program and two frames may take the time of a frame; all cores work.
        seconds = 4 * (FRAME_SECONDS + 2) * (os.cpu_count() or 1) if drawing else SECONDS
        found = []
        if self.hung:
            found.append("no end")
        elif not 0 <= self.status <= 3:
            found.append(f"status {self.status}")
        elif self.status > 0 and not LOCATED.search(self.text):
            found.append("no message with a place")
        if measured and self.seconds > seconds:
            found.append(f"{self.seconds:.1f} s of processor time")
        if measured and self.megabytes > megabytes:
            found.append(f"{self.megabytes:.0f} MB")
        if expected and f"[{expected}]" not in self.text and f'"{expected}"' not in self.text:
            found.append(f"no message [{expected}]")
        return found


def run_bomb(orris: str, kind: str, name: str, row, everything: bool, measured: bool):
    """(lines to print, whether it failed)."""
    build, expected = row()
    base = Path(tempfile.mkdtemp(prefix="orris-hostile-"))
    lines, failed = [], False
    try:
        (base / "bomb").mkdir()
        path = build(base / "bomb")
        del build  # a child counts the memory of its parent until it runs its program
        for command in commands(orris, kind, path, everything):
            outcome = Outcome(command, base)
            wanted = expected if command[1] == ("render" if kind == "draw" else "validate") or \
                command[1] == "world" else None
            drawing = kind == "draw" or command[1] == "render"
            asked = ASKED_FOR.get(name, MEGABYTES) if drawing else MEGABYTES
            problems = outcome.problems(wanted, measured, drawing, asked)
            failed |= bool(problems)
            lines.append(f"{'FAIL' if problems else 'ok  '} {kind}/{name} {command[1]}: status "
                         f"{outcome.status}, {outcome.seconds:.2f} s, {outcome.megabytes:.0f} MB"
                         f"{': ' + ', '.join(problems) if problems else ''}")
            if problems:
                lines += ["    " + line[:300] for line in outcome.text.splitlines()[:6]]
    finally:
        shutil.rmtree(base)
    return lines, failed


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("orris")
    parser.add_argument("--class", dest="kind", choices=sorted(CLASSES))
    parser.add_argument("--only", help="run this one")
    parser.add_argument("--some", action="store_true", help="a few of each class")
    parser.add_argument("--all", action="store_true", help="the slow ones and `orris options` too")
    parser.add_argument("--print", action="store_true", help="print every line")
    options = parser.parse_args()
    # A sanitizer reserves terabytes of addresses and takes its own time.
    measured = not os.environ.get("ORRIS_HOSTILE_UNMEASURED")
    failures = count = 0
    for kind, bombs in CLASSES.items():
        for name, row in bombs.BOMBS.items():
            heavy = name in bombs.HEAVY
            chosen = options.kind in (None, kind) and options.only in (None, name)
            chosen &= not heavy or options.all or bool(options.only)
            chosen &= not options.some or name in SOME[kind]
            if not chosen:
                continue
            lines, failed = run_bomb(os.path.abspath(options.orris), kind, name, row, options.all, measured)
            failures += failed
            count += 1
            if failed or options.print:
                print("\n".join(lines), flush=True)
    print(f"{count} hostile inputs, {failures} failed")
    return 1 if failures or not count else 0


if __name__ == "__main__":
    sys.exit(main())
