"""Mistakes put into the draw lists of entities and hands and into vertices, and the tests of test_plan that must find them.

For tests/stability/host_kill_list.py --table: name, tests, file, what is replaced by what.
"""

ENTITIES = "loader/plan/lists/entity_list.cpp"
GLYPHS = "loader/plan/lists/glyphs.cpp"
HAND = "loader/plan/lists/hand_list.cpp"
VERTEX = "loader/plan/scene/gpu_vertex.cpp"

MUTANTS = [
    ("a tag that does not face the eye", "DrawLists.*", ENTITIES,
     "glm::translate(glm::mat4(1), middle) * towards", "glm::translate(glm::mat4(1), middle)"),
    ("a tag at the feet", "DrawLists.*", ENTITIES, "height + kOver, 0", "0, 0"),
    ("a tag is red on what is hurt", "DrawLists.*", ENTITIES,
     "draw.entityColor = glm::vec4(0);  // the name", "// the name"),
    ("a tag without a board", "DrawLists.*", ENTITIES,
     "  writer.quad(square);\n  square.color = glm::vec4(1);", "  square.color = glm::vec4(1);"),
    ("letters behind the board", "DrawLists.*", ENTITIES, "{0, 0, kNearer / kCapital}",
     "{0, 0, -kNearer / kCapital}"),
    ("letters on one place", "DrawLists.*", GLYPHS,
     "left + static_cast<float>(g * (kGlyphColumns + 1))", "left"),
    ("letters upside down", "DrawLists.*", GLYPHS,
     "kGlyphRows / 2.0f - 1 - static_cast<float>", "-kGlyphRows / 2.0f + static_cast<float>"),
    ("no digits", "DrawLists.*", GLYPHS, "return kGlyphs[26 + upper - '0'];", "return 0;"),
    ("no glint in the hand", "DrawLists.*", HAND,
     "!writer.state.environment.player.handGlint || draw", "true || draw"),
    ("glint in every hand", "DrawLists.*", HAND,
     "!writer.state.environment.player.handGlint || draw", "draw"),
    ("glint where no item is", "DrawLists.*", HAND,
     "  addItem(writer, item, place, light);\n}", "  addArm(writer, left, light);\n}"),
    ("shade: dark although it is not shaded", "GpuVertex.*", VERTEX,
     "style.oldLighting && in.shade", "style.oldLighting"),
]
