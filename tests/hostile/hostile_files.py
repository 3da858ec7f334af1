"""Helpers of the generators of hostile inputs: packs, worlds and archives written to a folder."""

import gzip
import json
import struct
import zipfile
from pathlib import Path

VERTEX = "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n"
HEAD = "#version 330 compatibility\n"
MAIN = "void main() { gl_FragColor = vec4(1.0); }\n"
FRAGMENT = HEAD + MAIN


def write(path: Path, data) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data if isinstance(data, bytes) else data.encode())


def pack(folder: Path, files: dict) -> Path:
    """A pack whose one program is there unless `files` (by path in shaders/) has another."""
    for name, data in {"composite.vsh": VERTEX, "composite.fsh": FRAGMENT, **files}.items():
        write(folder / "shaders" / name, data)
    return folder


def fragment(text):
    """A pack with this fragment shader, after the #version line."""
    return lambda folder: pack(folder, {"composite.fsh": HEAD + text})


def main_of(text):
    """A pack with this as the body of main()."""
    return fragment("void main() {\n" + text + "\n}\n")


def properties(text, **more):
    return lambda folder: pack(folder, {"shaders.properties": text, **more})


def zipped(folder: Path, entries: list, compression=zipfile.ZIP_DEFLATED) -> Path:
    """A zip of (name, bytes) in this order, names repeated where the list repeats them."""
    target = folder / "pack.zip"
    with zipfile.ZipFile(target, "w", compression) as archive:
        for name, data in entries:
            archive.writestr(name, data)
    return target


BASE_ENTRIES = [("shaders/composite.vsh", VERTEX), ("shaders/composite.fsh", FRAGMENT)]


def world(text):
    """A folder with this world.json; a dict is written as JSON."""
    def build(folder: Path) -> Path:
        write(folder / "world.json", text if isinstance(text, (str, bytes)) else json.dumps(text))
        return folder
    return build


def small_world(**more) -> dict:
    return {"name": "w", "size": [4, 4, 4], **more}


def huge_world(blocks) -> dict:
    return {"name": "w", "size": [512, 128, 512], "blocks": blocks}


class Nbt:
    """Tags of the game's binary format, named."""

    @staticmethod
    def name(kind: int, text: str) -> bytes:
        raw = text.encode()
        return struct.pack(">bH", kind, len(raw)) + raw

    @staticmethod
    def short(key, value):
        return Nbt.name(2, key) + struct.pack(">H", value & 0xFFFF)

    @staticmethod
    def integer(key, value):
        return Nbt.name(3, key) + struct.pack(">i", value)

    @staticmethod
    def data(key, raw, length=None):
        return Nbt.name(7, key) + struct.pack(">i", len(raw) if length is None else length) + raw

    @staticmethod
    def compound(key, *members):
        return Nbt.name(10, key) + b"".join(members) + b"\0"


def schematic(width=1, palette=None, blocks=b"\0", length=None, extra=b"", width_tag=None) -> bytes:
    entries = {"minecraft:stone": 0} if palette is None else palette
    return Nbt.compound(
        "Schematic", Nbt.integer("Version", 2),
        width_tag or Nbt.short("Width", width), Nbt.short("Height", 1), Nbt.short("Length", 1),
        Nbt.compound("Palette", *(Nbt.integer(k, v) for k, v in entries.items())),
        Nbt.data("BlockData", blocks, length), extra)


def schem(raw: bytes, compress=True):
    def build(folder: Path) -> Path:
        target = folder / "w.schem"
        write(target, gzip.compress(raw, mtime=0) if compress else raw)
        return target
    return build
