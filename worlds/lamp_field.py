#!/usr/bin/env python3
"""Makes a world of many lamps: a plain of 128 x 128 blocks with blocks of houses, and lamps of four colours
and levels 5 to 10 spread evenly over ground and roofs. The eye stands in the middle."""

import argparse
import json
import pathlib
import random

SIZE = 128
LAMPS = ["redstone_torch[lit=true]", "soul_torch", "candle[candles=2,lit=true]", "amethyst_cluster[facing=up]"]
WALLS = ["white_concrete", "smooth_stone", "bricks", "oak_planks"]


def make_houses(rng):
    """Boxes: state, corners. None near the eye."""
    houses = []
    while len(houses) < 90:
        x, z = rng.randrange(SIZE - 8), rng.randrange(SIZE - 8)
        far_x, far_z = x + rng.randrange(1, 7), z + rng.randrange(1, 7)
        if x - 4 < SIZE // 2 < far_x + 4 and z - 4 < SIZE // 2 < far_z + 4:
            continue
        houses.append((rng.choice(WALLS), [x, 1, z], [far_x, rng.randrange(2, 10), far_z]))
    return houses


def places(rng, count):
    """`count` different columns, one in each of as many strips of equal area, as far as they are free."""
    side = 1
    while side * side < count:
        side *= 2
    cells = [(x, z) for x in range(side) for z in range(side)]
    rng.shuffle(cells)
    width = SIZE / side
    for x, z in cells[:count]:
        yield int((x + rng.random()) * width), int((z + rng.random()) * width)


def turning(position, frames):
    """Events: the camera turns by a degree a frame, so that its clusters change."""
    return [{"frame": frame, "camera": {"name": "eye", "position": position, "yaw": 180 + frame % 30,
                                        "pitch": 12}} for frame in range(1, frames)]


def make_world(count, seed, frames):
    rng = random.Random(seed)
    houses = make_houses(rng)
    height = [[0] * SIZE for _ in range(SIZE)]
    for _, low, high in houses:
        for x in range(low[0], high[0] + 1):
            for z in range(low[2], high[2] + 1):
                height[x][z] = max(height[x][z], high[1])
    lamps = {state: [] for state in LAMPS}
    for number, (x, z) in enumerate(places(rng, count)):
        lamps[LAMPS[number % len(LAMPS)]].append([x, height[x][z] + 1, z])
    middle = SIZE / 2
    return {
        "name": f"lamp_field_{count}",
        "exercises": f"{count} lamps under an open night sky",
        "size": [SIZE, 16, SIZE],
        "blocks": [{"box": "stone_bricks", "min": [0, 0, 0], "max": [SIZE - 1, 0, SIZE - 1]}]
                  + [{"box": state, "min": low, "max": high} for state, low, high in houses]
                  + [{"block": state, "at": at} for state, at in lamps.items() if at],
        "cameras": [{"name": "eye", "position": [middle, 7, middle], "yaw": 180, "pitch": 12},
                    {"name": "low", "position": [middle, 2.6, middle], "yaw": 135, "pitch": 0}],
        "environment": {"time": 18000},
        "events": turning([middle, 7, middle], frames),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", type=int, help=f"lamps, 1 to {SIZE * SIZE}")
    parser.add_argument("folder", type=pathlib.Path, help="of the world")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--turn", type=int, default=0, metavar="FRAMES", help="turn the camera for so long")
    args = parser.parse_args()
    if not 1 <= args.count <= SIZE * SIZE:
        parser.error("count out of range")
    args.folder.mkdir(parents=True, exist_ok=True)
    (args.folder / "world.json").write_text(json.dumps(make_world(args.count, args.seed, args.turn)) + "\n")


if __name__ == "__main__":
    main()
