"""Renders an export of `orris world --export` by Cycles. Run by cycles_compare.py inside Blender:

    blender -b -noaudio --factory-startup -P cycles_render.py -- JOB.json

JOB.json: {"scene": FILE, "camera": NAME, "size": [W, H], "threads": N, "physical": BOOL,
           "renders": [{"out": FILE, "samples": N, "seed": N, "sun_only": BOOL}, ...]}

Geometry, textures, cameras and the sun come from Blender's own importer of glTF. Its general material is no Lambert
reflector, so that each gets the nodes of what its `extras` say. With "physical" lamps light as they are drawn.
"""
import json
import struct
import sys
from math import pi
from pathlib import Path

import bpy
import numpy as np

# Blender 3.4's importer names an alias that numpy 1.24 has no more.
np.bool = bool

WHITE = (1, 1, 1, 1)


def read_glb(path):
    """The JSON of a binary glTF file, and its buffer."""
    data = Path(path).read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[20 + length + 8:]


class Nodes:
    """A node tree under construction."""

    def __init__(self, tree):
        self.tree = tree
        tree.nodes.clear()

    def add(self, kind, inputs=(), **settings):
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        for name, value in dict(inputs).items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, node.inputs[name])
            else:
                node.inputs[name].default_value = value
        return node

    def math(self, operation, a, b):
        return self.add("ShaderNodeMath", {0: a, 1: b}, operation=operation).outputs[0]

    def mix_color(self, kind, a, b, share=1.0):
        return self.add("ShaderNodeMixRGB", {"Fac": share, "Color1": a, "Color2": b}, blend_type=kind).outputs[0]

    def mix_shader(self, share, a, b):
        return self.add("ShaderNodeMixShader", {0: share, 1: a, 2: b}).outputs[0]

    def sum(self, a, b):
        return self.add("ShaderNodeAddShader", {0: a, 1: b}).outputs[0]


def linear(color):
    return (*color, 1.0)


def shade(material, facts, physical):
    """Gives an imported material the reflector that its extras describe."""
    extras = material["orris"]
    tree = material.node_tree
    image = next(node.image for node in tree.nodes if node.type == "TEX_IMAGE")
    tinted = next((node.layer_name for node in tree.nodes if node.type == "VERTEX_COLOR"), None)
    nodes = Nodes(tree)
    texture = nodes.add("ShaderNodeTexImage", image=image, interpolation="Closest", extension="EXTEND")
    color = texture.outputs["Color"]
    if tinted is not None:
        tint = nodes.add("ShaderNodeVertexColor", layer_name=tinted)
        color = nodes.mix_color("MULTIPLY", color, tint.outputs["Color"])
    path = nodes.add("ShaderNodeLightPath")
    camera = path.outputs["Is Camera Ray"]
    shader = nodes.add("ShaderNodeBsdfDiffuse", {"Color": color, "Roughness": 0}).outputs[0]
    if extras.get("thin"):
        left = nodes.mix_color("SUBTRACT", WHITE, color)
        passed = nodes.mix_color("DARKEN", color, left)
        shader = nodes.sum(shader, nodes.add("ShaderNodeBsdfTranslucent", {"Color": passed}).outputs[0])
    if "emissiveFactor" in facts:
        shader = nodes.sum(shader, emission(nodes, color, camera, facts, extras, physical))
    if facts["alphaMode"] == "MASK":
        solid = nodes.math("GREATER_THAN", texture.outputs["Alpha"], facts["alphaCutoff"] - 1e-4)
        shader = nodes.mix_shader(solid, nodes.add("ShaderNodeBsdfTransparent").outputs[0], shader)
    elif facts["alphaMode"] == "BLEND":
        shader = blended(nodes, texture, shader, camera, extras)
    output = nodes.add("ShaderNodeOutputMaterial")
    tree.links.new(shader, output.inputs["Surface"])


def emission(nodes, color, camera, facts, extras, physical):
    """The camera sees the texture; other surfaces get the listed radiance. Fronts only."""
    strength = facts["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
    tint = linear(facts["emissiveFactor"])
    drawn = nodes.mix_color("MULTIPLY", nodes.mix_color("MULTIPLY", color, tint), (strength,) * 3 + (1,))
    radiance = linear(extras.get("radiance", (0, 0, 0)))
    seen = drawn if physical else nodes.mix_color("MIX", radiance, drawn, camera)
    if not facts["doubleSided"]:
        back = nodes.add("ShaderNodeNewGeometry").outputs["Backfacing"]
        seen = nodes.mix_color("MIX", seen, (0, 0, 0, 1), back)
    return nodes.add("ShaderNodeEmission", {"Color": seen, "Strength": 1}).outputs[0]


def blended(nodes, texture, shader, camera, extras):
    """Seen by its alpha; other rays pass, and one face takes half of what a block's depth does."""
    passed = WHITE
    if "filterColor" in extras:
        passed = linear([value ** 0.5 for value in extras["filterColor"]])
    elif extras.get("filter") == "face":
        passed = texture.outputs["Color"]
    tinted = nodes.add("ShaderNodeBsdfTransparent", {"Color": passed}).outputs[0]
    clear = nodes.add("ShaderNodeBsdfTransparent").outputs[0]
    return nodes.mix_shader(camera, tinted, nodes.mix_shader(texture.outputs["Alpha"], clear, shader))


def set_sky(document, binary):
    """The environment picture, from the table of the export: u is the turn, v the height."""
    sky = document["scenes"][0]["extras"]["orris"]["sky"]
    view = document["bufferViews"][document["accessors"][sky["accessor"]]["bufferView"]]
    rows, columns = sky["rows"], sky["columns"]
    table = np.frombuffer(binary, "<f4", rows * columns * 3, view["byteOffset"]).reshape(rows, columns, 3)
    width, height = 1024, 720
    # Blender's rows begin at the nadir; its turn begins half a circle away.
    row = np.clip((height - 0.5 - np.arange(height)) / height * rows - 0.5, 0, rows - 1)
    column = ((np.arange(width) + 0.5) / width - 0.5) * columns - 0.5
    low, down = np.floor(row).astype(int), (row % 1)[:, None, None]
    left, right = np.floor(column).astype(int), (column % 1)[None, :, None]

    def at(r, c):
        return table[np.clip(r, 0, rows - 1)[:, None], (c % columns)[None, :]]

    mixed = ((at(low, left) * (1 - right) + at(low, left + 1) * right) * (1 - down)
             + (at(low + 1, left) * (1 - right) + at(low + 1, left + 1) * right) * down)
    image = bpy.data.images.new("sky", width, height, float_buffer=True, alpha=False, is_data=True)
    image.pixels.foreach_set(np.concatenate([mixed, np.ones((height, width, 1))], 2).astype("f4").ravel())
    image.pack()
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes = Nodes(world.node_tree)
    picture = nodes.add("ShaderNodeTexEnvironment", image=image)
    background = nodes.add("ShaderNodeBackground", {"Color": picture.outputs["Color"]})
    nodes.add("ShaderNodeOutputWorld", {"Surface": background.outputs[0]})
    return background


def place_balls(document):
    """Small lamps: balls that give light, stop none and are not seen."""
    lights = document.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    for node in document.get("nodes", []):
        index = node.get("extensions", {}).get("KHR_lights_punctual", {}).get("light")
        if index is None or lights[index]["type"] != "point":
            continue
        light = lights[index]
        x, y, z = node["translation"]
        radius = light["extras"]["orris"]["radius"]
        bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=radius, location=(x, -z, y))
        ball = bpy.context.object
        ball.visible_camera = ball.visible_shadow = False
        material = bpy.data.materials.new("ball")
        material.use_nodes = True
        nodes = Nodes(material.node_tree)
        value = light["intensity"] / (pi * radius ** 2)
        back = nodes.add("ShaderNodeNewGeometry").outputs["Backfacing"]
        color = nodes.mix_color("MIX", linear([value * c for c in light["color"]]), (0, 0, 0, 1), back)
        glow = nodes.add("ShaderNodeEmission", {"Color": color, "Strength": 1}).outputs[0]
        both = nodes.sum(glow, nodes.add("ShaderNodeBsdfTransparent").outputs[0])
        nodes.add("ShaderNodeOutputMaterial", {"Surface": both})
        ball.data.materials.append(material)
    for thing in [one for one in bpy.data.objects if one.type == "LIGHT" and one.data.type == "POINT"]:
        bpy.data.objects.remove(thing)


def set_cycles(job):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = job["size"]
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", job["threads"]
    scene.camera = next(one for one in bpy.data.objects if one.type == "CAMERA" and one.name == job["camera"])
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_auto_tile = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = 0
    cycles.blur_glossy = 0
    cycles.transparent_max_bounces = 256
    # One ray through about the middle of each pixel.
    cycles.pixel_filter_type, cycles.filter_width = "GAUSSIAN", 0.01
    layer = bpy.context.view_layer
    layer.use_pass_normal = layer.use_pass_position = layer.use_pass_diffuse_color = True
    layer.use_pass_emit = True
    settings = scene.render.image_settings
    settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR_MULTILAYER", "32", "ZIP"


def render(one, background):
    scene = bpy.context.scene
    cycles = scene.cycles
    bounces = 0 if one["sun_only"] else 1024
    cycles.max_bounces = cycles.diffuse_bounces = cycles.transmission_bounces = bounces
    cycles.glossy_bounces = 0
    cycles.samples, cycles.seed = one["samples"], one["seed"]
    if one["sun_only"]:
        background.inputs["Strength"].default_value = 0
        for material in bpy.data.materials:
            for node in material.node_tree.nodes if material.use_nodes else []:
                if node.type == "EMISSION":
                    node.inputs["Strength"].default_value = 0
    scene.render.filepath = one["out"]
    bpy.ops.render.render(write_still=True)


def main():
    job = json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    # COMPAT: lights and emission in one unit.
    bpy.ops.import_scene.gltf(filepath=job["scene"], convert_lighting_mode="COMPAT")
    document, binary = read_glb(job["scene"])
    for light in bpy.data.lights:
        if light.type == "SUN":
            light.angle = 0
    for thing in [one for one in bpy.data.objects if one.type == "MESH"]:
        for slot, primitive in zip(thing.material_slots, document["meshes"][0]["primitives"], strict=True):
            shade(slot.material, document["materials"][primitive["material"]], job["physical"])
    place_balls(document)
    background = set_sky(document, binary)
    set_cycles(job)
    for one in job["renders"]:
        render(one, background)
    print("CYCLES DONE")


main()
