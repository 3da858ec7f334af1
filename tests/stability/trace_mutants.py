"""Mistakes put into the path tracer, and the tests that must find them.

For host_kill_list.py --table: name, tests, file, what is replaced by what.
"""

TRACER = "loader/trace/path_tracer.cpp"
SCENE = "loader/trace/trace_scene.cpp"
WALK = "loader/trace/grid/voxel_walk.cpp"
CHECKPOINT = "loader/trace/film/checkpoint.cpp"

MUTANTS = [
    ("checkpoints of other code go on", "Films.key*", CHECKPOINT, "  digest.add(code);\n", ""),
    ("checkpoints of other seeds go on", "Films.key*", CHECKPOINT, ".add(settings.seed)", ""),
    ("covered sides of lamps give light", "CoveredLamps.*", SCENE,
     "    if ((input_.facts[beside].coveredFaces >> int(opposite(direction)) & 1) != 0) continue;\n", ""),
    ("sides of lamps between lamps give light", "CoveredLamps.*", SCENE, "if (!cube) open =", "open ="),
    ("planes of lamps as bright as their cube", "Blocks/LampShape.*", SCENE,
     "states_[quad.state].radiance * shareOfFaces(cell)", "states_[quad.state].radiance"),
    ("lamps light their own faces", "LampOwnFaces.*", TRACER, "return surface.cell == cell && surface.quad != kNoQuad &&",
     "return false && surface.cell == cell &&"),
    ("cosine rays count lamps in full", "Blocks/LampShape.*", TRACER,
     "lamp.radiance * (density / (density + other)) : glm::vec3(0)", "lamp.radiance : glm::vec3(0)"),
    ("survivors of roulette carry no more", "*ClosedBox.holds*", TRACER, "    throughput /= survival;\n", ""),
    ("the back of lava's surface is met first", "LavaFloor.*", WALK,
     "    if (quad.twin != kNoQuad && (slope > 0 || quad.twin == ray_.ignore)) continue;\n", ""),
    ("panes tint at both faces", "Translucent.*", WALK, "if (quad.filters && slope < 0)", "if (quad.filters)"),
    ("stained glass tints by cells", "Translucent.*", WALK, "depth_ += filter.logarithm * (to - from);",
     "depth_ += filter.logarithm * 2.0f;"),
]
