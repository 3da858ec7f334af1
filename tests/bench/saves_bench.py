#!/usr/bin/env python3
"""What a save costs by render distance: saves_bench.py ORRIS REGION [--radius N...] [--out PAGE]

REGION is a file r.X.Z.mca of a save. The largest rectangle of its finished chunks is repeated over as large a save as is
needed, in a temporary folder. Measured are `orris world` (reading, light, mesh) and `orris render --frames 1` with a pack:
passing time, processor time and the most memory that was resident. Boxes of stone beside them have many blocks and few faces.

>>> rectangle_of({(x, z): b"" for x in range(4) for z in range(3) if (x, z) != (0, 0)})
(1, 0, 3, 3)
"""
import argparse
import json
import os
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

SIDE = 32  # chunks along an edge of a region
SECTOR = 4096
MIDDLE = 8  # chunk, both ways


def chunks_of(region):
    """The finished chunks by place: their bytes as stored, with length and kind of compression."""
    data, found = region.read_bytes(), {}
    for index in range(SIDE * SIDE):
        place = int.from_bytes(data[index * 4:index * 4 + 3], "big") * SECTOR
        if place == 0:
            continue
        length = struct.unpack(">I", data[place:place + 4])[0]
        stored = data[place:place + 4 + length]
        tags = zlib.decompress(stored[5:])
        if b"\x08\x00\x06Status\x00\x04full" in tags or b"Status\x00\x0eminecraft:full" in tags:
            found[index % SIDE, index // SIDE] = stored
    return found


def rectangle_of(chunks):
    """The largest rectangle of finished chunks: x, z, width, depth."""
    best = (0, 0, 0, 0)
    for x, z in chunks:
        width, depth = 0, SIDE
        while (x + width, z) in chunks and depth > 0:
            rows = 0
            while rows < depth and (x + width, z + rows) in chunks:
                rows += 1
            width, depth = width + 1, rows
            if width * depth > best[2] * best[3]:
                best = (x, z, width, depth)
    return best


def write_save(folder, chunks, radius):
    """A folder of regions with every chunk within `radius` of MIDDLE."""
    x0, z0, width, depth = rectangle_of(chunks)
    regions = {}
    for z in range(MIDDLE - radius, MIDDLE + radius + 1):
        for x in range(MIDDLE - radius, MIDDLE + radius + 1):
            regions.setdefault((x // SIDE, z // SIDE), {})[x % SIDE, z % SIDE] = \
                chunks[x0 + x % width, z0 + z % depth]
    folder.mkdir(parents=True)
    for (rx, rz), held in regions.items():
        header, body = bytearray(2 * SECTOR), bytearray()
        for (x, z), stored in held.items():
            sectors = -(-len(stored) // SECTOR)
            at = 4 * (x + z * SIDE)
            header[at:at + 4] = (2 + len(body) // SECTOR).to_bytes(3, "big") + bytes([sectors])
            body += stored + bytes(sectors * SECTOR - len(stored))
        (folder / f"r.{rx}.{rz}.mca").write_bytes(header + body)


def run(command):
    """Passing seconds, processor seconds and most kilobytes resident of any one process of a command."""
    began = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    output = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = status
    if status != 0:
        sys.exit(f"{command}: status {status}")
    return time.monotonic() - began, used.ru_utime + used.ru_stime, used.ru_maxrss, output


def least(command, rounds):
    """The least of each figure over the rounds: what else the machine does only adds."""
    runs = [run(command) for _ in range(rounds)]
    return [min(row[i] for row in runs) for i in range(3)], runs[0][3]


def measure(args, name, world, words, folder):
    read, output = least([args.orris, "world", world, *words, "--json"], args.rounds)
    drawn, _ = least([args.orris, "render", args.pack, world, *words, "--frames", "1", "--memory-limit", "32G", "-o",
                      folder / "picture.png"], args.rounds)
    facts = json.loads(output)
    print(name, facts["faces"], read, drawn, flush=True)
    return {"name": name, "blocks": facts["blocks"], "faces": facts["faces"], "read": read, "drawn": drawn}


def stone(folder, height):
    """A world that is a box of stone."""
    size = [512, height, 512]
    world = {"size": size, "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [side - 1 for side in size]}],
             "cameras": [{"name": "above", "position": [256, height + 40, 540], "target": [256, height, 256]}]}
    folder = folder / f"stone{height}"
    folder.mkdir()
    (folder / "world.json").write_text(json.dumps(world))
    return folder


def page(rows, args, chunks):
    def line(row):
        (read, cpu, memory), (drawn, drawn_cpu, drawn_memory) = row["read"], row["drawn"]
        return (f"| {row['name']} | {row['blocks'] / 1e6:.2f} | {row['faces'] / 1e6:.3f} | {read:.1f} | {cpu:.1f} | "
                f"{memory * 1024 / 1e6:.0f} | {drawn:.1f} | {drawn_cpu:.1f} | {drawn_memory * 1024 / 1e6:.0f} |")

    x, z, width, depth = rectangle_of(chunks)
    words = " ".join(f"--radius {radius}" for radius in args.radius)
    def slope(few, many, column):
        return (many["drawn"][column] - few["drawn"][column]) / (many["faces"] - few["faces"])

    *saves, low, high = rows
    added, of_stone = (slope(few, many, 2) * 1024 for few, many in ((saves[0], saves[-1]), (low, high)))
    seconds = slope(saves[0], saves[-1], 1) * 1e6
    runs = f"The least of {args.rounds} runs" if args.rounds > 1 else "One run"
    return f"""# Saves over render distance

Time and memory of a save, by the chunks around the camera. Made by the command below, which writes this page; {args.note}
The save repeats {width}x{depth} finished chunks of a region of 1.18.2 from chunk ({x}, {z}) of it; boxes of stone stand
beside it, which have many blocks and few faces.

    tests/bench/saves_bench.py build/release/orris r.0.0.mca {words} --rounds {args.rounds} --out docs/results/saves.md

`orris world` reads, lights and meshes; `orris render --frames 1` with the reference pack at 640x360 does that, too, and draws
the first picture, with what it compiled kept by the driver. {runs}; seconds, processor seconds of all threads, and
the most megabytes (10^6 bytes) resident in one process.

| world | million blocks | million faces | world: s | processor s | MB | render: s | processor s | MB |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
{chr(10).join(line(row) for row in rows)}

From the smallest to the largest of these saves each face adds {added:.0f} bytes ({4 * 56} of them are its vertices in the driver, 28
the mesh) and {seconds:.1f} us of processor time. Eight times as much stone adds {of_stone:.0f} bytes for each
face that it has more: blocks inside of it add next to nothing, as sections of one state take no memory.
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("orris")
    parser.add_argument("region", type=Path)
    parser.add_argument("--radius", type=int, action="append", default=[])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--pack", default=str(Path(__file__).resolve().parents[2] / "shaderpack"))
    parser.add_argument("--note", default="commit and date are missing.")
    parser.add_argument("--out", type=Path)
    args = parser.parse_args()
    args.radius = args.radius or [8, 16, 32]
    chunks = chunks_of(args.region)
    with tempfile.TemporaryDirectory() as name:
        folder, rows = Path(name), []
        for radius in args.radius:
            save = folder / f"save{radius}"
            write_save(save / "region", chunks, radius)
            words = ["--at", f"{MIDDLE * 16 + 8},{MIDDLE * 16 + 8}", "--radius", str(radius)]
            rows.append(measure(args, f"save, radius {radius}", save / "region", words, folder))
        for height in (16, 128):
            rows.append(measure(args, f"stone, {height} high", stone(folder, height), [], folder))
        text = page(rows, args, chunks)
    if args.out:
        args.out.write_text(text)
    else:
        print(text)


if __name__ == "__main__":
    main()
