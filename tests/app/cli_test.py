#!/usr/bin/env python3
"""Runs one case of cases.py: the real program in an empty folder, then its exit status, its
messages and the files it left are compared with the table.

cli_test.py --list                      names and labels of all cases
cli_test.py PROGRAM SOURCE_DIR NAME     runs one
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from cases import CASES


def populate(folder, files):
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())


def files_in(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def check_errors(expected, stderr):
    """One error line for each expectation, no other."""
    lines = [line for line in stderr.splitlines() if re.search(r"\berror: ", line)]
    problems = []
    for pattern in expected:
        found = [line for line in lines if re.search(pattern, line)]
        if len(found) != 1:
            problems.append(f"{len(found)} error lines match {pattern!r}, expected one")
    if len(lines) != len(expected):
        problems.append(f"{len(lines)} error lines, expected {len(expected)}")
    return problems


def run(program, case, words, folder):
    before = files_in(folder)
    environment = {**os.environ, **case.environment}
    result = subprocess.run([program, *words], cwd=folder, env=environment, text=True,
                            errors="replace", capture_output=True, timeout=110)
    problems = check_errors(case.errors, result.stderr)
    if result.returncode != case.status:
        problems.append(f"exit status {result.returncode}, expected {case.status}")
    for pattern in case.stderr:
        if not re.search(pattern, result.stderr, re.M):
            problems.append(f"standard error does not match {pattern!r}")
    for pattern in case.stdout:
        if not re.search(pattern, result.stdout, re.M):
            problems.append(f"standard output does not match {pattern!r}")
    created = files_in(folder) - before
    if created != set(case.creates):
        problems.append(f"created {sorted(created)}, expected {sorted(case.creates)}")
    if problems:
        print("$ orris", *words)
        print(result.stdout + result.stderr)
    return problems


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(f"{case.name}:{case.label}" for case in CASES))
        return 0
    program, source, name = sys.argv[1:]
    case = next(case for case in CASES if case.name == name)
    failed = False
    for command in case.commands:
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            populate(folder, case.files)
            words = [word.replace("{source}", source) for word in command.split()]
            for problem in run(program, case, words, folder):
                print(f"{name}: {problem}")
                failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
