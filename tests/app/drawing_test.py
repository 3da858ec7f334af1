#!/usr/bin/env python3
"""drawing_test.py PROGRAM SOURCE_DIR: programs that kill or stall the driver end `render`, `chart`, `tune` and
`validate --draw` with a message that names the pass, leave older outputs as they are and no process behind."""
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from cases import FINAL, FINAL_VERTEX, PACK, VERSION
from hostile_programs import DEADLY, ENDLESS

PROGRAM, SOURCE = (str(Path(word).resolve()) for word in sys.argv[1:3])
CORNELL = f"{SOURCE}/worlds/cornell"
VERTEX = {"pack/shaders/composite1.vsh": FINAL_VERTEX, "pack/shaders/composite1.fsh": FINAL}

SLOW_WORLD = """{ "name": "slow", "size": [512, 64, 512], "blocks": [ { "generate": { "terrain": {
  "seed": 7, "seaLevel": 16, "relief": 20, "trees": 0.5, "plants": 0.06 } } } ],
  "cameras": [ { "name": "only", "position": [48, 40, 90], "target": [44, 18, 40] } ] }"""


def is_running(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def processor_time(pid):
    """In seconds."""
    words = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return sum(map(int, words[11:13])) / os.sysconf("SC_CLK_TCK")


def children(pid):
    found = []
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        found += [int(word) for word in task.read_text().split()]
    return found


class Drawing(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.path = Path(temporary.name)
        self.write({**PACK, **VERTEX, "out.png": "older"})

    def write(self, files):
        for name, text in files.items():
            file = self.path / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)

    def start(self, *words, **more):
        return subprocess.Popen([PROGRAM, *words], cwd=self.path, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, errors="replace", **more)

    def orris(self, *words, status, timeout=60):
        process = self.start(*words)
        out, errors = process.communicate(timeout=timeout)
        self.assertEqual(process.returncode, status, out + errors)
        return errors

    def render(self, *words, world=CORNELL):
        return ["render", "pack", world, "-o", "out.png", "--size", "32x32", *words]

    def leaves_all_as_it_was(self):
        self.assertEqual((self.path / "out.png").read_text(), "older")
        self.assertEqual([path.name for path in self.path.iterdir() if path.is_file()], ["out.png"])


class Frames(Drawing):
    def test_that_do_not_end_are_given_up(self):
        self.write({"pack/shaders/composite1.csh": ENDLESS})
        began = time.monotonic()
        errors = self.orris(*self.render("--frames", "2", "--frame-limit", "1s"), status=3)
        self.assertLess(time.monotonic() - began, 30)
        self.assertRegex(errors, r"(?m)^\S*/composite1\.csh: error: the driver took longer than 1 s while drawing "
                                 r"frame 1, in composite1 \[frame-timeout\]$")
        self.leaves_all_as_it_was()

    def test_that_end_the_driver_are_reported(self):
        self.write({"pack/shaders/composite1.fsh": DEADLY})
        errors = self.orris(*self.render("--frames", "1", "--memory-limit", "2G", "--frame-limit", "30s"), status=3)
        self.assertRegex(errors, r"(?m)^\S*/composite1\.fsh: error: the driver died while (compiling|drawing frame "
                                 r"1, in) composite1 \(signal \d+, .*\) \[driver-died\]$")
        self.leaves_all_as_it_was()

    def test_that_do_not_end_are_given_up_by_chart_and_tune(self):
        self.write({"pack/shaders/composite1.csh": ENDLESS})
        few = ["--size", "32x32", "--frames", "2", "--warm-up", "1", "--rounds", "1", "--reference-frames", "2",
               "--frame-limit", "1s"]
        for words in (["chart", "pack", CORNELL, "-o", "chart"],
                      ["tune", "pack", CORNELL, "-o", "options.txt", "--error", "1"]):
            with self.subTest(command=words[0]):
                errors = self.orris(*words, *few, "--axis", "size=32x32", "--reference", "size=32x32", status=3)
                self.assertIn("[frame-timeout]", errors)
                self.assertIn("in composite1 ", errors)
        self.assertFalse((self.path / "options.txt").exists())

    def test_of_validate_name_the_pass(self):
        self.write({"pack/shaders/composite1.csh": ENDLESS})
        errors = self.orris("validate", "pack", "--draw", "--frame-limit", "1s", status=1)
        self.assertRegex(errors, r"/composite1\.csh: error: one frame of .* takes this driver longer than 1 s ")
        self.assertIn("while drawing frame 1, in composite1", errors)

    def test_hand_over_every_output(self):
        outputs = ["--dump", "colortex0=dump.exr", "--timings", "times.csv", "--patched", "sources"]
        self.orris(*self.render("--frames", "1", *outputs), status=0)
        self.assertEqual((self.path / "out.png").read_bytes()[1:4], b"PNG")
        for name in ("dump.exr", "times.csv", "sources/final.fsh"):
            self.assertGreater((self.path / name).stat().st_size, 0, name)
        self.assertEqual(sorted(path.name for path in self.path.iterdir()),
                         ["dump.exr", "out.png", "pack", "sources", "times.csv"])

    def test_say_when_an_output_cannot_be_written(self):
        (self.path / "sources").mkdir()
        (self.path / "sources" / "final.fsh").symlink_to("/etc/passwd")
        errors = self.orris(*self.render("--frames", "1", "--patched", "sources"), status=2)
        self.assertIn("final.fsh: error: ", errors)


class Signals(Drawing):
    def started(self, seconds=0.6, world=CORNELL):
        """The command and the process that draws, when that has taken so much processor time: the default is more
        than loading takes, so that the frame without end has begun."""
        self.write({"pack/shaders/composite1.csh": ENDLESS})
        process = self.start(*self.render(world=world), start_new_session=True)
        end = time.monotonic() + 60
        while time.monotonic() < end:
            drawing = children(process.pid)
            if drawing and processor_time(drawing[0]) >= seconds:
                return process, drawing[0]
            time.sleep(0.01)
        self.fail("no frame began")

    def test_end_both_processes_at_once(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(signal=number.name):
                process, drawing = self.started()
                process.send_signal(number)
                process.communicate(timeout=10)
                self.assertEqual(process.returncode, -number)
                self.assertFalse(is_running(drawing))
                self.leaves_all_as_it_was()

    def test_of_a_terminal_reach_both_and_are_no_message(self):
        process, drawing = self.started()
        os.killpg(process.pid, signal.SIGINT)
        _, errors = process.communicate(timeout=10)
        self.assertEqual((process.returncode, errors), (-signal.SIGINT, ""))
        self.assertFalse(is_running(drawing))

    def test_that_kill_while_loading_name_the_pack(self):
        # Seconds of terrain, so that loading goes on for long after it has begun.
        self.write({"slow/world.json": SLOW_WORLD})
        process, drawing = self.started(seconds=0.01, world="slow")
        os.kill(drawing, signal.SIGKILL)
        _, errors = process.communicate(timeout=10)
        self.assertEqual(process.returncode, 3)
        self.assertRegex(errors, r"(?m)^pack: error: the driver died while loading \(signal 9")

    def test_that_kill_the_one_kill_the_other(self):
        process, drawing = self.started()
        process.kill()
        process.communicate(timeout=10)
        end = time.monotonic() + 5
        while is_running(drawing) and time.monotonic() < end:
            time.sleep(0.02)
        self.assertFalse(is_running(drawing))
        process, drawing = self.started()
        os.kill(drawing, signal.SIGKILL)
        _, errors = process.communicate(timeout=10)
        self.assertEqual(process.returncode, 3)
        self.assertIn("(signal 9, Killed) [driver-died]", errors)
        self.leaves_all_as_it_was()


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
