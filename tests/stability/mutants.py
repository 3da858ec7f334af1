"""Mistakes put into the reference pack, and the tests that must find them.

A mutant: name (first the row of docs/failure-modes.md, if it has one), gtest filter of the tests of which at
least one must fail, edits. An edit: file below
shaders/, text that stands there exactly once, what replaces it.
"""

STEP = "program/floodfill/atlas_step.glsl"
IMAGE_STEP = "program/floodfill/image_step.glsl"
IMAGE_LIST = "program/floodfill/image_list.glsl"
IMAGE_CELLS = "program/floodfill/image_cells.glsl"
IMAGE = "include/floodfill/flood_image.glsl"
DISTANCE = "program/voxels/distance.glsl"
POWERS = "include/floodfill/power_step.glsl"
RAYS = "program/gi/rays.glsl"
GATHER = "include/gi/gather.glsl"
HISTORY = "include/gi/history.glsl"
RULE = "include/floodfill/propagation.glsl"
FIELD = "include/floodfill/light_field.glsl"
VOLUME = "include/voxels/volume.glsl"
VOXEL = "include/voxels/voxel.glsl"
HALF = "include/math/half.glsl"
BUFFERS = "include/buffers.glsl"

TO_POWER = "vec3 to_power(vec3 light) { return pow(max(light, vec3(1e-14)), vec3(FLOODFILL_GAMMA)); }"
FROM_POWER = "vec3 from_power(vec3 sum) { return pow(sum, vec3(1.0 / FLOODFILL_GAMMA)); }"
GAIN = "(FLOODFILL_ALPHA / 6.0)"
RESULT = "vec3 light = step_now ? propagate(cell, own, scroll) : light_at(cell + scroll);"
NO_VALUE = "light.r >= 0.0 && light.r <= light_max, light.g >= 0.0 && light.g <= light_max,\n" \
           "                     light.b >= 0.0 && light.b <= light_max"
SOLID = "if (is_opaque_voxel(v.code)) return vec3(0.0);"
NEIGHBOURS = "        sum += to_power(light);\n"
LIMIT = "light = clamp(light, 0.0, light_max);"
SCROLL = "cameraPositionInt - previousCameraPositionInt"
INSIDE = "return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, volume_size));"


def power(to, back):
    return [(RULE, TO_POWER, "vec3 to_power(vec3 x) { " + to + " }"),
            (RULE, FROM_POWER, "vec3 from_power(vec3 x) { " + back + " }")]


def far(factor, offset):
    """A further neighbour in the sum."""
    there = f"cell + {offset}"
    return (f"        sum += to_power({factor}light_from(voxel_at({there}), {there}, scroll,"
            " vec3(0.0)));\n")


MUTANTS = [
    ("A0 power and root exchanged", "FloodfillGain.is*",
     power("return pow(max(x, vec3(1e-14)), vec3(1.0 / FLOODFILL_GAMMA));",
           "return pow(x, vec3(FLOODFILL_GAMMA));")),
    ("A1 alpha one per cent high", "FloodfillGain.gain_of_a_step*:FloodfillGain.light*",
     [(RULE, GAIN, "(1.01 * FLOODFILL_ALPHA / 6.0)")]),
    ("A1 mean over the open neighbours only", "FloodfillGain.gain_of_a_step*:FloodfillGain.light*",
     [(RULE, "return from_power(sum) * (FLOODFILL_ALPHA / 6.0);",
       "float open = 0.0;\n"
       "    for (int i = 0; i < 6; ++i) {\n"
       "        ivec3 there = cell + (i < 3 ? 1 : -1) * ivec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);\n"
       "        open += float(in_volume(there) && !is_opaque_voxel(voxel_at(there).code));\n"
       "    }\n"
       "    return from_power(sum) * (FLOODFILL_ALPHA / max(open, 1.0));")]),
    ("A1 limit of alpha: gamma fixed at 2.2", "FloodfillGain.light*",
     power("return pow(max(x, vec3(1e-14)), vec3(2.2));", "return pow(x, vec3(1.0 / 2.2));")),
    ("A2 cell keeps half of its own light",
     "FloodfillGain.gain_of_a_room*:FloodfillGain.gain_of_a_corridor*:FloodfillGain.a*",
     [(RULE, RESULT, "vec3 light = light_at(cell + scroll);\n"
                     "    if (step_now) light = mix(propagate(cell, own, scroll), light, 0.5);")]),
    ("A3 light fades slower than it comes", "FloodfillDelay.uniform*:FloodfillDelay.corridor*:FloodfillDelay.light_of*",
     [(RULE, RESULT, "vec3 light = light_at(cell + scroll);\n"
                     "    if (step_now) light = max(propagate(cell, own, scroll), 0.95 * light);")]),
    ("A4 two steps a frame", "FloodfillDelay.front*",
     [(RULE, NEIGHBOURS, NEIGHBOURS + far("0.4 * ", "2 * offset"))]),
    ("A4 cell keeps half of its own light", "FloodfillDelay.light_builds*",
     [(RULE, RESULT, "vec3 light = light_at(cell + scroll);\n"
                     "    if (step_now) light = mix(propagate(cell, own, scroll), light, 0.5);")]),
    ("A5 diagonal neighbours, too", "FloodfillFalloff.*",
     [(RULE, NEIGHBOURS, NEIGHBOURS +
       far("0.25 * ", "offset + offset.yzx"))]),
    ("A5 corridor walls of light", "FloodfillFalloff.corridor*", [(RULE, SOLID, "")]
     + [(RULE, "if (is_opaque_voxel(own.code)) light = vec3(0.0);", "")]),
    ("A6 light summed, not its power", "FloodfillScale.two*", power("return x;", "return 0.4 * x;")),
    ("A7 alpha at its limit", "FloodfillScale.room*", [(RULE, GAIN, "(2.6573 / 6.0)")]),
    ("A8 sky added to the root", "FloodfillSky.open*",
     [(RULE, "light += daylight_from(v, offset, day);", ""),
      (RULE, "return from_power(sum) * (FLOODFILL_ALPHA / 6.0);",
       "return from_power(sum) * (FLOODFILL_ALPHA / 6.0) + day.sky;")]),
    ("A8 half floats cut off", "FloodfillSky.*", [(HALF, "+ 0x1000u)", ")")]),
    ("A8 alpha one per cent high", "FloodfillSky.*", [(RULE, GAIN, "(1.01 * FLOODFILL_ALPHA / 6.0)")]),
    ("A8 no limit of the light", "FloodfillSky.too*", [(RULE, LIMIT, "")]),
    ("A8 roofs are open", "FloodfillSky.roof*",
     [(RULE, "day.sky = open ? sky_zenith() : vec3(0.0);", "day.sky = sky_zenith();")]),
    ("A9 no limit of the light", "FloodfillCurve.growth*", [(RULE, LIMIT, "")]),
    ("A9 published rule for every gamma", "FloodfillCurve.without*",
     power("return pow(max(x, vec3(1e-14)), vec3(2.2));", "return pow(x, vec3(1.0 / 2.2));")),
    ("A10 sRGB curve for the power", "FloodfillCurve.uniform*",
     power("return mix(x / 12.92, pow((x + 0.055) / 1.055, vec3(2.4)), greaterThan(x, vec3(0.04045)));",
           "return mix(x * 12.92, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055,"
           " greaterThan(x, vec3(0.0031308)));")),
    ("A10 square and root for the power", "FloodfillCurve.uniform*", power("return x * x;", "return sqrt(x);")),
    ("A11 eight bits a channel", "FloodfillStorage.no*",
     [(BUFFERS, "const int colortex4Format = RGBA16F;", "const int colortex4Format = RGBA8;")]),
    ("A12 nothing rejected", "FloodfillStorage.bad*", [(FIELD, NO_VALUE, "true, true, true")]),
    ("A12 min and max for the rejection", "FloodfillStorage.bad*",
     [(FIELD, "return mix(vec3(0.0), light,\n               bvec3(" + NO_VALUE + "));",
       "return min(max(light, vec3(0.0)), vec3(light_max));")]),
    ("A12 negative light passes", "FloodfillStorage.bad*",
     [(FIELD, NO_VALUE, "light.r <= light_max, light.g <= light_max, light.b <= light_max"),
      (RULE, "max(light, vec3(1e-14))", "abs(light)")]),
    ("A12 multiplied by visibility", "FloodfillStorage.bad*",
     [(FIELD, NO_VALUE, "true, true, true"),
      (RULE, SOLID, ""),
      (RULE, "return in_volume(there) ? light_at(there + scroll) : vec3(0.0);",
       "return light_at(there + scroll) * float(!is_opaque_voxel(v.code));")]),
    ("A13 in place, ascending order", "FloodfillSteps.one*:FloodfillSteps.light*",
     [(RULE, NEIGHBOURS, "        if ((i & 1) == 1)\n"
                         "            light = max(light, before(cell + offset, scroll));\n" + NEIGHBOURS),
      (RULE, "/// `self`: the cell's voxel. `scroll`: a cell was",
       "vec3 before(ivec3 cell, ivec3 scroll) {\n"
       "    vec3 sum = vec3(0.0);\n"
       "    for (int i = 0; i < 6; ++i) {\n"
       "        ivec3 there = cell + (i < 3 ? 1 : -1) * ivec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);\n"
       "        sum += to_power(light_from(voxel_at(there), there, scroll, vec3(0.0)));\n"
       "    }\n"
       "    return from_power(sum) * 0.4;\n"
       "}\n\n"
       "/// `self`: the cell's voxel. `scroll`: a cell was")]),
    ("A14 a step in every frame", "FloodfillSteps.frames*",
     [(STEP, "frameCounter % FLOODFILL_INTERVAL == 0", "true")]),
    ("A14 darkness between the steps", "FloodfillSteps.frames*",
     [(RULE, RESULT, "vec3 light = step_now ? propagate(cell, own, scroll) : vec3(0.0);"),
      (STEP, "if (!step_now && scroll == ivec3(0)) discard;", "")]),
    ("A14 previous light shown every other frame", "FloodfillSteps.frames*",
     [(STEP, "if (!step_now && scroll == ivec3(0)) discard;", ""),
      (RULE, RESULT, "vec3 light = step_now ? propagate(cell, own, scroll) : light_at(cell + scroll);\n"
                     "    if (frameCounter % FLOODFILL_INTERVAL == 1) light *= 1.0 - 0.082;\n"
                     "    if (frameCounter % FLOODFILL_INTERVAL == 2) light /= 1.0 - 0.082;")]),
    ("A15 emission limited", "FloodfillScale.ten*",
     [(VOXEL, "return color * (EMISSION_STRENGTH * share * share);",
       "return min(color * (EMISSION_STRENGTH * share * share), vec3(1000.0));")]),
    ("A16 no bounds", "FloodfillVolume.lamp*:FloodfillVolume.sky*",
     [(VOLUME, INSIDE, "return cell.y >= 0 && cell.y < VOLUME;")]),
    ("A16 layers above the top are others' bottom", "FloodfillVolume.lamp*:FloodfillVolume.sky*",
     [(VOLUME, INSIDE, "return all(greaterThanEqual(cell.xz, ivec2(0))) &&"
                       " all(lessThan(cell.xz, ivec2(VOLUME)));"),
      (VOLUME, "int row = cell.y / ATLAS_COLUMNS;", "cell.y &= VOLUME - 1;\n    int row = cell.y / ATLAS_COLUMNS;")]),
    ("A16 cells at the edge stand for those beyond", "FloodfillVolume.sky*",
     [(FIELD, "if (!in_volume(cell)) return vec3(0.0);",
       "cell = clamp(cell, ivec3(0), ivec3(VOLUME - 1));"),
      (RULE, "in_volume(there) ?", "true ?")]),
    ("A17 int() for floor()", "FloodfillVolume.light*",
     [(VOLUME, SCROLL, "ivec3(cameraPosition) - ivec3(previousCameraPosition)")]),
    ("A17 never scrolls", "FloodfillVolume.light*",
     [(VOLUME, SCROLL, "ivec3(0)")]),
    ("A17 cells reused round the edge", "FloodfillVolume.teleport*",
     [(FIELD, "if (!in_volume(cell)) return vec3(0.0);", "cell &= VOLUME - 1;"),
      (RULE, "in_volume(there) ?", "true ?")]),
    ("A18 walls let one per cent through", "FloodfillWalls.closed*",
     [(RULE, SOLID, ""), (RULE, "if (is_opaque_voxel(own.code)) light = vec3(0.0);",
                          "if (is_opaque_voxel(own.code)) light *= 0.01;")]),
    ("A18 eighteen neighbours", "FloodfillWalls.wall*",
     [(RULE, NEIGHBOURS, NEIGHBOURS + far("0.1 * ", "offset + offset.yzx"))]),
    ("A18 slabs do not close their own side", "FloodfillWalls.slab*",
     [(RULE, "if (closes(self.code, offset)) v = Voxel(self.color, voxel_solid);", "")]),
    ("A18 slabs close no side to their neighbours", "FloodfillWalls.slab*",
     [(RULE, "if (closes(v.code, -offset)) v.code = voxel_solid;", "")]),
    ("A18 bend darker than the straight", "FloodfillWalls.bend*", [(RULE, GAIN, "(0.9 * FLOODFILL_ALPHA / 6.0)")]),
    ("A18 published lookup stays in its cell", "FloodfillWalls.published*",
     [(FIELD, "position + 0.5 * hemisphere_direction(normal, u)", "position + 0.5 * normal")]),
    ("A18 walls have weight in the lookup", "FloodfillWalls.lookup*",
     [(FIELD, "is_opaque_voxel(voxel_at(cell).code) || !in_volume(cell)", "!in_volume(cell)")]),
    ("A19 walls absorb all", "FloodfillConserving.furnace*",
     [(RULE, "return v.color * own;", "return vec3(0.0) * own;")]),
    ("A19 mean over the open neighbours only", "FloodfillConserving.gain*",
     [(RULE, "return sum / 6.0;",
       "float open = 0.0;\n"
       "    for (int i = 0; i < 6; ++i) {\n"
       "        ivec3 there = cell + (i < 3 ? 1 : -1) * ivec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);\n"
       "        open += float(!is_opaque_voxel(voxel_at(there).code));\n"
       "    }\n"
       "    return sum / max(open, 1.0);")]),
    ("A19 half floats", "FloodfillConserving.furnace*",
     [(BUFFERS, "const int colortex4Format = RGBA32F;", "const int colortex4Format = RGBA16F;")]),
    ("A19 published gain", "FloodfillConserving.open*", [(RULE, "return sum / 6.0;", "return sum * (0.917 / 6.0);")]),
    ("B1 few lookups, each worth many", "PixelRays.floodfill*",
     [(GATHER, "light_at_face(hit.position, normal, next_random().xy) *",
       "light_at_face(hit.position, normal, next_random().xy) *\n"
       "                    (next_random().x < 1.0 / 256.0 ? 256.0 : 0.0) *")]),
    ("B2 four bounces are one", "PixelRays.more*", [(GATHER, "const int gi_bounces = 4;", "const int gi_bounces = 1;")]),
    ("B3 no ray to the lamp", "PixelRays.rays*",
     [(file, "#define HAS_LAMP_RAYS (HAS_FACE_CACHE && !HAS_LAMPS && GI_LAMPS != GI_LAMPS_HIT)", "#define HAS_LAMP_RAYS 0")
      for file in ("include/derived/features.glsl", "shaders.properties")]),
    ("B4 the same noise in each frame", "PixelRays.weight*:PixelRays.still*",
     [(RAYS, "seed_random(pixel, frameCounter);", "seed_random(pixel, 0);")]),
    ("B4 new frames count twice", "PixelRays.weight*",
     [(HISTORY, "mix(before.rgb, radiance, weight_of_sample(count))", "mix(before.rgb, radiance, min(2.0 * weight_of_sample(count), 1.0))")]),
    ("B5 light divided by its distance squared", "PixelRays.furnace*",
     [(GATHER, "radiance += throughput * lamp_light(hit, from, direction) *",
       "float range = 0.3 * length(hit.position - origin);\n"
       "            radiance += throughput * lamp_light(hit, from, direction) / max(1.0, range * range) *")]),
    ("image: updated in place", "FloodfillImage.*", [(POWERS, "lowest.z + other_side", "lowest.z + side")]),
    ("image: cells that came in keep what was there", "FloodfillImage.holds*",
     [(IMAGE_CELLS, "is_opaque_voxel(v.code) || entered(cell)", "is_opaque_voxel(v.code)")]),
    ("image: bricks that cells come into are not found", "FloodfillImage.holds*",
     [(IMAGE_LIST, " - abs(scroll);", ";"), (IMAGE_LIST, " - brick_size;", ";")]),
    ("image: bricks that cells begin to come into are not found", "FloodfillImage.holds*",
     [(IMAGE_LIST, " - brick_size;", ";")]),
    ("image: the middle does not rest while the volume moves", "FloodfillImage.moving*",
     [(IMAGE_LIST, "bool all = step_stamp() == 1u", "bool all = scrolled || step_stamp() == 1u")]),
    ("image: edits wake nothing", "FloodfillImage.*",
     [(IMAGE_LIST, "restless.light || restless.blocks", "restless.light")]),
    ("image: edits in frames between the steps are lost", "FloodfillImage.holds*",
     [(IMAGE_LIST, "ivec2(brick, 1)).r, FLOODFILL_INTERVAL)", "ivec2(brick, 1)).r, 1)")]),
    ("image: light wakes no neighbours", "FloodfillImage.*",
     [(IMAGE_LIST, "found.light || light_changed(there)", "found.light || (axis == 3 && light_changed(there))")]),
    ("image: cells do not learn of slabs above and below", "FloodfillImage.slab*",
     [(IMAGE_LIST, "(axis & 1) == 1", "axis == 3")]),
    ("image: nothing rests", "FloodfillImage.rests*",
     [(POWERS, "bool changed = false;\n\n", "bool changed = true;\n\n")]),
    ("image: all rests too early", "FloodfillImage.falls*", [(POWERS, "1.0 / 1024.0", "1.0 / 64.0")]),
    ("image: lamps are not put in", "FloodfillImage.*", [(IMAGE_CELLS, "is_lamp_voxel(v.code) ?", "false ?")]),
    ("image: walls hold the light that was there", "FloodfillImage.holds*",
     [(IMAGE_CELLS, "is_opaque_voxel(v.code) || entered(cell)", "is_lamp_voxel(v.code) || entered(cell)")]),
    ("image: steps change lamps", "FloodfillImage.*",
     [(IMAGE_CELLS, "uint(is_opaque_voxel(code)) * trait_fixed", "0u")]),
    ("image: slabs do not close their own side", "FloodfillWalls.slab*",
     [(IMAGE_CELLS, "code == voxel_slab_bottom || code_below", "code_below")]),
    ("image: slabs close no side to their neighbours", "FloodfillWalls.slab*",
     [(IMAGE_CELLS, " || code_above == voxel_slab_bottom", ""), (IMAGE_CELLS, " || code_below == voxel_slab_top", "")]),
    ("image: glass has no colour", "FloodfillImage.holds*",
     [(IMAGE_CELLS, "uint(is_filter_voxel(code)) * trait_filter", "0u")]),
    ("image: glass not seen in bricks", "FloodfillImage.holds*", [(IMAGE_STEP, "if (filters != 0u)", "if (false)")]),
    ("image: gain without the power", "FloodfillImage.falls*",
     [(POWERS, "pow(FLOODFILL_ALPHA / 6.0, FLOODFILL_GAMMA)", "FLOODFILL_ALPHA / 6.0")]),
    ("image: no bounds", "FloodfillImage.light_ends*", [(POWERS, "cell.x > 0, cell.x < VOLUME - 1", "true, true")]),
    ("image: no bounds up and down", "FloodfillImage.light_ends*", [(POWERS, "height < VOLUME_HEIGHT - 1 && ", "")]),
    ("image: bad values stay", "FloodfillImage.bad*", [(IMAGE, NO_VALUE, "true, true, true")]),
    ("image: no largest light", "FloodfillImage.growth*",
     [(POWERS, "min(step_gain * sum, vec3(power_max))", "step_gain * sum")]),
    ("image: sides differ at rest", "FloodfillImage.light_at_rest*", [(POWERS, "same ? own :", "false ? own :")]),
    ("image: codes are cut off", "FloodfillImage.*", [(IMAGE, "bits_of_code_0 - 0x2000u", "bits_of_code_0")]),
    ("image: a lake that drains leaves its tint", "FloodfillImage.change_in*",
     [("program/voxels/changes.glsl", "int height = lake ? bricks.y : 1;", "int height = 1;")]),
    ("image: the end of a lake leaves its tint", "FloodfillImage.end_of*",
     [("program/voxels/changes.glsl", "lake_seen).r, 2)", "lake_seen).r, 0)")]),
    ("rays: leaps one cell too long", "VoxelRays.*",
     [(DISTANCE, "uint open = ~0u;", "uint open = ~0u;\n        count(planes, open);")]),
    ("rays: blocks are not seen along y", "VoxelRays.*",
     [(DISTANCE, "add_row(bits, word + ivec3(0, k, i));", "")]),
    ("rays: blocks are not seen along x", "VoxelRays.*", [(DISTANCE, "bits.here << i | ", "")]),
    ("rays: distances not made anew after an edit", "VoxelRays.*",
     [("include/voxels/distance.glsl", "changed_within(imageLoad(voxel_memory, change_of_any).r, 1) || ", "")]),
    ("rays: all that is there stops", "VoxelRays.*",
     [("program/voxels/bits.glsl", "full |= uint(code == voxel_solid ||", "full |= uint(code > 0 ||")]),
]
