#!/usr/bin/env python3
"""Renders one golden case and compares the picture with its reference.

golden_test.py PROGRAM SOURCE_DIR CASE_DIR OUTPUT_DIR

CASE_DIR/case.json names what is rendered and three limits; CASE_DIR/ref/picture.png is the
reference. A failing picture and its difference stay in OUTPUT_DIR. With ORRIS_UPDATE=1 in the
environment the reference is replaced instead; look at it before committing.
"""
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

LIMIT_FLAGS = {"rmse": "--max-rmse", "maxAbsolute": "--max-abs", "fractionAbove": "--max-fraction"}


def render_command(program, source, case, picture):
    command = [program, "render", source / case["pack"], source / case["world"], "-o", picture,
               "--backend", "osmesa", "--size", case["size"], "--frames", str(case["frames"])]
    for key in ("camera", "profile", "time", "dimension"):
        if key in case:
            command += [f"--{key}", str(case[key])]
    for name, value in case.get("set", {}).items():
        command += ["--set", f"{name}={value}"]
    return command


def compare_command(program, case, picture, reference, difference):
    command = [program, "compare", picture, reference, "--diff", difference]
    for metric, limit in case["limits"].items():
        command += [LIMIT_FLAGS[metric], str(limit)]
    return command


def run(command):
    print("$", *command, flush=True)
    return subprocess.run(command).returncode


def main():
    program, source, case_dir, output = sys.argv[1], *map(Path, sys.argv[2:])
    case = json.loads((case_dir / "case.json").read_text())
    reference = case_dir / "ref" / "picture.png"
    output.mkdir(parents=True, exist_ok=True)
    picture, difference = output / "picture.png", output / "difference.png"
    if run(render_command(program, source, case, picture)) != 0:
        return 1
    if os.environ.get("ORRIS_UPDATE") == "1":
        reference.parent.mkdir(exist_ok=True)
        shutil.copyfile(picture, reference)
        print("updated", reference)
        return 0
    if run(compare_command(program, case, picture, reference, difference)) != 0:
        print(f"picture: {picture}\ndifference: {difference}\nreference: {reference}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
