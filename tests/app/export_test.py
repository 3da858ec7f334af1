#!/usr/bin/env python3
"""export_test.py PROGRAM: `orris world --export` read back as glTF 2.0: faces, materials, lights, sky, cameras."""
import base64
import json
import math
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

PROGRAM = sys.argv[1]
FLOAT, WORD, NEAREST = 5126, 5125, 9728
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}
STATES = {"grass_block": (9, 4, 9), "glass": (2, 1, 2), "red_stained_glass": (4, 1, 2), "oak_leaves": (6, 1, 2),
          "glowstone": (8, 1, 2), "torch": (10, 1, 2), "short_grass": (2, 1, 6), "fire": (6, 1, 6)}
CAMERAS = [{"name": "east", "position": [1.5, 3.25, 4], "yaw": -90, "pitch": 0, "fov": 60},
           {"name": "down", "position": [6, 9, 6], "yaw": 30, "pitch": 50, "fov": 90}]


def export(folder, world, *flags, out="out.glb"):
    (folder / "world.json").write_text(json.dumps(world))
    subprocess.run([PROGRAM, "world", folder, "--export", folder / out, *flags], check=True, stdout=subprocess.DEVNULL)
    return (folder / out).read_bytes()


def split(data):
    """JSON and buffer of a binary file, whose lengths must hold."""
    magic, version, length, json_length, json_kind = struct.unpack_from("<4sIIII", data)
    assert (magic, version, json_kind) == (b"glTF", 2, 0x4E4F534A) and length == len(data)
    binary_length, binary_kind = struct.unpack_from("<II", data, 20 + json_length)
    assert json_length % 4 == 0 and binary_kind == 0x004E4942
    assert 28 + json_length + binary_length == len(data)
    document = json.loads(data[20:20 + json_length])
    assert document["buffers"] == [{"byteLength": binary_length}]
    return document, data[28 + json_length:]


def values(document, binary, index):
    """An accessor's elements."""
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    width = WIDTHS[accessor["type"]]
    size = accessor["count"] * width
    assert view["byteOffset"] % 4 == 0 and view["byteLength"] == 4 * size
    assert view["byteOffset"] + view["byteLength"] <= len(binary)
    code = {FLOAT: "f", WORD: "I"}[accessor["componentType"]]
    flat = struct.unpack_from(f"<{size}{code}", binary, view["byteOffset"])
    found = [flat[i:i + width] for i in range(0, size, width)]
    if "min" in accessor:
        assert all(abs(accessor["min"][c] - min(v[c] for v in found)) < 1e-6 for c in range(width))
        assert all(abs(accessor["max"][c] - max(v[c] for v in found)) < 1e-6 for c in range(width))
    return found


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def near(a, b, limit=1e-5):
    return all(abs(p - q) <= limit for p, q in zip(a, b, strict=True))


def turned(q, v):
    u, w = q[:3], q[3]
    t = tuple(2 * c for c in cross(u, v))
    return tuple(v[i] + w * t[i] + cross(u, t)[i] for i in range(3))


def check_faces(document, binary):
    """Triangles wind about their normals; every place of a texture is in the picture. Triangles by state."""
    triangles = {}
    for primitive in document["meshes"][0]["primitives"]:
        named = {name: values(document, binary, index) for name, index in primitive["attributes"].items()}
        indices = [one for one, in values(document, binary, primitive["indices"])]
        counts = {len(list_) for list_ in named.values()}
        assert len(counts) == 1 and max(indices) == counts.pop() - 1
        for i in range(0, len(indices), 3):
            a, b, c = (named["POSITION"][k] for k in indices[i:i + 3])
            normal = named["NORMAL"][indices[i]]
            assert abs(dot(normal, normal) - 1) < 1e-5
            assert dot(cross(minus(b, a), minus(c, a)), normal) > 0, "a triangle is turned inside out"
        assert all(0 <= u <= 1 and 0 <= v <= 1 for u, v in named["TEXCOORD_0"])
        state = document["materials"][primitive["material"]]["extras"]["orris"]["state"]
        triangles[state] = triangles.get(state, 0) + len(indices) // 3
    return triangles


def check_cube(folder):
    """A stone in the middle of nothing: 12 triangles that close, in their place."""
    document, binary = split(export(folder, {"size": [9, 9, 9], "blocks": [{"block": "stone", "at": [3, 5, 7]}],
                                             "cameras": CAMERAS}))
    assert check_faces(document, binary) == {"minecraft:stone": 12}
    primitive = document["meshes"][0]["primitives"][0]
    points = values(document, binary, primitive["attributes"]["POSITION"])
    node = next(node for node in document["nodes"] if node.get("mesh") == 0)
    places = [tuple(p + o for p, o in zip(point, node["translation"])) for point in points]
    assert {min(p) for p in zip(*places)} == {3, 5, 7} and [max(p) for p in zip(*places)] == [4, 6, 8]
    indices = [one for one, in values(document, binary, primitive["indices"])]
    corners = [places[i] for i in indices]
    volume = sum(dot(corners[i], cross(corners[i + 1], corners[i + 2])) / 6 for i in range(0, 36, 3))
    assert abs(volume - 1) < 1e-4, f"the cube holds {volume}"
    return document, binary


def check_atlas(document, binary):
    """The picture is a PNG of 16 bits a channel, read without a filter."""
    assert document["samplers"][0]["magFilter"] == document["samplers"][0]["minFilter"] == NEAREST
    view = document["bufferViews"][document["images"][0]["bufferView"]]
    png = binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and document["images"][0]["mimeType"] == "image/png"
    width, height, bits, color = struct.unpack_from(">IIBB", png, 16)
    assert (bits, color) == (16, 6)
    data, at = b"", 8
    while at < len(png):
        length, kind = struct.unpack_from(">I4s", png, at)
        data += png[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    assert len(zlib.decompress(data)) == height * (1 + 8 * width)


def check_cameras(document):
    nodes = {node["name"]: node for node in document["nodes"] if "camera" in node}
    assert list(nodes) == ["east", "down"]
    for camera in CAMERAS:
        node = nodes[camera["name"]]
        assert near(node["translation"], camera["position"])
        perspective = document["cameras"][node["camera"]]["perspective"]
        assert abs(math.degrees(perspective["yfov"]) - camera["fov"]) < 1e-3
        yaw, pitch = math.radians(camera["yaw"]), math.radians(camera["pitch"])
        # As in the game: yaw 0 looks south, 90 west; pitch 90 down.
        ahead = (-math.sin(yaw) * math.cos(pitch), -math.sin(pitch), math.cos(yaw) * math.cos(pitch))
        assert near(turned(node["rotation"], (0, 0, -1)), ahead), camera["name"]
        assert turned(node["rotation"], (0, 1, 0))[1] > 0 and abs(turned(node["rotation"], (1, 0, 0))[1]) < 1e-5


def mixed_world(time=3000):
    blocks = [{"box": "dirt", "min": [0, 0, 0], "max": [11, 0, 11]}]
    blocks += [{"block": state, "at": at} for state, at in STATES.items()]
    return {"size": [12, 10, 12], "blocks": blocks, "cameras": CAMERAS, "environment": {"time": time}}


def by_state(document):
    found = {}
    for material in document["materials"]:
        name = material["extras"]["orris"]["state"].removeprefix("minecraft:").split("[")[0]
        found.setdefault(name, []).append(material)
    return found


def check_materials(document, binary):
    triangles = check_faces(document, binary)
    assert all(any(state.startswith(f"minecraft:{name}") for state in triangles) for name in STATES), triangles
    materials = by_state(document)
    for material in document["materials"]:
        assert material["extensions"]["KHR_materials_specular"]["specularFactor"] == 0
        assert material["pbrMetallicRoughness"]["metallicFactor"] == 0
    assert materials["glass"][0]["alphaMode"] == "MASK" and abs(materials["glass"][0]["alphaCutoff"] - 0.1) < 1e-6
    stained = materials["red_stained_glass"][0]
    assert stained["alphaMode"] == "BLEND" and stained["extras"]["orris"]["filter"] == "depth"
    red, green, _ = stained["extras"]["orris"]["filterColor"]
    assert 0 < green < red < 1
    assert materials["oak_leaves"][0]["extras"]["orris"]["thin"]
    assert "thin" not in materials["dirt"][0]["extras"]["orris"]
    assert materials["dirt"][0]["alphaMode"] == "OPAQUE" and not materials["dirt"][0]["doubleSided"]
    # A cross of two planes, seen from both sides: 4 quads in the frame, 2 here.
    assert materials["short_grass"][0]["doubleSided"] and triangles["minecraft:short_grass"] == 4
    grass = [one for one in document["meshes"][0]["primitives"]
             if "grass" in document["materials"][one["material"]]["name"] and "COLOR_0" in one["attributes"]]
    assert grass and any(tint != (1, 1, 1) for tint in values(document, binary, grass[0]["attributes"]["COLOR_0"]))


def check_lamps(document):
    materials = by_state(document)
    glow = materials["glowstone"][0]
    strength = glow["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
    assert strength > 0 and glow["extras"]["orris"]["lightLevel"] == 15
    assert max(glow["extras"]["orris"]["radiance"]) > 0 and glow["emissiveTexture"]["index"] == 0
    assert "emissiveTexture" not in materials["dirt"][0]
    lights = document["extensions"]["KHR_lights_punctual"]["lights"]
    node = {one["name"]: one for one in document["nodes"]}["lamp"]
    torch = lights[node["extensions"]["KHR_lights_punctual"]["light"]]
    assert torch["type"] == "point" and near(node["translation"], [v + 0.5 for v in STATES["torch"]])
    # A ball of radius 1/4 that is five times as bright as a lamp's face at that level.
    radius = torch["extras"]["orris"]["radius"]
    level = materials["torch"][0]["extras"]["orris"]["lightLevel"]
    face = materials["torch"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
    assert radius == 0.25 and level == 14
    assert abs(torch["intensity"] / (5 * face * math.pi * radius ** 2) - 1) < 1e-4


def sun_of(document):
    light = document["extensions"]["KHR_lights_punctual"]["lights"][0]
    node = {one["name"]: one for one in document["nodes"]}["sun or moon"]
    assert light["type"] == "directional"
    return light, turned(node["rotation"], (0, 0, 1))


def check_sky(folder, document, binary):
    light, to_sun = sun_of(document)
    # 3000: the sun has come an eighth of its circle up in the east.
    assert to_sun[0] > 0.4 and to_sun[1] > 0.4 and max(light["color"]) == 1
    sky = document["scenes"][0]["extras"]["orris"]["sky"]
    table = values(document, binary, sky["accessor"])
    assert len(table) == sky["rows"] * sky["columns"]
    zenith, horizon, ground = (table[row * sky["columns"]] for row in (0, sky["rows"] // 2 - 1, sky["rows"] - 1))
    assert zenith[2] > zenith[0] and horizon[0] > zenith[0] and sum(ground) < 0.5 * sum(horizon)
    night, _ = split(export(folder, mixed_world(), "--time", "18000"))
    assert sun_of(night)[0]["intensity"] < 0.1 * light["intensity"]
    double, _ = split(export(folder, mixed_world(), "--set", "SUN_STRENGTH=8.0"))
    single, _ = split(export(folder, mixed_world(), "--set", "SUN_STRENGTH=4.0"))
    assert abs(sun_of(double)[0]["intensity"] / sun_of(single)[0]["intensity"] - 2) < 1e-5


def main():
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        document, binary = check_cube(folder)
        check_atlas(document, binary)
        check_cameras(document)
        first = export(folder, mixed_world())
        assert first == export(folder, mixed_world()), "the bytes of two runs differ"
        document, binary = split(first)
        check_materials(document, binary)
        check_lamps(document)
        check_sky(folder, document, binary)
        text = json.loads(export(folder, mixed_world(), out="out.gltf"))
        uri = text["buffers"][0].pop("uri")
        assert base64.b64decode(uri.removeprefix("data:application/octet-stream;base64,"), validate=True) == binary
        assert text == document
        empty, _ = split(export(folder, {"size": [2, 2, 2]}))
        assert "meshes" not in empty and [] not in empty.values()


main()
