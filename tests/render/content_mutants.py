"""Mistakes put into what is drawn besides blocks and into moving textures, and the tests of test_render_gl that must find them.

For tests/stability/host_kill_list.py --table: name, tests, file, what is replaced by what.
"""

CONTENT = "loader/render/draw/draw_content.cpp"
LAYOUT = "loader/render/scene/vertex_layout.cpp"
TILES = "loader/render/scene/animated_tiles.cpp"

MUTANTS = [
    ("vaUV1: nobody is hurt", "DrawContentGL.*:ContractGL.*", LAYOUT, "hurt ? kHurtRow : kPlainRow", "kPlainRow"),
    ("vaUV1: everybody is hurt", "DrawContentGL.*:ContractGL.*", LAYOUT, "hurt ? kHurtRow : kPlainRow", "kHurtRow"),
    ("vaUV1: whole numbers as floats", "DrawContentGL.*:ContractGL.*", LAYOUT,
     "    if (isIntegerAttribute(attribute.type))\n      gl::VertexAttribI4i(attribute.location, 0, row, 0, 1);\n    else\n", ""),
    ("entities' shadows: everywhere", "DrawContentGL.*", CONTENT,
     "return reach > 0 ? reach :", "return reach > 0 ? kEverywhere :"),
    ("entities' shadows: without the multiplier of terrain", "DrawContentGL.*", CONTENT,
     "directives.shadowDistanceRenderMul * directives.entityShadowDistanceMul", "directives.entityShadowDistanceMul"),
    ("entities' shadows: without a multiplier as far as the map", "DrawContentGL.*", CONTENT,
     "    return kEverywhere;\n", "    return directives.shadowDistance;\n"),
    ("animation: colours alone", "AnimatedTilesGL.*", TILES,
     "    showMoment(animation, moment, &TileImages::normal, false, normals);\n", ""),
    ("animation: only the largest level", "AnimatedTilesGL.*", TILES,
     "i < levels.size()", "i < 1"),
    ("animation: ten ticks a second", "AnimatedTilesGL.*", TILES, "kTicksPerSecond = 20", "kTicksPerSecond = 10"),
]
