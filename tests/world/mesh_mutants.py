"""Mistakes put into meshes and resource packs, and the tests of test_world that must find them.

For tests/stability/host_kill_list.py --table, by file: name, tests, what is replaced by what.
"""

MUTANTS = {
    "loader/world/mesh/block_mesh.cpp": [
        ("faces: all have the first shape", "BlockMesh.*", "shapes[face.shape]", "shapes[0]"),
        ("faces: the cell of the face is lost", "BlockMesh.*", "glm::vec3(face.cell) + shape.corners[i]", "shape.corners[i]"),
        ("faces: one corner's light for all", "BlockMesh.*", "face.light[i],", "face.light[0],"),
        ("faces: one corner's occlusion for all", "BlockMesh.*",
         "glm::u8vec4(face.tint, face.occlusion[i])", "glm::u8vec4(face.tint, face.occlusion[0])"),
        ("faces: nothing emits", "BlockMesh.*",
         "glm::i8vec4(shape.toMiddle[i], face.emission)", "glm::i8vec4(shape.toMiddle[i], 0)"),
        ("faces: no fluid", "BlockMesh.*", "std::uint8_t(fluid ? 1 : 0)", "std::uint8_t(0)"),
        ("flow: upwards", "flowing_water.*", "fall = state.height - beside.height;", "fall = beside.height - state.height;"),
        ("flow: not over an edge", "flowing_water.*", "fall = state.height - (under.height - kSource);", "fall = 0;"),
        ("flow: the surface stays still", "flowing_water.*", "if (!surface || !heading) addFace", "if (true) addFace"),
    ],
    "loader/world/mesh/mesh_states.cpp": [
        ("faces: the middle is that of the face", "BlockMesh.*",
         "(glm::vec3(0.5f) - face.corners[i]) * 64.0f", "(face.corners[0] - face.corners[i]) * 64.0f"),
    ],
    "loader/world/atlas/tile_animation.cpp": [
        ("animation: the next frame is the same", "tile_animation.*",
         "animation.steps[(i + 1) % animation.steps.size()].frame", "step.frame"),
        ("animation: every step is a tick", "tile_animation.*", "period += step.ticks", "period += 1"),
        ("animation: never begins again", "tile_animation.*", "tick %= period;", "tick = tick < period ? tick : 0;"),
        ("animation: transparency is mixed too", "tile_animation.*", "if (i % 4 == 3) continue;", ""),
    ],
    "loader/world/resources/texture_meta.cpp": [
        ("animation: frametime is not read", "tile_animation.*",
         'reader_.optional(animation, "frametime", kTickRange, ticks_);', ""),
        ("animation: the time of a frame is not read", "tile_animation.*",
         'if (index) reader_.optional(node, "time", kTickRange, step.ticks);', ""),
        ("animation: the order of frames is not read", "tile_animation.*",
         "for (const JsonNode& node : list->items) readStep(node);", "(void)list;"),
        ("animation: the size of a frame is not read", "tile_animation.*",
         "    readFrameSize(animation);", "    meta_.width = meta_.height = std::min(size_.x, size_.y);"),
    ],
    "loader/world/resources/model_faces.cpp": [
        ("turns: about z first", "model_faces.*",
         "turnAbout(2, turn.degrees.z) * turnAbout(1, turn.degrees.y) *\n                turnAbout(0, turn.degrees.x)",
         "turnAbout(0, turn.degrees.x) * turnAbout(1, turn.degrees.y) *\n                turnAbout(2, turn.degrees.z)"),
        ("turns: the other way about", "model_faces.*",
         "const float angle = glm::radians(degrees);", "const float angle = -glm::radians(degrees);"),
        ("turns: none is stretched", "model_faces.*", "turn.rescale && axis < 3", "false && axis < 3"),
        ("turns: stretched along z as along x", "model_faces.*",
         "const glm::vec3 along = glm::abs(m[axis]);", "const glm::vec3 along = glm::abs(m[0]);"),
        ("shade: lost on the way to the face", "block_look.*", "face.shade = element.shade;", ""),
    ],
    "loader/world/resources/model_json.cpp": [
        ("turns: angles by axis are not read", "model_faces.*:block_models.*:block_look.*",
         "turn.degrees[axis] = float(degrees.value_or(0));", "(void)degrees;"),
        ("turns: the angle about the named axis is about x", "model_faces.*:block_models.*:block_look.*",
         "std::clamp(name[0] - 'x', 0, 2)", "0"),
        ("shade: not read", "block_look.*", 'reader_.optional(node, "shade", element.shade);', ""),
    ],
    "loader/world/mesh/block_faces.cpp": [
        ("shade: lost on the way to the mesh", "block_look.*", "face.shade = given.shade;", ""),
        ("flow: sides of still water", "flowing_water.*", "if (side && !flowing.empty())", "if (false && side)"),
        ("flow: the whole texture on a side", "flowing_water.*",
         "setAtlas(face, quarterOf(atlas.tile(flowing)));", "setAtlas(face, atlas.tile(flowing));"),
        ("flow: an eighth of a turn off", "flowing_water.*", "- kQuarterTurn;\n", "- kQuarterTurn * 0.5f;\n"),
        ("flow: a tangent that does not turn", "flowing_water.*",
         "face.tangent = glm::vec4(std::cos(angle), 0, std::sin(angle), 1);", ""),
    ],
    "loader/world/content/entity_models.cpp": [
        ("skin: left and right exchanged", "EntitySkin.*", "if (out.x < 0 ||", "if (out.x > 0 ||"),
        ("skin: the back wears the front", "EntitySkin.*", "if (out.z > 0 || size.z == 0)", "if (true)"),
        ("skin: the bottom is seen from below", "EntitySkin.*", "low.x, low.z};", "low.x, out.y > 0 ? low.z : high.z};"),
        ("skin: nothing lies", "EntitySkin.*", "return {v.x, v.z, -v.y};", "return v;"),
        ("skin: nothing is mirrored", "EntitySkin.*", "? glm::ivec3(-v.x, v.y, v.z) : v", "? v : v"),
    ],
    "loader/world/items/flat_item.cpp": [
        ("flat item: an edge for each texel", "item_looks.*", "if (edge || from < 0) continue;",
         "if (from < 0) continue;"),
        ("flat item: edges inside", "item_looks.*", "&& !isThere(image, x + out.x, y - out.y)", ""),
        ("flat item: edges on the other side", "item_looks.*", "y - out.y)", "y + out.y)"),
        ("flat item: edges of any number of texels", "item_looks.*", "kMostEdgeTexels = 64", "kMostEdgeTexels = 4096"),
    ],
    "loader/world/items/item_looks.cpp": [
        ("item: layers at one place", "item_looks.*", "kApart * float(layer)", "kApart * 0.0f"),
        ("item: no bound of faces", "item_looks.*", "sum + faces > limits::kItemFaces", "sum > limits::kItemFaces"),
        ("item: textures that are absent", "item_looks.*", "if (complete || block)", "if (true)"),
        ("item: no mirror", "item_looks.*", "glm::vec3(1, -1, -1)", "glm::vec3(1)"),
        ("item: turned about x first", "item_looks.*", "for (const int axis : {0, 1, 2}) {", "for (const int axis : {2, 1, 0}) {"),
        ("item: no model of the block", "item_looks.*", "return ofBlock(item);", "return std::nullopt;"),
    ],
    "loader/world/items/item_definition.cpp": [
        ("item: the bow is always drawn", "item_looks.*", '{"on_false", "fallback"}', '{"on_true", "fallback"}'),
    ],
}
