"""Mistakes put into the host's side of shadow volumes, and the tests that must find them.

For host_kill_list.py --table, by file: name, tests, what is replaced by what.
"""

MUTANTS = {
    "loader/render/scene/shadow_volumes.cpp": [
        ("places are not moved again", "ShadowVolumeCounts.a_path*", "if (drawn.base == base) return;", "if (drawn.base) return;"),
        ("directions to the light move, too", "ShadowVolumeShapes.leaves_far*", "corner += corner.w * by;", "corner += by;"),
        ("D1 z-pass for z-fail", "ShadowVolumeCounts.only*",
         "if (method == VolumeMethod::ZFail) return drawPart(silhouettes(light, true), kZFail);", ""),
        ("D1 the eye is in no volume", "ShadowVolumeCounts.only*:ShadowVolumeCounts.a_path*",
         "if (method != VolumeMethod::Auto) return;", "return;"),
        ("D3 caps where they are seen", "ShadowVolumeShapes.caps*",
         "constexpr float kBehind = 4, kBehindSlope = 1.0f / 256;", "constexpr float kBehind = 0, kBehindSlope = 0;"),
        ("D4 counts of z-pass that saturate", "ShadowVolumeCounts.counts*:ShadowVolumeCounts.volumes_in*",
         "kZPass{GL_LESS, GL_KEEP, GL_INCR_WRAP, GL_KEEP, GL_DECR_WRAP}",
         "kZPass{GL_LESS, GL_KEEP, GL_INCR, GL_KEEP, GL_DECR}"),
        ("D4 counts of z-fail that saturate", "ShadowVolumeCounts.counts*:ShadowVolumeCounts.volumes_in*",
         "kZFail{GL_LESS, GL_DECR_WRAP, GL_KEEP, GL_INCR_WRAP, GL_KEEP}",
         "kZFail{GL_LESS, GL_DECR, GL_KEEP, GL_INCR, GL_KEEP}"),
        ("D8 ends no farther behind than beginnings", "ShadowVolumeShapes.volumes*:ShadowVolumeShapes.light*",
         "kEndsBehind = 2", "kEndsBehind = 1"),
        ("D9 a face whose volume may hold the eye left out", "ShadowVolumeChoice.*",
         "return glm::dot(p - on, normal) > kMargin * length;", "return glm::dot(p - on, normal) > -0.3 * length;"),
    ],
    "loader/world/mesh/silhouette.cpp": [
        ("D2 no near caps", "ShadowVolumeCounts.crossings*:ShadowVolumeCounts.only*",
         "    triangle(a, b, c);\n    triangle(c, d, a);\n", ""),
        ("D2 no far caps of lamps", "ShadowVolumeCounts.crossings*",
         "    triangle(g, f, e);\n    triangle(e, h, g);\n", ""),
        ("D2 a far end of the sun's volumes", "ShadowVolumeCounts.crossings*:ShadowVolumeCounts.volumes_of*",
         "glm::vec4(-glm::vec3(light_), 0)", "glm::vec4(-glm::vec3(light_) * 9.0f, 1)"),
        ("D2 a far end of lamps' volumes", "ShadowVolumeCounts.crossings*",
         "glm::vec4(corner - glm::vec3(light_), 0)", "glm::vec4(corner * 2.0f - glm::vec3(light_), 1)"),
        ("D5 leaves cast by the faces that the light does not see", "ShadowVolumeShapes.a_lone*",
         "face.seeThrough ? cosine > kAlongLight : cosine < -kAlongLight", "cosine < -kAlongLight"),
        ("D6 boundaries without direction", "ShadowVolumeShapes.edges*:ShadowVolumeCounts.crossings*",
         "if (count < 0) std::swap(run.from, run.to);", ""),
        ("D7 merged runs", "ShadowVolumeShapes.sides*:ShadowVolumeShapes.straight*",
         "      emit(axis, here, since, count, result);\n      since = here.at;\n",
         "      if (next != count) emit(axis, here, since, count, result), since = here.at;\n"),
    ],
    "loader/render/draw/draw_shadow_volumes.cpp": [
        ("D3 places relative to a far point", "ShadowVolumeShapes.leaves_far*", "glm::round(state.cameraPosition / 16.0)", "glm::dvec3(32, 0, 0)"),
        ("D2 no depth clamp", "ShadowVolumeCounts.volumes_at*", "  gl::Enable(GL_DEPTH_CLAMP);\n", ""),
    ],
    "loader/world/mesh/casters.cpp": [
        ("lamps: the lamp shades itself", "LampVolumes.*",
         "if (glm::ivec3(glm::floor(middle - face.normal * kInside)) == own) continue;", ""),
        ("lamps: casters of half the range", "LampVolumes.*", "<= range)", "<= range * 0.5)"),
    ],
    "loader/render/scene/lamp_volumes.cpp": [
        ("lamps: a scissor about the middle of the world", "LampVolumes.*", "lamp.place() - glm::dvec3(view.base)", "lamp.place() - glm::dvec3(casters_.origin)"),
        ("lamps: volumes relative to another block", "LampVolumes.*", "view.eye, view.base, view.method", "view.eye, glm::ivec3(0, -16, 0), view.method"),
        ("lamps: a scissor too small", "LampVolumes.*", "middle + side * radius", "middle + side * radius * 0.5f"),
        ("lamps: the stencil of the lamp before", "LampVolumes.*",
         "    gl::ClearStencil(0);\n    gl::Clear(GL_STENCIL_BUFFER_BIT);\n", ""),
        ("lamps: one bit for all", "LampVolumes.*", "1u << bit", "1u"),
        ("lamps: the farthest first", "LampVolumes.*", "first > second", "first < second"),
    ],
}
