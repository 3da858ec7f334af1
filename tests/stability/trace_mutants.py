"""Mistakes put into the path tracer, and the tests that must find them.

For host_kill_list.py --table, by file: name, tests, what is replaced by what.
"""

MUTANTS = {
    "loader/trace/film/checkpoint.cpp": [
        ("checkpoints of other code go on", "Films.key*", "  digest.add(code);\n", ""),
        ("checkpoints of other seeds go on", "Films.key*", ".add(settings.seed)", ""),
    ],
    "loader/trace/trace_scene.cpp": [
        ("covered sides of lamps give light", "CoveredLamps.*",
         "    if ((input_.facts[beside].coveredFaces >> int(opposite(direction)) & 1) != 0) continue;\n", ""),
        ("sides of lamps between lamps give light", "CoveredLamps.*", "if (!cube) open =", "open ="),
        ("planes of lamps as bright as their cube", "Blocks/LampShape.*",
         "states_[quad.state].radiance * shareOfFaces(cell)", "states_[quad.state].radiance"),
    ],
    "loader/trace/path_tracer.cpp": [
        ("lamps light their own faces", "LampOwnFaces.*",
         "return surface.cell == cell && surface.quad != kNoQuad &&", "return false && surface.cell == cell &&"),
        ("cosine rays count lamps in full", "Blocks/LampShape.*",
         "lamp.radiance * (density / (density + other)) : glm::vec3(0)", "lamp.radiance : glm::vec3(0)"),
        ("survivors of roulette carry no more", "*ClosedBox.holds*", "    throughput /= survival;\n", ""),
    ],
    "loader/trace/grid/voxel_walk.cpp": [
        ("the back of lava's surface is met first", "LavaFloor.*",
         "    if (quad.twin != kNoQuad && (slope > 0 || quad.twin == ray_.ignore)) continue;\n", ""),
        ("panes tint at both faces", "Translucent.*", "if (quad.filters && slope < 0)", "if (quad.filters)"),
        ("stained glass tints by cells", "Translucent.*",
         "depth_ += filter.logarithm * (to - from);", "depth_ += filter.logarithm * 2.0f;"),
    ],
}
