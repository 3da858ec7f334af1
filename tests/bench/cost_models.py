#!/usr/bin/env python3
"""Fits the costs by which SHADOW_METHOD=AUTO and LIGHT_METHOD=AUTO of the reference pack choose.

Charts the candidates in many scenes (`orris chart`, interleaved, processor time), fits each one's cost over the
same frame without it, with no negative factor, by least squares relative to the frame, and prints the `auto.*`
lines of shaders.properties. Then how good the choice by these lines is, and by those that the pack has: the chosen candidate's measured
cost over the cheapest one's. A second run of the same command goes on where the first one ended."""

import argparse
import json
import pathlib
import shutil
import subprocess

from chart_runs import SOURCE, frame_times, lamp_field

QUANTITIES = ["pixels", "faces", "casters", "volumes", "casters_near", "lamps", "lamps_reaching", "sun", "texel_pixels"]
SIZES = ["160x90", "320x180", "640x360"]
SHADOW_SCENES = [("pillars", "front"), ("hills", "shore"), ("pillars", "low"), ("h4_house", "outside"),
                 ("hills", "water")]
RESOLUTIONS = ["512", "1024", "2048"]  # of the map, in the first scene; elsewhere 1024
LAMPS = [4, 16, 64, 256, 4096]
COMMON = ["GI_METHOD=NONE"]

# Candidate -> terms, each a product of quantities; `texels` are those of the map.
MODELS = {
    "SHADOW_METHOD": {"MAP_PCF": [[], ["faces"], ["pixels"], ["texels"]],
                      "VOLUME_AUTO": [[], ["volumes"], ["pixels"], ["volumes", "pixels"]]},
    "LIGHT_METHOD": {"FORWARD": [[], ["pixels"], ["pixels", "lamps"]],
                     "DEFERRED": [[], ["pixels"], ["pixels", "lamps"]],
                     "TILED": [[], ["pixels"], ["lamps"], ["pixels", "lamps_reaching"]],
                     "CLUSTERED": [[], ["pixels"], ["lamps"], ["pixels", "lamps_reaching"]]},
}
BASELINE = {"SHADOW_METHOD": "NONE", "LIGHT_METHOD": "NONE"}
FORWARD_MOST = 64  # lamps: beyond, it takes seconds a frame and wins nowhere


def cases(args):
    """(option, name, world, camera, size, settings, candidates)"""
    if "shadows" in args.only:
        for world, camera in SHADOW_SCENES:
            for size in SIZES:
                for texels in RESOLUTIONS if (world, camera) == SHADOW_SCENES[0] else ["1024"]:
                    yield ("SHADOW_METHOD", f"{world}-{camera}-{size}-{texels}", SOURCE / "worlds" / world, camera, size,
                           [f"SHADOW_RESOLUTION={texels}"], list(MODELS["SHADOW_METHOD"]))
    if "lamps" in args.only:
        for count in LAMPS:
            world = lamp_field(count, args.folder)
            for size in SIZES[:2]:
                methods = [m for m in MODELS["LIGHT_METHOD"] if m != "FORWARD" or count <= FORWARD_MOST]
                yield ("LIGHT_METHOD", f"lamps{count}-{size}", world, "eye", size, ["SHADOW_METHOD=NONE"], methods)


def measure(args, option, name, world, camera, size, settings, candidates):
    """Milliseconds a frame by value, the baseline's among them."""
    values = [BASELINE[option], *candidates]
    times = frame_times(args.orris, args.pack, world, args.folder / name, [f"{option}={','.join(values)}"], size=size,
                        camera=camera, settings=[*COMMON, *settings], baseline=f"{option}={values[0]}",
                        reference=f"{option}={candidates[-1]}", rounds=args.rounds)
    return {label.split("=")[1]: milliseconds for label, milliseconds in times.items()}


def asking_pack(args):
    """A copy of our pack that asks for every quantity."""
    copy = args.folder / "pack"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(SOURCE / "shaderpack", copy)
    for option in MODELS:
        with (copy / "shaders/shaders.properties").open("a") as file:
            print(f"auto.{option.lower()}.none = 0 {' '.join(QUANTITIES)}", file=file)
    return copy


def choice(args, pack, option, world, camera, size, settings):
    """What `orris render` says of the option's choice."""
    done = subprocess.run([args.orris, "render", pack, world, "-o", args.folder / "asked.png", "--size", size,
                           "--camera", camera, "--frames", "1", "--json", "--set", *COMMON, *settings,
                           f"{option}=AUTO"], check=True, text=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)["auto"]


def quantities(args, pack, option, world, camera, size, settings):
    scene = choice(args, pack, option, world, camera, size, settings)["quantities"]
    texels = next((s.split("=")[1] for s in settings if s.startswith("SHADOW_RESOLUTION")), "1024")
    return {**scene, "texels": float(texels) ** 2}


def product(scene, term):
    value = 1.0
    for name in term:
        value *= scene[name]
    return value


def fit(rows, terms):
    """Factors >= 0 of the terms by coordinate descent; rows of (scene, cost, weight)."""
    table = [([weight * product(scene, term) for term in terms], weight * cost) for scene, cost, weight in rows]
    scale = [max(row[i] for row, _ in table) or 1.0 for i in range(len(terms))]
    table = [([value / s for value, s in zip(row, scale)], cost) for row, cost in table]
    factors = [0.0] * len(terms)
    for _ in range(20000):
        for i in range(len(terms)):
            rest = [cost - sum(f * v for j, (f, v) in enumerate(zip(factors, row)) if j != i) for row, cost in table]
            square = sum(row[i] ** 2 for row, _ in table)
            factors[i] = max(0.0, sum(row[i] * r for (row, _), r in zip(table, rest)) / square) if square else 0.0
    return [f / s for f, s in zip(factors, scale)]


def cost(scene, terms, factors):
    return sum(factor * product(scene, term) for term, factor in zip(terms, factors))


def spelled(terms, factors):
    """As shaders.properties has it."""
    parts = []
    for term, factor in zip(terms, factors):
        names = " ".join("SHADOW_RESOLUTION SHADOW_RESOLUTION" if name == "texels" else name for name in term)
        if factor > 0:
            parts.append(f"{factor:.3g} {names}".strip())
    return " + ".join(parts) or "0"


def judge(option, measured, factors):
    """Prints each case; the worst ratio of the chosen one's frame to the best one's."""
    worst = 1.0
    for name, scene, times in measured:
        base = times[BASELINE[option]]
        found = {value: times[value] for value in MODELS[option] if value in times}
        estimate = {value: base + cost(scene, MODELS[option][value], factors[value]) for value in found}
        chosen, best = min(estimate, key=estimate.get), min(found, key=found.get)
        ratio = found[chosen] / found[best]
        worst = max(worst, ratio)
        numbers = ", ".join(f"{value} {found[value]:.2f} ({estimate[value]:.2f})" for value in found)
        print(f"# {name}: {base:.2f} without, {numbers}: {chosen}, {ratio:.2f} of the best")
    return worst


def judge_pack(args, option, found):
    """Prints where the pack takes another value than the best one; the worst ratio."""
    worst = 1.0
    for case, times in found:
        options = choice(args, args.pack, option, *case[2:6])["options"]
        taken = next(row["value"] for row in options if row["option"] == option)
        best = min(MODELS[option], key=lambda value: times.get(value, float("inf")))
        if taken not in times or taken == best:
            continue
        worst = max(worst, times[taken] / times[best])
        print(f"# {case[1]}: the pack takes {taken}, {times[taken] / times[best]:.2f} of {best}")
    return worst


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("pack", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path, help="for the measurements")
    parser.add_argument("--only", nargs="+", default=["shadows", "lamps"], choices=["shadows", "lamps"])
    parser.add_argument("--rounds", type=int, default=4)
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    times = {}
    for case in cases(args):
        times.setdefault(case[0], []).append((case, measure(args, *case)))
    pack = asking_pack(args)
    for option, found in times.items():
        measured = [(case[1], quantities(args, pack, *case[:1], *case[2:6]), by_value) for case, by_value in found]
        factors = {}
        for value, terms in MODELS[option].items():
            rows = [(scene, by_value[value] - by_value[BASELINE[option]], 1 / by_value[value])
                    for _, scene, by_value in measured if value in by_value]
            factors[value] = fit(rows, terms)
            print(f"auto.{option.lower()}.{value.lower()} = {spelled(terms, factors[value])}")
        print(f"# {option}: the chosen frame at most {judge(option, measured, factors):.2f} of the best")
        print(f"# {option}: by the lines that {args.pack} has at most {judge_pack(args, option, found):.2f} of the best")


if __name__ == "__main__":
    main()
