#!/usr/bin/env python3
"""Says which mistakes of the tables below tests/ have lost their place: mutant_places.py SOURCE

Each must find what it replaces exactly once in its file, in the reference pack or in the host. Whether the tests find
the mistake is for kill_list.py and host_kill_list.py, which take minutes."""

import pathlib
import shutil
import sys
import tempfile

import host_kill_list
import kill_list


def lost_in_pack(table, pack):
    for name, _, edits in table:
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for file in {file for file, _, _ in edits}:
                (copy / "shaders" / file).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(pack / "shaders" / file, copy / "shaders" / file)
            problem = kill_list.mutate(copy, edits)
        if problem:
            yield f"{name}: {problem}"


def lost_in_host(table, source):
    for mutant in host_kill_list.rows_of(table):
        problem = host_kill_list.mutated(mutant, source)[1]
        if problem:
            yield f"{mutant[0]}: {problem}"


def main():
    source = pathlib.Path(sys.argv[1])
    count, lost = 0, []
    for path in sorted(source.glob("tests/*/*_mutants.py")) + [source / "tests/stability/mutants.py"]:
        table = kill_list.read_table(path)
        in_host = isinstance(table, dict)
        count += sum(map(len, table.values())) if in_host else len(table)
        found = lost_in_host(table, source) if in_host else lost_in_pack(table, source / "shaderpack")
        lost += [f"{path.relative_to(source)}: {problem}" for problem in found]
    print(*lost, f"{count - len(lost)} of {count} mistakes have their place", sep="\n")
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
