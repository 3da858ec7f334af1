#!/usr/bin/env python3
"""Renders a picture through liborris.so, with nothing but Python: picture.py LIBRARY PACK WORLD OUT.png [FRAMES]
Packs whose exposure adapts need some dozens of frames."""
import ctypes as c
import struct
import sys
import zlib

WIDTH, HEIGHT = 160, 90


class Request(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("width", c.c_int32), ("height", c.c_int32),
                ("pack", c.c_char_p), ("world", c.c_char_p), ("dimension", c.c_char_p),
                ("profile", c.c_char_p), ("options", c.POINTER(c.c_char_p)),
                ("option_count", c.c_uint32), ("kinds", c.c_uint32), ("seed", c.c_uint32),
                ("on_diagnostic", c.c_void_p), ("user", c.c_void_p)]


def load(path):
    orris = c.CDLL(path)
    orris.orris_last_error.restype = c.c_char_p
    if orris.orris_api_version() != 1:
        sys.exit("another version of liborris.so")
    return orris


def must(orris, status):
    if status != 0:
        sys.exit(f"status {status}: {orris.orris_last_error().decode()}")


def render(orris, pack, world, frames):
    """The pixels of the last frame, RGBA, top row first."""
    context, renderer = c.c_void_p(), c.c_void_p()
    request = Request()
    orris.orris_renderer_request_init(c.byref(request), c.c_size_t(c.sizeof(request)))
    request.width, request.height = WIDTH, HEIGHT
    request.pack, request.world = pack.encode(), world.encode()
    pixels = c.create_string_buffer(WIDTH * HEIGHT * 4)
    must(orris, orris.orris_context_create(b"auto", c.byref(context)))
    must(orris, orris.orris_renderer_create(context, c.byref(request), c.byref(renderer)))
    for _ in range(frames):
        must(orris, orris.orris_renderer_draw_frame(renderer, None))
    must(orris, orris.orris_renderer_read(renderer, pixels, c.c_size_t(len(pixels.raw))))
    must(orris, orris.orris_renderer_destroy(renderer))
    must(orris, orris.orris_context_destroy(context))
    return pixels.raw


def write_png(path, rgba):
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    rows = b"".join(b"\0" + rgba[y * WIDTH * 4:(y + 1) * WIDTH * 4] for y in range(HEIGHT))
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 6, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    if len(sys.argv) not in (5, 6):
        sys.exit(__doc__)
    count = int(sys.argv[5]) if len(sys.argv) == 6 else 1
    write_png(sys.argv[4], render(load(sys.argv[1]), *sys.argv[2:4], count))
