"""OpenEXR files as rows of numbers, without a library."""
import struct
import zlib


def read_exr(path):
    """Width, height, and the float rows of each channel, of a file with scan lines, ZIP or none."""
    data, at, head = path.read_bytes(), 8, {}
    while data[at]:
        name_end = data.index(0, at)
        kind_end = data.index(0, name_end + 1)
        size = struct.unpack_from("<i", data, kind_end + 1)[0]
        head[data[at:name_end].decode()] = data[kind_end + 5:kind_end + 5 + size]
        at = kind_end + 5 + size
    at += 1
    x0, y0, x1, y1 = struct.unpack("<4i", head["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    names, place = [], 0
    while head["channels"][place]:
        end = head["channels"].index(0, place)
        names.append(head["channels"][place:end].decode())
        assert struct.unpack_from("<i", head["channels"], end + 1)[0] == 2, "no float channel"
        place = end + 17
    lines = {0: 1, 2: 1, 3: 16}[head["compression"][0]]
    planes = {name: [] for name in names}
    chunks = -(-height // lines)
    for offset in struct.unpack_from(f"<{chunks}Q", data, at):
        line, size = struct.unpack_from("<ii", data, offset)
        rows = min(lines, height - (line - y0))
        raw, plain = data[offset + 8:offset + 8 + size], rows * width * 4 * len(names)
        if size != plain:
            packed = bytearray(zlib.decompress(raw))
            for i in range(1, len(packed)):
                packed[i] = (packed[i - 1] + packed[i] - 128) & 255
            half = (len(packed) + 1) // 2
            raw = bytearray(len(packed))
            raw[0::2], raw[1::2] = packed[:half], packed[half:]
        for row in range(rows):
            for index, name in enumerate(names):
                start = (row * len(names) + index) * width * 4
                planes[name].append(struct.unpack_from(f"<{width}f", raw, start))
    return width, height, planes
