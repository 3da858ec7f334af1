"""Worlds and schematics that are large, nested or laborious."""

import json

from hostile_files import Nbt, huge_world, schem, schematic, small_world, world

N = 100_000
ALL = {"min": [0, 0, 0], "max": [511, 127, 511]}
VALUE, SYNTAX, WORK = "world-json-value", "world-json-syntax", "world-json-value"


def from_list(count: int):
    def build(folder):
        schem(schematic())(folder)
        return world(small_world(blocks=[{"from": "w.schem"}] * count))(folder)
    return build


def nbt_depth(depth: int) -> bytes:
    return Nbt.compound("Schematic", Nbt.name(10, "a") * depth + b"\0" * depth)


BOMBS = {
    "keys-20-000": lambda: (world('{"name":"w","size":[4,4,4],' + ",".join(f'"k{i}":1' for i in range(20_000)) + "}"),
                    VALUE),
    "keys-200-000": lambda: (world('{"name":"w","size":[4,4,4],' + ",".join(f'"k{i}":1' for i in range(2 * N)) + "}"),
                     VALUE),
    "keys-twice": lambda: (world("{" + '"a":1,' * N + '"a":1}'), SYNTAX),
    "keys-long": lambda: (world('{"' + "a" * 2_000_000 + '":1}'), VALUE),
    "arrays-nested": lambda: (world("[" * N), SYNTAX),
    "objects-nested": lambda: (world('{"a":' * N), SYNTAX),
    "array-long": lambda: (world("[" + "1," * 1_000_000 + "1]"), SYNTAX),
    "palette-many": lambda: (world(small_world(palette={f"k{i}": "stone" for i in range(50_000)})), VALUE),
    "palette-of-nothing": lambda: (world(small_world(palette={chr(33 + i): "?" for i in range(90)})), VALUE),
    "fills-10-5": lambda: (world(huge_world([{"box": "stone", **ALL}] * N)), SYNTAX),
    "fills-100": lambda: (world(huge_world([{"box": "stone", **ALL}] * 100)), WORK),
    "hollows-many": lambda: (world(huge_world([{"hollow": "stone", **ALL}] * 20_000)), WORK),
    "replaces-many": lambda: (world(huge_world([{"replace": "air", "with": "stone"}] * 1000)), WORK),
    "generators-1000": lambda: (world(huge_world([{"generate": {"terrain": {}}}] * 1000)), WORK),
    "files-1000": lambda: (from_list(100_000), WORK),
    "operations-unknown": lambda: (world(small_world(blocks=[{"frob": 1}] * 20_000)), VALUE),
    "operations-of-numbers": lambda: (world(small_world(blocks=list(range(20_000)))), VALUE),
    "positions-outside": lambda: (world(small_world(blocks=[{"block": "stone", "at": [[9, 9, 9]] * N}])), VALUE),
    "states-many": lambda: (world(small_world(blocks=[{"block": f"b{i}", "at": [0, 0, 0]} for i in range(20_000)])),
                    None),
    "state-long": lambda: (world(small_world(blocks=[{"block": "b" * 1_000_000, "at": [0, 0, 0]}])), None),
    "row-long": lambda: (world(small_world(blocks=[{"layers": [["." * 2_000_000]]}])), VALUE),
    "rows-outside": lambda: (world(small_world(blocks=[{"layers": [["....."] * N]}])), VALUE),
    "rows-unknown": lambda: (world(small_world(blocks=[{"layers": [["x..."] * 4] * 4}] * 5_000)), VALUE),
    "cameras-many": lambda: (world(small_world(cameras=[{"name": f"c{i}", "position": [0, 0, 0]}
                                                for i in range(20_000)])), None),
    "cameras-same": lambda: (world(small_world(cameras=[{"name": "c", "position": [0, 0, 0]}] * 20_000)), VALUE),
    "cameras-by-name": lambda: (world(small_world(
        cameras=[{"name": f"c{i}", "position": [0, 0, 0]} for i in range(10_000)],
        events=[{"frame": 1, "camera": "c9999"}] * 20_000)), None),
    "events-many": lambda: (world(small_world(events=[{"frame": i, "time": 1} for i in range(N)])), None),
    "events-wrong": lambda: (world(small_world(events=[{"frame": -1}] * N)), VALUE),
    "size-huge": lambda: (world({"name": "w", "size": [99999, 99999, 99999]}), VALUE),
    "size-512": lambda: (world(huge_world([])), None),
    "size-negative": lambda: (world({"name": "w", "size": [-1, 4, 4]}), VALUE),
    "number-huge": lambda: (world('{"name":"w","size":[1e400,4,4]}'), None),
    "number-digits": lambda: (world('{"name":"w","size":[' + "9" * 1_000_000 + ",4,4]}"), None),
    "string-open": lambda: (world('{"name":"' + "a" * 2_000_000), SYNTAX),
    "not-json": lambda: (world("\n" * 1_000_000 + "x"), SYNTAX),
    "empty": lambda: (world(""), SYNTAX),
    "bytes": lambda: (world(bytes(range(256)) * 4_000), SYNTAX),
    "utf16": lambda: (world(json.dumps(small_world()).encode("utf-16")), "world-unreadable"),
    "schematic-gzip-bomb": lambda: (schem(b"\0" * 400_000_000), "schematic-invalid"),
    "schematic-bytes": lambda: (schem(bytes(range(256)) * 4_000), "schematic-invalid"),
    "schematic-plain": lambda: (schem(b"x" * 1_000_000, compress=False), "schematic-invalid"),
    "schematic-cut": lambda: (schem(schematic()[:40]), "schematic-invalid"),
    "schematic-empty-palette": lambda: (schem(schematic(palette={})), "schematic-invalid"),
    "schematic-width-0x10001": lambda: (schem(schematic(width_tag=Nbt.integer("Width", 0x10001))),
                                "schematic-invalid"),
    "schematic-width-0": lambda: (schem(schematic(width=0)), "schematic-invalid"),
    "schematic-negative-length": lambda: (schem(schematic(length=-1)), "schematic-invalid"),
    "schematic-length-beyond": lambda: (schem(schematic(length=2_000_000_000)), "schematic-invalid"),
    "schematic-depth": lambda: (schem(nbt_depth(N)), "schematic-invalid"),
    "schematic-palette-many": lambda: (schem(schematic(palette={f"b{i}": i for i in range(80_000)})),
                               "schematic-invalid"),
    "schematic-members": lambda: (schem(schematic(extra=b"".join(Nbt.short(f"m{i}", 1) for i in range(N)))), None),
    "schematic-members-many": lambda: (schem(schematic(extra=Nbt.short("m", 1) * 1_200_000)), "schematic-invalid"),
    "schematic-varint": lambda: (schem(schematic(blocks=b"\xff" * 10)), "schematic-invalid"),
}

# Those that take seconds to write or to read.
HEAVY = {"size-512", "schematic-gzip-bomb"}
