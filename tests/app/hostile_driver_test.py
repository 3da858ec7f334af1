#!/usr/bin/env python3
"""hostile_driver_test.py PROGRAM SOURCE_DIR LIBRARY: every command that draws on a software rasteriser gives a driver
that was taken over nothing but the drawing. LIBRARY stands in for OSMesa."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from cases import PACK

PROGRAM, SOURCE, LIBRARY = (str(Path(word).resolve()) for word in sys.argv[1:4])
CORNELL = f"{SOURCE}/worlds/cornell"
# What each layer of the sandbox refuses.
BY_LANDLOCK = {"reading", "creating", "creating in the folder", "overwriting", "removing"}
BY_SECCOMP = {"socket", "mode", "process"}
STUDY = "--axis size=32x32 --reference size=32x32 --frames 2 --warm-up 1 --rounds 1 --reference-frames 2"
COMMANDS = {"render": f"render pack {CORNELL} -o out.png",
            "chart": f"chart pack {CORNELL} -o out {STUDY}",
            "chart --scenes": f"chart pack --scenes {CORNELL} -o out --axis size=32x32 --runs 3 --trace-seconds 0.1",
            "tune": f"tune pack {CORNELL} -o out.txt --folder out --error 1 {STUDY}"}


def offered():
    """What this machine has for a sandbox: (Landlock, filters of system calls)."""
    text = subprocess.run([PROGRAM, "doctor", "--json"], stdout=subprocess.PIPE, text=True, timeout=60).stdout
    kernel = json.loads(text)["kernel"]
    return "Landlock: none" not in kernel, "seccomp: none" not in kernel


class HostileDriver(unittest.TestCase):
    def run_with_it(self, command):
        with tempfile.TemporaryDirectory() as temporary:
            path = Path(temporary)
            for name, text in {**PACK, "secret": "hunter2", "out.txt": "older"}.items():
                (path / name).parent.mkdir(parents=True, exist_ok=True)
                (path / name).write_text(text)
            # Of what a process that draws may read.
            shutil.copy(LIBRARY, path / "pack/shaders/libOSMesa.so.8")
            environment = {**os.environ, "LD_LIBRARY_PATH": str(path / "pack/shaders"), "TOKEN": "hunter2"}
            return subprocess.run([PROGRAM, *command.split(), "--size", "32x32", "--backend", "osmesa"], cwd=path, text=True,
                                  capture_output=True, timeout=60, env=environment)

    def test_is_given_nothing(self):
        landlock, seccomp = offered()
        left = (set() if landlock else BY_LANDLOCK) | (set() if seccomp else BY_SECCOMP)
        if left:
            print(f"not looked at, for want of Landlock or seccomp: {', '.join(sorted(left))}")
        for name, command in COMMANDS.items():
            with self.subTest(command=name):
                result = self.run_with_it(command)
                lines = result.stderr.splitlines()
                self.assertIn("hostile driver loaded", lines)
                given = {line.removeprefix("given: ") for line in lines if line.startswith("given: ")}
                self.assertEqual(given - left, set())
                if landlock and seccomp:
                    self.assertIn("no other program", lines)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
