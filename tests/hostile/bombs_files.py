"""Folders, links, archives and pictures that are not what they seem."""

import os
import struct
import zipfile
import zlib

from hostile_files import BASE_ENTRIES, FRAGMENT, MAIN, HEAD, pack, properties, write, zipped


def link_tree(folder):
    pack(folder, {})
    names = [folder / "shaders" / f"f{i}" for i in range(27)]
    for i, name in enumerate(names):
        name.mkdir()
        if i > 0:
            for link in "ab":
                os.symlink(f"../f{i - 1}", name / link)
    return folder


def sparse_files(folder):
    pack(folder, {})
    for i in range(16):
        with open(folder / "shaders" / f"lib{i}.glsl", "wb") as file:
            file.truncate(63 << 20)
    return folder


def sparse_one(folder):
    pack(folder, {})
    with open(folder / "shaders" / "composite.fsh", "wb") as file:
        file.truncate(65 << 20)
    return folder


def deep_folders(folder):
    pack(folder, {})
    write(folder / "shaders" / ("d/" * 60) / "a.glsl", "")
    return folder


def folders_many(folder):
    pack(folder, {})
    for i in range(20_000):
        (folder / "shaders" / f"d{i}").mkdir()
    return folder


def files_many(folder):
    pack(folder, {})
    for i in range(70_000):
        (folder / "shaders" / f"f{i}").touch()
    return folder


def fifo(folder):
    pack(folder, {})
    os.remove(folder / "shaders" / "composite.fsh")
    os.mkfifo(folder / "shaders" / "composite.fsh")
    return folder


def link_to_itself(folder):
    pack(folder, {})
    os.symlink(".", folder / "shaders" / "again")
    return folder


def folder_as_program(folder):
    pack(folder, {})
    os.remove(folder / "shaders" / "composite.fsh")
    (folder / "shaders" / "composite.fsh").mkdir()
    return folder


def named_badly(folder):
    return pack(folder, {"a\n::stop-commands::x.glsl": MAIN, "\x1b[31m.glsl": MAIN, "a" * 200 + ".fsh": MAIN})


def zip_of(*entries, **options):
    return lambda folder: zipped(folder, BASE_ENTRIES + list(entries), **options)


def zip_encrypted(folder):
    target = zipped(folder, BASE_ENTRIES)
    raw = bytearray(target.read_bytes())
    for magic, flag in ((b"PK\3\4", 6), (b"PK\1\2", 8)):
        at = raw.find(magic)
        while at >= 0:
            raw[at + flag] |= 1
            at = raw.find(magic, at + 4)
    target.write_bytes(raw)
    return target


def zip_cut(folder):
    target = zipped(folder, BASE_ENTRIES)
    target.write_bytes(target.read_bytes()[:-30])
    return target


def zip_damaged(folder):
    target = zipped(folder, BASE_ENTRIES, compression=zipfile.ZIP_STORED)
    raw = target.read_bytes()
    target.write_bytes(raw.replace(b"gl_FragColor", b"gl_FragColoR", 1))
    return target


def png(width: int, height: int) -> bytes:
    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = zlib.compress(b"\0" * min(1 << 20, (width + 1) * height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", rows) + chunk(b"IEND", b""))


def pictures(count: int, width: int, height: int):
    def build(folder):
        text = "".join(f"customTexture.t{i}=t{i}.png\n" for i in range(count))
        uses = "".join(f"uniform sampler2D t{i};\n" for i in range(count))
        total = " + ".join(f"texture(t{i}, vec2(0))" for i in range(count))
        program = HEAD + uses + "void main() { gl_FragColor = " + total + "; }\n"
        files = {f"t{i}.png": png(width, height) for i in range(count)}
        return pack(folder, {"shaders.properties": text, "composite.fsh": program, **files})
    return build


BOMBS = {
    "links-2-27": lambda: (link_tree, None),
    "files-63-mb": lambda: (sparse_files, None),
    "file-65-mb": lambda: (sparse_one, "pack-too-large"),
    "folders-deep": lambda: (deep_folders, "pack-too-large"),
    "folders-20-000": lambda: (folders_many, "pack-too-large"),
    "files-70-000": lambda: (files_many, "pack-too-large"),
    "fifo": lambda: (fifo, None),
    "link-to-itself": lambda: (link_to_itself, None),
    "folder-as-program": lambda: (folder_as_program, "program-file-alone"),
    "names": lambda: (named_badly, None),
    "zip-newlines": lambda: (zip_of(*((f"shaders/lib{i}.glsl", b"\n" * (20 << 20)) for i in range(4))), None),
    "zip-newlines-used": lambda: (zip_of(*((f"shaders/lib{i}.glsl", b"\n" * (20 << 20)) for i in range(4)),
                                 ("shaders/final.fsh", HEAD + "".join(
                                     f'#include "/lib{i}.glsl"\n' for i in range(4)) + MAIN)),
                          "text-too-large"),
    "zip-zeros": lambda: (zip_of(("shaders/data.bin", b"\0" * (200 << 20))), "zip-unreadable"),
    "zip-30-files": lambda: (zip_of(*((f"shaders/d{i}.bin", b"\0" * (63 << 20)) for i in range(20))),
                     "pack-too-large"),
    "zip-encrypted": lambda: (zip_encrypted, "zip-unreadable"),
    "zip-lzma": lambda: (zip_of(compression=zipfile.ZIP_LZMA), "zip-unreadable"),
    "zip-twice": lambda: (zip_of(("shaders/composite.fsh", FRAGMENT)), "zip-unreadable"),
    "zip-cut": lambda: (zip_cut, "zip-unreadable"),
    "zip-damaged": lambda: (zip_damaged, "zip-unreadable"),
    "zip-names": lambda: (zip_of(*((f"shaders/{'a' * 60_000}{i}", b"") for i in range(20))), None),
    "zip-entries": lambda: (zip_of(*((f"shaders/f{i}", b"") for i in range(66_000))), "pack-too-large"),
    "zip-outside": lambda: (zip_of(("shaders/../../x.fsh", b""), ("/shaders/final.fsh", b""), ("..\\x", b"")), None),
    "picture-2-31": lambda: (pictures(1, 2_000_000_000, 2_000_000_000), None),
    "pictures-8192": lambda: (pictures(8, 8192, 8192), None),
    "picture-wide": lambda: (pictures(1, 1_000_000, 1), None),
    "language-of-folders": lambda: (lambda folder: pack(folder, {"lang/en_us.lang/x": ""}), None),
    "properties-folder": lambda: (lambda folder: pack(folder, {"shaders.properties/x": ""}), None),
    "short-texture": lambda: (properties("texture.composite.t=composite.fsh TEXTURE_2D RGBA8 4096 4096 RGBA "
                                 "UNSIGNED_BYTE\n"), "texture-short"),
}

# Those that take seconds to write or to read.
HEAVY = {"folders-20-000", "files-70-000", "zip-zeros", "zip-30-files", "zip-entries"}
