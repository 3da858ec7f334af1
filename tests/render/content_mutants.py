"""Mistakes put into what is drawn besides blocks and into moving textures, and the tests of test_render_gl that must find them.

For tests/stability/host_kill_list.py --table, by file: name, tests, what is replaced by what.
"""

MUTANTS = {
    "loader/render/scene/vertex_layout.cpp": [
        ("vaUV1: nobody is hurt", "DrawContentGL.*:ContractGL.*", "hurt ? kHurtRow : kPlainRow", "kPlainRow"),
        ("vaUV1: everybody is hurt", "DrawContentGL.*:ContractGL.*", "hurt ? kHurtRow : kPlainRow", "kHurtRow"),
        ("vaUV1: whole numbers as floats", "DrawContentGL.*:ContractGL.*",
         "    if (isIntegerAttribute(attribute.type))\n      gl::VertexAttribI4i(attribute.location, 0, row, 0, 1);\n    else\n",
         ""),
    ],
    "loader/render/draw/draw_content.cpp": [
        ("entities' shadows: everywhere", "DrawContentGL.*", "return reach > 0 ? reach :", "return reach > 0 ? kEverywhere :"),
        ("entities' shadows: without the multiplier of terrain", "DrawContentGL.*",
         "directives.shadowDistanceRenderMul * directives.entityShadowDistanceMul", "directives.entityShadowDistanceMul"),
        ("entities' shadows: without a multiplier as far as the map", "DrawContentGL.*",
         "    return kEverywhere;\n", "    return directives.shadowDistance;\n"),
    ],
    "loader/render/scene/animated_tiles.cpp": [
        ("animation: colours alone", "AnimatedTilesGL.*",
         "    showMoment(animation, moment, &TileImages::normal, false, normals);\n", ""),
        ("animation: only the largest level", "AnimatedTilesGL.*", "i < levels.size()", "i < 1"),
        ("animation: ten ticks a second", "AnimatedTilesGL.*", "kTicksPerSecond = 20", "kTicksPerSecond = 10"),
    ],
    "loader/render/scene/gpu_scene.cpp": [
        ("sight: as it was before an edit", "DrawTerrainGL.*", "  seenFor_.reset();\n", ""),
        ("light: a dark Nether", "SkyGL.*", "ambientLightOf(state.environment.dimension)", "0.0f"),
        ("light: a dark End", "SkyGL.*", "== \"minecraft:the_end\" ? glm::mix", "== \"\" ? glm::mix"),
        ("animation: items stand still", "AnimatedTilesGL.*", "  animatedContent_ = AnimatedTiles(atlas.animations);\n", ""),
    ],
    "loader/render/draw/draw_terrain.cpp": [
        ("sight: caves are drawn", "DrawTerrainGL.*", "(!seen || seen->contains(section.origin))", "true"),
        ("sight: from beside the camera", "DrawTerrainGL.*", "glm::length(glm::vec3(state.gbufferModelView[3])) < kBobbing", "true"),
        ("sight: in parallel", "DrawTerrainGL.*", "return !parallel && ", "return "),
        ("sight: none in rock", "DrawTerrainGL.*", "!parallel && !state.eyeInBlock &&", "!parallel &&"),
        ("block entities' shadows: all", "DrawBlocksGL.*", "return !scene.emits(entry.second->state);", "return false;"),
    ],
    "loader/render/draw/draw_sky.cpp": [
        ("the End: no sky", "SkyGL.*", "    scene.drawQuads(scene.endCube, program.patches);\n", ""),
    ],
}
