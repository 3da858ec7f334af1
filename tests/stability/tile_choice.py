#!/usr/bin/env python3
"""Counts what a choice between z-pass and z-fail by tile would save, along the paths of
volume_path_gl_test.cpp: builds that test with a stencil that counts updates, and prints what it says."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import host_kill_list

TESTS = "tests/stability/test_volume_path_gl"
FILE = "loader/render/scene/shadow_volumes.cpp"
# Either way of every rule adds one.
EDITS = [("_WRAP", ""), ("GL_DECR", "GL_INCR")]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", help="folder of a build by Ninja")
    parser.add_argument("source", type=pathlib.Path, help="folder of the sources")
    args = parser.parse_args()
    source = args.source.resolve() / FILE
    text = source.read_text()
    for before, after in EDITS:
        text = text.replace(before, after)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / source.name).write_text(text)
        host_kill_list.build_tests(args.build, TESTS, source, folder / source.name, folder / "tests")
        return subprocess.run([folder / "tests", "--gtest_also_run_disabled_tests",
                               "--gtest_filter=*updates_that*", "--gtest_brief=1"],
                              check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
