"""Mistakes put into the reference pack, and the tests that must find them.

A mutant: name, gtest filter of the tests of which at least one must fail, edits. An edit: file below
shaders/, text that stands there exactly once, what replaces it.
"""

STEP = "program/p0_floodfill_step.glsl"
FIELD = "include/voxel/light_field.glsl"
VOLUME = "include/voxel/volume.glsl"
VOXEL = "include/voxel/voxel.glsl"
BUFFERS = "include/buffers.glsl"

TO_POWER = "vec3 to_power(vec3 light) { return pow(max(light, vec3(1e-14)), vec3(FLOODFILL_GAMMA)); }"
FROM_POWER = "vec3 from_power(vec3 sum) { return pow(sum, vec3(1.0 / FLOODFILL_GAMMA)); }"
GAIN = "(FLOODFILL_ALPHA / 6.0)"
RESULT = "vec3 light = step_now ? propagate(cell, scroll) : light_at(cell + scroll);"
NO_VALUE = "light.r >= 0.0 && light.r <= light_max, light.g >= 0.0 && light.g <= light_max,\n" \
           "                     light.b >= 0.0 && light.b <= light_max"
SOLID = "if (is_opaque_voxel(v.code)) return vec3(0.0);"
NEIGHBOURS = "        sum += to_power(light_from(cell - offset, scroll));\n"
OUT = "out_light = vec4(round_to_half(clamp(light, 0.0, light_max)), 1.0);"
INSIDE = "return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, ivec3(VOLUME)));"


def power(to, back):
    return [(STEP, TO_POWER, "vec3 to_power(vec3 x) { " + to + " }"),
            (STEP, FROM_POWER, "vec3 from_power(vec3 x) { " + back + " }")]


MUTANTS = [
    ("A0 power and root exchanged", "A0.*",
     power("return pow(max(x, vec3(1e-14)), vec3(1.0 / FLOODFILL_GAMMA));",
           "return pow(x, vec3(FLOODFILL_GAMMA));")),
    ("A1 alpha one per cent high", "A1.*", [(STEP, GAIN, "(1.01 * FLOODFILL_ALPHA / 6.0)")]),
    ("A1 mean over the open neighbours only", "A1.*",
     [(STEP, "return from_power(sum) * (FLOODFILL_ALPHA / 6.0);",
       "float open = 0.0;\n"
       "    for (int i = 0; i < 6; ++i) {\n"
       "        ivec3 there = cell + (i < 3 ? 1 : -1) * ivec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);\n"
       "        open += float(in_volume(there) && !is_opaque_voxel(voxel_at(there).code));\n"
       "    }\n"
       "    return from_power(sum) * (FLOODFILL_ALPHA / max(open, 1.0));")]),
    ("A1 limit of alpha: gamma fixed at 2.2", "A1/*",
     power("return pow(max(x, vec3(1e-14)), vec3(2.2));", "return pow(x, vec3(1.0 / 2.2));")),
    ("A2 cell keeps half of its own light", "A2.*",
     [(STEP, RESULT, "vec3 light = light_at(cell + scroll);\n"
                     "    if (step_now) light = mix(propagate(cell, scroll), light, 0.5);")]),
    ("A3 light fades slower than it comes", "A3.*",
     [(STEP, RESULT, "vec3 light = light_at(cell + scroll);\n"
                     "    if (step_now) light = max(propagate(cell, scroll), 0.95 * light);")]),
    ("A4 two steps a frame", "A4.front*",
     [(STEP, NEIGHBOURS, NEIGHBOURS + "        sum += to_power(0.4 * light_from(cell + 2 * offset, scroll));\n")]),
    ("A4 cell keeps half of its own light", "A4.light*",
     [(STEP, RESULT, "vec3 light = light_at(cell + scroll);\n"
                     "    if (step_now) light = mix(propagate(cell, scroll), light, 0.5);")]),
    ("A5 diagonal neighbours, too", "A5.*",
     [(STEP, NEIGHBOURS, NEIGHBOURS +
       "        sum += 0.05 * to_power(light_from(cell + offset + offset.yzx, scroll));\n")]),
    ("A5 corridor walls of light", "A5.corridor*", [(STEP, SOLID, "")]
     + [(STEP, "if (is_opaque_voxel(own.code)) light = vec3(0.0);", "")]),
    ("A6 light summed, not its power", "A6.*", power("return x;", "return 0.4 * x;")),
    ("A7 alpha at its limit", "A7.*", [(STEP, GAIN, "(2.6573 / 6.0)")]),
    ("A9 no limit of the light", "A9.growth*", [(STEP, OUT, "out_light = vec4(light, 1.0);")]),
    ("A9 published rule for every gamma", "A9.without*",
     power("return pow(max(x, vec3(1e-14)), vec3(2.2));", "return pow(x, vec3(1.0 / 2.2));")),
    ("A10 sRGB curve for the power", "A10.*",
     power("return mix(x / 12.92, pow((x + 0.055) / 1.055, vec3(2.4)), greaterThan(x, vec3(0.04045)));",
           "return mix(x * 12.92, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055,"
           " greaterThan(x, vec3(0.0031308)));")),
    ("A10 square and root for the power", "A10.*", power("return x * x;", "return sqrt(x);")),
    ("A11 eight bits a channel", "A11.*",
     [(BUFFERS, "const int colortex4Format = RGBA16F;", "const int colortex4Format = RGBA8;")]),
    ("A12 nothing rejected", "A12/*nan:A12/*infinity", [(FIELD, NO_VALUE, "true, true, true")]),
    ("A12 min and max for the rejection", "A12/*",
     [(FIELD, "return mix(vec3(0.0), light,\n               bvec3(" + NO_VALUE + "));",
       "return min(max(light, vec3(0.0)), vec3(light_max));")]),
    ("A12 negative light passes", "A12/*negative",
     [(FIELD, NO_VALUE, "light.r <= light_max, light.g <= light_max, light.b <= light_max"),
      (STEP, "max(light, vec3(1e-14))", "abs(light)")]),
    ("A12 multiplied by visibility", "A12/*nan:A12/*infinity",
     [(FIELD, NO_VALUE, "true, true, true"),
      (STEP, SOLID + "\n    return light_at(cell + scroll);",
       "return light_at(cell + scroll) * float(!is_opaque_voxel(v.code));")]),
    ("A13 in place, ascending order", "A13.*",
     [(STEP, NEIGHBOURS, "        sum += to_power(max(light_from(cell - offset, scroll),\n"
                         "                            before(cell - offset, scroll)));\n"),
      (STEP, "vec3 propagate(ivec3 cell, ivec3 scroll) {",
       "vec3 before(ivec3 cell, ivec3 scroll) {\n"
       "    vec3 sum = vec3(0.0);\n"
       "    for (int axis = 0; axis < 3; ++axis) {\n"
       "        ivec3 offset = ivec3(axis == 0, axis == 1, axis == 2);\n"
       "        sum += to_power(light_from(cell + offset, scroll)) +\n"
       "               to_power(light_from(cell - offset, scroll));\n"
       "    }\n"
       "    return from_power(sum) * 0.4;\n"
       "}\n\n"
       "vec3 propagate(ivec3 cell, ivec3 scroll) {")]),
    ("A14 a step in every frame", "A14.*",
     [(STEP, "frameCounter % FLOODFILL_INTERVAL == 0", "true")]),
    ("A14 darkness between the steps", "A14.*",
     [(STEP, RESULT, "vec3 light = step_now ? propagate(cell, scroll) : vec3(0.0);"),
      (STEP, "if (!step_now && scroll == ivec3(0)) discard;", "")]),
    ("A14 previous light shown every other frame", "A14.*",
     [(STEP, "if (!step_now && scroll == ivec3(0)) discard;", ""),
      (STEP, RESULT, "vec3 light = step_now ? propagate(cell, scroll) : light_at(cell + scroll);\n"
                     "    if (frameCounter % FLOODFILL_INTERVAL == 1) light *= 1.0 - 0.082;\n"
                     "    if (frameCounter % FLOODFILL_INTERVAL == 2) light /= 1.0 - 0.082;")]),
    ("A15 emission limited", "A15.*",
     [(VOXEL, "return v.color * (EMISSION_STRENGTH * level * level);",
       "return min(v.color * (EMISSION_STRENGTH * level * level), vec3(1000.0));")]),
    ("A16 no bounds", "A16.*", [(VOLUME, INSIDE, "return cell.y >= 0 && cell.y < VOLUME;")]),
    ("A16 layers above the top are others' bottom", "A16.*",
     [(VOLUME, INSIDE, "return all(greaterThanEqual(cell.xz, ivec2(0))) &&"
                       " all(lessThan(cell.xz, ivec2(VOLUME)));"),
      (VOLUME, "int row = cell.y / ATLAS_COLUMNS;", "cell.y &= VOLUME - 1;\n    int row = cell.y / ATLAS_COLUMNS;")]),
    ("A17 int() for floor()", "A17.light*",
     [(VOLUME, "return ivec3(floor(cameraPosition)) - ivec3(floor(previousCameraPosition));",
       "return ivec3(cameraPosition) - ivec3(previousCameraPosition);")]),
    ("A17 never scrolls", "A17.light*",
     [(VOLUME, "return ivec3(floor(cameraPosition)) - ivec3(floor(previousCameraPosition));",
       "return ivec3(0);")]),
    ("A17 cells reused round the edge", "A17.teleport*",
     [(FIELD, "if (!in_volume(cell)) return vec3(0.0);", "cell &= VOLUME - 1;")]),
    ("A18 walls let one per cent through", "A18.closed*",
     [(STEP, SOLID, ""), (STEP, "if (is_opaque_voxel(own.code)) light = vec3(0.0);",
                          "if (is_opaque_voxel(own.code)) light *= 0.01;")]),
    ("A18 eighteen neighbours", "A18.wall*",
     [(STEP, NEIGHBOURS, NEIGHBOURS +
       "        sum += 0.01 * to_power(light_from(cell + offset + offset.yzx, scroll));\n"
       "        sum += 0.01 * to_power(light_from(cell - offset - offset.yzx, scroll));\n")]),
    ("A18 bend darker than the straight", "A18.bend*", [(STEP, GAIN, "(0.9 * FLOODFILL_ALPHA / 6.0)")]),
]
