#!/usr/bin/env python3
"""kill_test.py ORRIS SOURCE [--kills N] [--seed S]: kills commands that write files, with all their processes, after
random times. What lies at an output afterwards is the older file or the whole new one, no process is left, and the
next run gives the same bytes as one that was never disturbed."""
import argparse
import collections
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "app"))
from cases import FINAL, FINAL_VERTEX, PACK, VERSION  # noqa: E402

OLDER = b"older\n"
WORLD = {"size": [2, 2, 2], "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [1, 0, 1]}],
         "cameras": [{"name": "front", "position": [1, 1.5, 4], "yaw": 180, "pitch": 0}]}
BROKEN = {"pack/shaders/composite.vsh": FINAL_VERTEX,
          "pack/shaders/composite.fsh": VERSION + "void main() { gl_FragColor = vec3(1.0); }\n"}
CHART = ("chart pack world -o out --size 16x16 --warm-up 1 --frames 2 --rounds 2 --visit 1 --reference-frames 2 "
         "--axis size=16x16,8x8 --reference size=16x16 --quiet")

SET = {"set.json": '{"scenes": [{"world": "world", "times": [0, 6000, 12000]}]}'}
GALLERY = "gallery pack --set-file set.json --size 32x18 --frames 4 --quiet"


class Command:
    """`outputs`: files that a run replaces. `status`: of a whole run."""

    def __init__(self, line, outputs=(), status=0, files=(), check=None, kept=()):
        self.line, self.outputs, self.status = line.split(), outputs, status
        self.files, self.check, self.kept = dict(files), check, kept


def json_files_are_whole(folder):
    for path in folder.rglob("*.json"):
        json.loads(path.read_text())


def is_json(data):
    json.loads(data)


def is_table(data):
    rows = data.decode().splitlines()
    assert len(rows) > 1 and len({row.count(",") for row in rows}) == 1 and data.endswith(b"\n"), data[-200:]


def is_page(data):
    assert data.startswith(b"<!DOCTYPE html>") and data.endswith(b"</html>\n"), data[-200:]


# Of files with times in them, and so with other bytes in each run.
WHOLE = {"times.csv": is_table, "out.json": is_json, "out.html": is_page}
COMMANDS = {
    "render": Command("render pack world -o out.png --size 32x32 --frames 4 --dump colortex0=dump.exr "
                      "--timings times.csv --quiet", ("out.png", "dump.exr", "times.csv")),
    "trace": Command("trace world -o out.exr --size 48x32 --samples 16 --quiet", ("out.exr",)),
    "export": Command("world world --export out.glb", ("out.glb",)),
    "validate": Command("validate pack --write-baseline base.json --report sarif=out.sarif,junit=out.xml --no-cache",
                        ("base.json", "out.sarif", "out.xml"), status=1, files=BROKEN),
    "cache": Command("validate pack --cache cache --report json=out.json", ("out.json",), status=1, files=BROKEN,
                     kept=("cache",)),
    "matrix": Command("validate pack --draw --matrix each --cache cache --report json=out.json", ("out.json",),
                      status=1, files=BROKEN, kept=("cache",)),
    "gallery": Command(GALLERY + " -o out.html", ("out.html",), files=SET),
    "gallery_folder": Command(GALLERY + " -o out", files=SET, check=json_files_are_whole, kept=("out",)),
    "chart": Command(CHART, check=json_files_are_whole, kept=("out",)),
}


def write(folder, files):
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def processes_of(group):
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = path.read_text().rsplit(")", 1)[1].split()
        except (FileNotFoundError, ProcessLookupError):
            continue
        if int(words[2]) == group and words[0] != "Z":
            found.append(path.parent.name)
    return found


class Victim:
    """One command in a folder of its own."""

    def __init__(self, orris, name, folder):
        self.orris, self.name, self.command, self.folder = orris, name, COMMANDS[name], folder
        write(folder, {**PACK, "pack/shaders/final.fsh": FINAL, **self.command.files,
                       "world/world.json": json.dumps(WORLD)})
        began = time.monotonic()
        self.run()
        self.seconds = time.monotonic() - began
        self.whole = {output: (folder / output).read_bytes() for output in self.command.outputs}

    def start(self):
        environment = {**os.environ, "XDG_CACHE_HOME": str(self.folder / "home")}
        return subprocess.Popen([self.orris, *self.command.line], cwd=self.folder, start_new_session=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment)

    def run(self):
        process = self.start()
        said = process.communicate(timeout=300)[0].decode(errors="replace")
        assert process.returncode == self.command.status, (self.name, process.returncode, said)

    def kill(self, after, whole_group):
        """Runs and kills; True when the command had not ended before."""
        for output in self.command.outputs:
            (self.folder / output).write_bytes(OLDER)
        if self.command.kept and random.random() < 0.5:
            for kept in self.command.kept:
                shutil.rmtree(self.folder / kept, ignore_errors=True)
        process = self.start()
        time.sleep(after)
        running = process.poll() is None
        if running and whole_group:
            os.killpg(process.pid, signal.SIGKILL)
        elif running:
            process.kill()
        process.communicate(timeout=30)
        end = time.monotonic() + 1
        while processes_of(process.pid) and time.monotonic() < end:
            time.sleep(0.02)
        left = processes_of(process.pid)
        assert not left, f"{self.name}: processes {left} go on"
        return running

    def judge(self):
        """What lies at each output: "older" or "new"."""
        found = []
        for output, whole in self.whole.items():
            data = (self.folder / output).read_bytes()
            check = WHOLE.get(output)
            if data == OLDER:
                found.append("older")
            elif check:
                check(data)
                found.append("new")
            else:
                assert data == whole, f"{self.name}: {output} is neither the older nor the new file"
                found.append("new")
        if self.command.check:
            self.command.check(self.folder)
        return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris", type=lambda word: str(Path(word).resolve()))
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=COMMANDS)
    arguments = parser.parse_args()
    random.seed(arguments.seed)
    names = [arguments.only] if arguments.only else list(COMMANDS)
    with tempfile.TemporaryDirectory() as temporary:
        victims = []
        for name in names:
            (Path(temporary) / name).mkdir()
            victims.append(Victim(arguments.orris, name, Path(temporary) / name))
        seen, killed = collections.Counter(), 0
        for number in range(arguments.kills):
            victim = victims[number % len(victims)]
            killed += victim.kill(random.uniform(0, 1.05 * victim.seconds), random.random() < 0.5)
            seen.update(victim.judge())
            if number % 5 == 0 or number >= arguments.kills - len(victims):
                victim.run()
                again = victim.judge()
                assert "older" not in again, (victim.name, again)
                if victim.command.check:
                    victim.command.check(victim.folder)
        for victim in victims:
            left = [path.name for path in victim.folder.iterdir() if ".part" in path.name]
            print(f"{victim.name}: a run takes {victim.seconds:.2f} s; {len(left)} temporary files are left")
        print(f"{killed} of {arguments.kills} runs killed before their end; outputs: {dict(seen)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
