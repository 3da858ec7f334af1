#!/usr/bin/env python3
"""page.py [--check]: writes docs/contract.md from the tables of this folder. With --check it only compares:
exit status 1 where the page is stale, or a row of the contract has no row in state.csv.

state.csv has a row for each row of the page, in its order: what this host does of it, where, and the test
that shows it. The tier stands in the contract's own table; in state.csv only for rows that are in none.
"""
import csv
import sys
from collections import Counter
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
PAGE = FOLDER.parent / "contract.md"
HEAD = """# The contract

Which parts of the shader-pack contract this host supports, row by row. **works**: as the game with Iris does it,
which ignores some of OptiFine's. **constant**: a constant, as the other mod that it belongs to is never there.
**not**: not offered, and the note says why. The tier says how common a row is: 1 nearly every pack, 2 common, 3 rare
or tied to the game. "test" names a GoogleTest case, or a row of `tests/app/cases.py`.

The tables of the contract itself, with meaning, unit and source of each row: [contract/](contract/README.md).
Written by [contract/page.py](contract/page.py) from these tables and [contract/state.csv](contract/state.csv);
[tests/check/contract_test.cpp](../tests/check/contract_test.cpp) compares it with the tables of the code in
both directions, and looks up every file and test that it names.
"""
OTHER_PROGRAMS = """
Programs of other mods that the contract's tables do not list; checked as if the mod were there, never
drawn, and counted apart:
"""
# The name of a table and what stands above its rows.
SECTIONS = {
    "programs": "\n## Programs\n", "other programs": OTHER_PROGRAMS, "uniforms": "\n## Uniforms\n",
    "attributes": "\n## Vertex attributes\n", "buffers": "\n## Buffers, samplers and images\n",
    "formats": "\n## Texture formats\n", "constants": "\n## Directives in shader text\n",
    "macros": "\n## Macros\n", "properties": "\n## Keys of shaders.properties\n",
    "options": "\n## Options, profiles, screens, includes and loading\n",
    "idmaps": "\n## Id maps and dimensions\n", "expressions": "\n## Custom uniforms\n"}


def read(table):
    with open(FOLDER / f"{table}.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def contract_rows():
    """(table, name) -> tiers, of each row of that name."""
    tiers = {}
    for path in FOLDER.glob("*.csv"):
        for row in read(path.stem) if path.stem != "state" else []:
            tiers.setdefault((path.stem, next(iter(row.values()))), []).append(row["tier"])
    return tiers


def page():
    tiers, problems = contract_rows(), []
    wanted = Counter({key: len(rows) for key, rows in tiers.items()})
    text, last = HEAD, None
    for row in read("state"):
        key = row["table"], row["name"]
        if row["table"] != last:
            text += SECTIONS[row["table"]] + "\n| name | tier | state | code | test | note |\n"
            text += "| --- | --- | --- | --- | --- | --- |\n"
            last = row["table"]
        if bool(tiers.get(key)) == bool(row["tier"]):
            problems.append(f"state.csv: {key}: its tier stands in the contract's table, or here")
        wanted[key] -= 1
        tier = row["tier"] or (tiers.get(key) or [""]).pop(0)
        cells = [f"`{row['name']}`", tier, row["state"], row["code"], row["test"], row["note"]]
        text += "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n"
    problems += [f"state.csv: no row for {key}" for key, count in wanted.items() if count > 0]
    return text, problems


def main():
    text, problems = page()
    if "--check" not in sys.argv:
        PAGE.write_text(text, encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != text:
        problems.append("docs/contract.md is stale: run docs/contract/page.py")
    print(*problems, sep="\n")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
