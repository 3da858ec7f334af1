#!/usr/bin/env python3
"""nightly_test.py: nightly.py with programs that behave as libFuzzer's do."""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

NIGHTLY = Path(__file__).resolve().parent / "nightly.py"
GOOD = """#!/bin/sh
for last; do case $last in -*) ;; *) echo kept > "$last/new"; break;; esac; done
echo "#7 DONE cov: 42 ft: 9" >&2
echo "stat::number_of_executed_units: 1000" >&2
echo "stat::peak_rss_mb:              37" >&2
"""
BAD = """#!/bin/sh
for word; do case $word in -artifact_prefix=*) echo x > "${word#-artifact_prefix=}crash-1";; esac; done
exit 77
"""


def nightly(build, kept, *words):
    done = subprocess.run([sys.executable, NIGHTLY, build, "--kept", kept, "--minutes", "0.02", *words],
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    programs = folder / "build/tests/fuzz"
    programs.mkdir(parents=True)
    for program, text in (("fuzz_good", GOOD), ("fuzz_other", GOOD), ("fuzz_bad", BAD)):
        (programs / program).write_text(text)
        (programs / program).chmod(0o755)
    kept = folder / "kept"

    status, out = nightly(folder / "build", kept, "--only", "good", "--only", "other", "--jobs", "2")
    assert status == 0, out
    assert "| `good` | 1000 | 1000 |" in out and "| 37 | 42 | 0 |" in out, out
    assert (kept / "corpus/good/new").exists(), "inputs are kept in the target's own folder"
    status, out = nightly(folder / "build", kept, "--only", "good")
    assert "| `good` | 1000 | 2000 |" in out, f"all runs count: {out}"

    status, out = nightly(folder / "build", kept, "--only", "bad")
    assert status == 1 and (kept / "found/bad-crash-1").exists() and "bad fails: " in out, out
    status, out = nightly(folder / "build", kept, "--only", "bad")
    assert status == 1 and "bad ends with 77" in out, f"a finding that is known is still one: {out}"

    status, out = nightly(folder / "build", kept, "--shard", "2/3")
    assert status == 0 and "`good`" in out and "`bad`" not in out, out
    status, out = nightly(folder / "build", kept, "--only", "none")
    assert status == 1 and "cmake --preset fuzz" in out, out
    with open(kept / "runs.csv", encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) == 6
