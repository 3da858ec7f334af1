#!/usr/bin/env python3
"""Compares the block table with the package minecraft-data of npm: light given and taken by the default state of each
block, and the outer box of the collision shape by state.

    minecraft_data.py build/release/tests/print_block_facts FOLDER

FOLDER holds blocks.json and blockCollisionShapes.json of one version (data/pc/26.1 of that package); without it the
folder that MINECRAFT_DATA names, and without that the comparison is skipped. Differences that are meant stand below
with their reason; any other one fails. An exception that no block of the newest version needs fails, too, by --strict.
"""
import argparse
import itertools
import json
import os
import re
import subprocess
import sys

SKIPPED = 77

# Pattern of names, reason.
EMISSION = {}
OPACITY = {}
# Here a block is what is drawn; the game lets entities walk through parts of it, or on less or more of it.
SHAPES = {
    r".*chest": "the lock stands out and is no obstacle",
    r"ladder": "is drawn flat and stands out by three",
    r".*_wall_hanging_sign": "the beam alone is an obstacle",
    r"snow": "one sinks in by a layer",
    r"cactus|honey_block|soul_sand|mud": "one sinks in, so that it can hurt or slow",
    r"repeater|comparator": "the torches are no obstacle",
    r".*_fence_gate": "is an obstacle to its full height, in a wall, too",
    r"lily_pad": "is drawn flat",
    r".*_wall": "the ends of arms without a post are drawn shorter",
    r"potted_.*": "the plant is no obstacle",
    r"piglin_head": "turns by its rotation in sixteenths",
    r"chorus_plant": "is an obstacle a little beyond its stem",
    r"chorus_flower": "is an obstacle on the whole block",
    r"pitcher_crop": "is drawn as crossed planes",
    r"sea_pickle|turtle_egg": "those of a block are one obstacle",
    r"bamboo": "stands aside by its place, here in the middle",
    r"lectern|stonecutter|big_dripleaf": "a part that stands out is no obstacle",
    r"bell": "hangs on a bar that is no obstacle",
    r".*lantern": "the chain is no obstacle",
    r".*campfire": "the flames are no obstacle",
    r".*copper_golem_statue": "an obstacle as a golem is, in any pose",
}


def values_of(prop):
    if prop["type"] == "bool":
        return ["true", "false"]
    return [str(v) for v in prop.get("values", range(prop["num_values"]))]


def states_of(block):
    """In the order of their numbers: the last property changes first."""
    lists = [[(p["name"], value) for value in values_of(p)] for p in block["states"]]
    return [dict(state) for state in itertools.product(*lists)]


def text_of(name, state):
    return name + ("[" + ",".join(f"{k}={v}" for k, v in state.items()) + "]" if state else "")


def outer(boxes):
    """The box around boxes, in sixteenths within the block."""
    clamp = lambda v: min(16.0, max(0.0, v))
    return tuple(round(clamp(min(b[i] for b in boxes)), 2) for i in range(3)) + tuple(
        round(clamp(max(b[i] for b in boxes)), 2) for i in range(3, 6))


def read(folder):
    with open(os.path.join(folder, "blocks.json")) as file:
        blocks = json.load(file)
    with open(os.path.join(folder, "blockCollisionShapes.json")) as file:
        return blocks, json.load(file)


def facts_of(program, lines):
    out = subprocess.run([program], input="\n".join(lines), capture_output=True, text=True, check=True)
    return [json.loads(line) for line in out.stdout.splitlines()]


class Comparison:
    def __init__(self):
        self.differences, self.excused, self.used = [], 0, set()

    def differ(self, what, table, name, message):
        for pattern in table:
            if re.fullmatch(pattern, name):
                self.used.add((what, pattern))
                self.excused += 1
                return
        self.differences.append(f"{what} of {name}: {message}")

    def light(self, block, facts):
        for what, table, key, ours in (("emission", EMISSION, "emitLight", facts["emission"]),
                                       ("opacity", OPACITY, "filterLight", facts["opacity"])):
            if block[key] != ours:
                self.differ(what, table, block["name"], f"ours {ours}, theirs {block[key]}")

    def shape(self, name, states, facts, boxes):
        """Where something can stand on a block, it is as large as the game's."""
        wrong = []
        for state, fact, box in zip(states, facts, boxes):
            if not box or fact["thin"] or not fact["boxes"]:
                continue
            ours, theirs = outer(fact["boxes"]), outer([[16 * v for v in b] for b in box])
            if max(abs(a - b) for a, b in zip(ours, theirs)) > 0.51:
                wrong.append((text_of(name, state), ours, theirs))
        if wrong:
            first, ours, theirs = wrong[0]
            self.differ("shape", SHAPES, name, f"{len(wrong)} of {len(states)} states, {first}: ours {ours}, "
                        f"theirs {theirs}")


def compare(program, folder):
    blocks, shapes = read(folder)
    names = [(block, states_of(block)) for block in blocks]
    lines = [text_of(block["name"], state) for block, states in names for state in states]
    facts = iter(facts_of(program, lines))
    result, unknown = Comparison(), []
    for block, states in names:
        own = [next(facts) for _ in states]
        if not own[0]["known"]:
            unknown.append(block["name"])
            continue
        result.light(block, own[block["defaultState"] - block["minStateId"]])
        index = shapes["blocks"].get(block["name"], 0)
        indices = index if isinstance(index, list) else [index] * len(states)
        result.shape(block["name"], states, own, [shapes["shapes"][str(i)] for i in indices])
    return result, unknown, len(blocks), len(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", nargs="?", default=os.environ.get("MINECRAFT_DATA"))
    parser.add_argument("--strict", action="store_true")
    args = parser.parse_args()
    if not args.folder:
        print("skipped: MINECRAFT_DATA names no folder of the package minecraft-data")
        return SKIPPED
    result, unknown, blocks, states = compare(args.program, args.folder)
    for name in unknown:
        print(f"unknown: {name}")
    for line in result.differences:
        print(line)
    print(f"{blocks} blocks, {states} states: {len(unknown)} unknown, {len(result.differences)} differ, "
          f"{result.excused} differ as meant")
    tables = (("emission", EMISSION), ("opacity", OPACITY), ("shape", SHAPES))
    idle = [f"{what} {pattern}" for what, table in tables for pattern in table if (what, pattern) not in result.used]
    if args.strict and idle:
        print("needless exceptions: " + ", ".join(idle))
        return 1
    return 1 if unknown or result.differences else 0


sys.exit(main())
