#!/usr/bin/env python3
"""Whether minecraft_data.py sees a wrong block table: minecraft_data_test.py PRINT_BLOCK_FACTS

Three blocks are written as the package has them, and what the block table says of them is changed, one fact at a time.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

CHECK = Path(__file__).with_name("minecraft_data.py")
BLOCKS = [
    {"name": "stone", "emitLight": 0, "filterLight": 15, "states": [], "defaultState": 1, "minStateId": 1},
    {"name": "glowstone", "emitLight": 15, "filterLight": 15, "states": [], "defaultState": 2, "minStateId": 2},
    {"name": "stone_slab", "emitLight": 0, "filterLight": 0, "defaultState": 6, "minStateId": 3, "states": [
        {"name": "type", "type": "enum", "num_values": 3, "values": ["top", "bottom", "double"]},
        {"name": "waterlogged", "type": "bool", "num_values": 2}]},
]
CUBE, TOP, BOTTOM = [[0, 0, 0, 1, 1, 1]], [[0, 0.5, 0, 1, 1, 1]], [[0, 0, 0, 1, 0.5, 1]]
SHAPES = {"blocks": {"stone": 1, "glowstone": 1, "stone_slab": [2, 2, 3, 3, 1, 1]},
          "shapes": {"1": CUBE, "2": TOP, "3": BOTTOM}}

# The line of a state, what is changed of its facts, and what the check says of it.
MUTANTS = [
    (0, {"emission": 1}, "emission of stone: ours 1, theirs 0"),
    (0, {"opacity": 0}, "opacity of stone: ours 0, theirs 15"),
    (1, {"emission": 14}, "emission of glowstone: ours 14, theirs 15"),
    (1, {"known": False}, "unknown: glowstone"),
    (2, {"boxes": [[0, 0, 0, 16, 8, 16]]}, "shape of stone_slab: 1 of 6 states, stone_slab[type=top,waterlogged=true]"),
    (7, {"boxes": [[0, 0, 0, 16, 15, 16]]}, "shape of stone_slab: 1 of 6 states, stone_slab[type=double,waterlogged=false]"),
]


def table_with(folder, program, line, changes):
    """A program that says what `program` says, but for one line."""
    path = folder / "facts"
    path.write_text(f"""#!{sys.executable}
import json, subprocess, sys
lines = subprocess.run([{str(program)!r}], stdin=sys.stdin, stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
facts = json.loads(lines[{line}])
facts.update({changes!r})
lines[{line}] = json.dumps(facts)
print("\\n".join(lines))
""")
    path.chmod(0o755)
    return path


def check(program, folder):
    run = subprocess.run([sys.executable, CHECK, program, folder], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def main():
    program = Path(sys.argv[1]).resolve()
    missed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "blocks.json").write_text(json.dumps(BLOCKS))
        (folder / "blockCollisionShapes.json").write_text(json.dumps(SHAPES))
        status, text = check(program, folder)
        if status != 0:
            sys.exit(f"the table as it is: status {status}\n{text}")
        for line, changes, said in MUTANTS:
            status, text = check(table_with(folder, program, line, changes), folder)
            if status != 1 or said not in text:
                missed += 1
                print(f"missed {changes} of line {line}, status {status}:\n{text}")
    print(f"{len(MUTANTS) - missed} of {len(MUTANTS)} wrong tables found")
    return 1 if missed else 0


sys.exit(main())
