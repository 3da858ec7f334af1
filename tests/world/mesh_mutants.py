"""Mistakes put into meshes and resource packs, and the tests of test_world that must find them.

For tests/stability/host_kill_list.py --table: name, tests, file, what is replaced by what.
"""

MESH = "loader/world/mesh/block_mesh.cpp"
STATES = "loader/world/mesh/mesh_states.cpp"
FACES = "loader/world/mesh/block_faces.cpp"
MODEL = "loader/world/resources/model_faces.cpp"
MODEL_JSON = "loader/world/resources/model_json.cpp"
META = "loader/world/resources/texture_meta.cpp"
ANIMATION = "loader/world/atlas/tile_animation.cpp"

MUTANTS = [
    ("faces: all have the first shape", "BlockMesh.*", MESH, "shapes[face.shape]", "shapes[0]"),
    ("faces: the cell of the face is lost", "BlockMesh.*", MESH,
     "glm::vec3(face.cell) + shape.corners[i]", "shape.corners[i]"),
    ("faces: one corner's light for all", "BlockMesh.*", MESH, "face.light[i],", "face.light[0],"),
    ("faces: one corner's occlusion for all", "BlockMesh.*", MESH,
     "glm::u8vec4(face.tint, face.occlusion[i])", "glm::u8vec4(face.tint, face.occlusion[0])"),
    ("faces: nothing emits", "BlockMesh.*", MESH,
     "glm::i8vec4(shape.toMiddle[i], face.emission)", "glm::i8vec4(shape.toMiddle[i], 0)"),
    ("faces: no fluid", "BlockMesh.*", MESH, "std::uint8_t(fluid ? 1 : 0)", "std::uint8_t(0)"),
    ("faces: the middle is that of the face", "BlockMesh.*", STATES,
     "(glm::vec3(0.5f) - face.corners[i]) * 64.0f", "(face.corners[0] - face.corners[i]) * 64.0f"),
    ("animation: the next frame is the same", "block_look.*anim*", ANIMATION,
     "animation.steps[(i + 1) % animation.steps.size()].frame", "step.frame"),
    ("animation: every step is a tick", "block_look.*anim*", ANIMATION,
     "period += step.ticks", "period += 1"),
    ("animation: never begins again", "block_look.*anim*", ANIMATION, "tick %= period;",
     "tick = tick < period ? tick : 0;"),
    ("animation: transparency is mixed too", "block_look.*anim*", ANIMATION,
     "if (i % 4 == 3) continue;", ""),
    ("animation: frametime is not read", "block_look.*anim*", META,
     'reader_.optional(animation, "frametime", kTickRange, ticks_);', ""),
    ("animation: the time of a frame is not read", "block_look.*anim*", META,
     'if (index) reader_.optional(node, "time", kTickRange, step.ticks);', ""),
    ("animation: the order of frames is not read", "block_look.*anim*", META,
     "for (const JsonNode& node : list->items) readStep(node);", "(void)list;"),
    ("animation: the size of a frame is not read", "block_look.*anim*", META,
     "    readFrameSize(animation);", "    meta_.width = meta_.height = std::min(size_.x, size_.y);"),
    ("turns: about z first", "model_faces.*", MODEL,
     "turnAbout(2, turn.degrees.z) * turnAbout(1, turn.degrees.y) *\n                turnAbout(0, turn.degrees.x)",
     "turnAbout(0, turn.degrees.x) * turnAbout(1, turn.degrees.y) *\n                turnAbout(2, turn.degrees.z)"),
    ("turns: the other way about", "model_faces.*", MODEL,
     "const float angle = glm::radians(degrees);", "const float angle = -glm::radians(degrees);"),
    ("turns: none is stretched", "model_faces.*", MODEL, "turn.rescale && axis < 3", "false && axis < 3"),
    ("turns: stretched along z as along x", "model_faces.*", MODEL,
     "const glm::vec3 along = glm::abs(m[axis]);", "const glm::vec3 along = glm::abs(m[0]);"),
    ("turns: angles by axis are not read", "model_faces.*:block_look.*", MODEL_JSON,
     "turn.degrees[axis] = float(degrees.value_or(0));", "(void)degrees;"),
    ("turns: the angle about the named axis is about x", "model_faces.*:block_look.*", MODEL_JSON,
     "std::clamp(name[0] - 'x', 0, 2)", "0"),
    ("shade: not read", "block_look.*", MODEL_JSON, 'reader_.optional(node, "shade", element.shade);', ""),
    ("shade: lost on the way to the face", "block_look.*", MODEL, "face.shade = element.shade;", ""),
    ("shade: lost on the way to the mesh", "block_look.*", FACES, "face.shade = given.shade;", ""),
    ("flow: sides of still water", "block_look.*water*", FACES,
     "if (side && !flowing.empty())", "if (false && side)"),
    ("flow: the whole texture on a side", "block_look.*water*", FACES,
     "setAtlas(face, quarterOf(atlas.tile(flowing)));", "setAtlas(face, atlas.tile(flowing));"),
    ("flow: upwards", "block_look.*water*", MESH, "fall = state.height - beside.height;",
     "fall = beside.height - state.height;"),
    ("flow: not over an edge", "block_look.*water*", MESH,
     "fall = state.height - (under.height - kSource);", "fall = 0;"),
    ("flow: the surface stays still", "block_look.*water*", MESH,
     "if (!surface || !heading) addFace", "if (true) addFace"),
    ("flow: an eighth of a turn off", "block_look.*water*", FACES,
     "- kQuarterTurn;\n", "- kQuarterTurn * 0.5f;\n"),
    ("flow: a tangent that does not turn", "block_look.*water*", FACES,
     "face.tangent = glm::vec4(std::cos(angle), 0, std::sin(angle), 1);", ""),
]
