"""Mistakes put into the draw lists of entities and hands and into vertices, and the tests of test_plan that must find them.

For tests/stability/host_kill_list.py --table, by file: name, tests, what is replaced by what.
"""

MUTANTS = {
    "loader/plan/lists/entity_list.cpp": [
        ("a tag that does not face the eye", "DrawLists.*",
         "glm::translate(glm::mat4(1), middle) * towards", "glm::translate(glm::mat4(1), middle)"),
        ("a tag at the feet", "DrawLists.*", "height + kOver, 0", "0, 0"),
        ("a tag is red on what is hurt", "DrawLists.*", "draw.entityColor = glm::vec4(0);  // the name", "// the name"),
        ("a tag without a board", "DrawLists.*",
         "  writer.quad(square);\n  square.color = glm::vec4(1);", "  square.color = glm::vec4(1);"),
        ("an outer layer without a skin", "DrawLists.*", "return {nullptr, nullptr, hasOwnTextures(box)};", "return {nullptr, nullptr, true};"),
        ("skins of one size", "DrawLists.*", "const float texels = (look.tile->max.x - look.tile->min.x) * size.x;",
         "const float texels = 64;"),
        ("the model of its kind", "DrawLists.*",
         "const EntityModel* model = findEntityModel(entity.model);", "const EntityModel* model = findEntityModel(entity.kind);"),
        ("frames only on walls", "DrawLists.*", "glm::radians(pitch), glm::vec3(1, 0, 0)", "0.0f * pitch, glm::vec3(1, 0, 0)"),
        ("a framed item turns the other way", "DrawLists.*", "glm::radians(-entity.itemTurn)", "glm::radians(entity.itemTurn)"),
        ("no pose on the ground", "DrawLists.*", "* look.posed(DisplayPlace::Ground);", "* look.posed(DisplayPlace::Fixed);"),
        ("a posed item turns the other way", "DrawLists.*", "glm::radians(entity.itemTurn)", "glm::radians(-entity.itemTurn)"),
        ("a frame looks to -z", "DrawLists.*", "glm::radians(180.0f), glm::vec3(0, 1, 0));\n  m = glm::rotate(m, glm::radians(entity", "glm::radians(0.0f), glm::vec3(0, 1, 0));\n  m = glm::rotate(m, glm::radians(entity"),
        ("hidden bodies", "DrawLists.*", "i < model.boxes.size() && !entity.hidden", "i < model.boxes.size()"),
        ("armour unseen", "DrawLists.*", "  addArmour(writer, entity, place, step, light);\n", ""),
        ("armour without its item", "DrawLists.*", "    draw.item = item;\n    writer.begin(draw);\n    ContentQuad like;", "    writer.begin(draw);\n    ContentQuad like;"),
        ("every piece is a whole suit", "DrawLists.*", "if (each.slot != piece.slot) continue;", ""),
        ("no dye on leather", "DrawLists.*", "worn.takesDye ? entity.dye.value_or(color) : color", "color"),
        ("dye on iron", "DrawLists.*", "worn.takesDye ? entity.dye.value_or(color) : color", "entity.dye.value_or(color)"),
        ("a hand behind the back", "DrawLists.*", "const glm::vec3 inHand(side, 2, -10);", "const glm::vec3 inHand(side, -2, -10);"),
        ("held as in the other hand", "DrawLists.*", "left ? DisplayPlace::ThirdLeft : DisplayPlace::ThirdRight", "left ? DisplayPlace::ThirdRight : DisplayPlace::Ground"),
        ("held at the shoulder", "DrawLists.*", "inHand), glm::vec3(kModelTexels))", "glm::vec3(0)), glm::vec3(kModelTexels))"),
        ("the tag of a cow is a cow", "DrawLists.*", "  draw.entity = \"minecraft:name_tag\";  // as Iris names it\n", ""),
        ("letters behind the board", "DrawLists.*", "{0, 0, kNearer / kCapital}", "{0, 0, -kNearer / kCapital}"),
    ],
    "loader/plan/lists/item_list.cpp": [
        ("no item of a resource pack", "DrawLists.*", "lookOf(item))\n    return addModel", "lookOf(\"\"))\n    return addModel"),
        ("no dye", "DrawLists.*", "look.tintOf(face.tintIndex, dye)", "look.tintOf(face.tintIndex)"),
    ],
    "loader/plan/frame/visible_sections.cpp": [
        ("sight: lines turn back", "VisibleSections.*", "< 0;\n      const glm::ivec3 next", "< -99;\n      const glm::ivec3 next"),
        ("sight: only away from the lowest corner", "VisibleSections.*", "(section[axis] - here[axis]) * normal[axis] < 0", "normal[axis] < 0"),
        ("sight: through rock", "VisibleSections.*", ": grid.links[indexOf(section)].from[std::size_t(entered)]", ": SectionLinks::kAll"),
        ("sight: by the side that was left", "VisibleSections.*", "int(opposite(FaceDirection(side)))", "side"),
        ("sight: none from outside", "VisibleSections.*", "if (high ? eye[axis] <= last : eye[axis] >= 0) continue;", "continue;"),
        ("sight: one side from outside", "VisibleSections.*", "for (int z = low.z; z < end.z; ++z) first.push_back({{x, y, z}, side});\n  }\n  return first;", "for (int z = low.z; z < end.z; ++z) first.push_back({{x, y, z}, side});\n    break;\n  }\n  return first;"),
    ],
    "loader/world/content/armour.cpp": [
        ("armour on cows", "DrawLists.*", "model == nullptr || !model->wearsArmour", "model == nullptr"),
    ],
    "loader/plan/lists/glyphs.cpp": [
        ("letters on one place", "DrawLists.*", "left + static_cast<float>(g * (kGlyphColumns + 1))", "left"),
        ("letters upside down", "DrawLists.*",
         "kGlyphRows / 2.0f - 1 - static_cast<float>", "-kGlyphRows / 2.0f + static_cast<float>"),
        ("no digits", "DrawLists.*", "return kGlyphs[26 + upper - '0'];", "return 0;"),
    ],
    "loader/plan/lists/hand_list.cpp": [
        ("no glint in the hand", "DrawLists.*", "!writer.state.environment.player.handGlint || draw", "true || draw"),
        ("glint in every hand", "DrawLists.*", "!writer.state.environment.player.handGlint || draw", "draw"),
        ("both hands are right", "DrawLists.*", "left ? DisplayPlace::FirstLeft :", "left ? DisplayPlace::FirstRight :"),
        ("glint where no item is", "DrawLists.*",
         "  addItem(writer, item, place, light);\n}", "  addArm(writer, left, light);\n}"),
    ],
    "loader/plan/scene/vertex_packer.cpp": [
        ("shade: dark although it is not shaded", "VertexPacker.*", "style.oldLighting && shape.shade", "style.oldLighting"),
    ],
}
