#!/usr/bin/env python3
"""The shards of an option matrix together say what the whole says, and a budget is kept.

matrix_test.py PROGRAM
"""
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

VERSION = "#version 330 compatibility\n"
# Each breaks under values of its own; those of MODE fall into different shards.
PROGRAMS = {
    "composite.fsh": "#define MODE 0 // [0 1 2 3 4 5]\n#define WATER\nvoid main() {\n#if MODE == 1\n"
                     "a1;\n#elif MODE == 4\na4;\n#endif\n#ifndef WATER\ndry;\n#endif\n}\n",
    "final.fsh": "#define SIZE 2 // [1 2 3 4]\n//#define GLOW\nvoid main() {\nfloat a[SIZE];\n"
                 "#ifdef GLOW\nglow;\n#endif\na[1] = 1.0;\ngl_FragColor = vec4(a[1]);\n}\n",
}
FUNCTIONS = 20000  # the compiler compares each with each: minutes
SLOW = ("//#define SLOW\n#ifdef SLOW\nfloat f0() { return 1.0; }\n" +
        "".join(f"float f{i}() {{ return f{i - 1}(); }}\n" for i in range(1, FUNCTIONS)) +
        f"#endif\nvoid main() {{\n#ifdef SLOW\ngl_FragColor = vec4(f{FUNCTIONS - 1}());\n#endif\n}}\n")


def write(pack, programs):
    (pack / "shaders").mkdir(parents=True)
    for name, text in programs.items():
        (pack / "shaders" / name).write_text(VERSION + text)


def validate(program, pack, *flags):
    result = subprocess.run([program, "validate", pack, "--matrix", "each", "--json", *flags],
                            capture_output=True, text=True, timeout=100)
    return json.loads(result.stdout)["packs"][0]


def problems_of(report):
    """Without the notes, which count the configurations of a shard."""
    return {(d["file"], d["line"], d["id"], d["message"]) for d in report["diagnostics"]}


def check_shards(program, folder):
    write(folder / "pack", PROGRAMS)
    whole = validate(program, folder / "pack")
    shards = [validate(program, folder / "pack", "--shard", f"{i}/3") for i in (1, 2, 3)]
    assert len(problems_of(whole)) >= 5, whole["diagnostics"]
    assert problems_of(whole) == set().union(*map(problems_of, shards))
    for count in ("configurations", "tried"):
        total = sum(shard["matrices"][0][count] for shard in shards)
        assert whole["matrices"][0][count] == total == 10, count


def check_budget(program, folder):
    write(folder / "slow", {**PROGRAMS, "deferred.fsh": SLOW})
    begin = time.monotonic()
    report = validate(program, folder / "slow", "--budget", "5s")
    took = time.monotonic() - begin
    assert took < 5 * 1.1 + 2, f"took {took:.1f} s"
    matrix = report["matrices"][0]
    assert matrix["tried"] < matrix["configurations"] == 11, matrix


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_shards(sys.argv[1], Path(folder))
        check_budget(sys.argv[1], Path(folder))


main()
