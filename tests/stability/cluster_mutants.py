"""Mistakes put into the lamps and their clusters, and the tests that must find them.

For kill_list.py --table; rows as in mutants.py.
"""

GRID = "include/lights/grid.glsl"
LIGHT = "include/lights/lamp_light.glsl"
LIST = "include/lights/lamp_list.glsl"
LAMPS = "include/lights/lamps.glsl"
CHANGES = "include/lights/changes.glsl"
SUM = "include/lights/lit_by_lamps.glsl"
TABLE = "program/lights/table.glsl"
ASSIGN = "program/lights/assign.glsl"
LISTS = "program/lights/lists.glsl"
REST = "include/lights/grid_rest.glsl"
COMMIT = "program/lights/commit.glsl"
GATHER = "include/gi/gather.glsl"
LIT = "program/lighting.glsl"
TRANSLUCENT = "program/gbuffers/translucent.glsl"
SHADOW = "program/shadow/shadow.glsl"
RAYS = "include/lights/lamp_shadows.glsl"
DEBUG = "include/debug/lights.glsl"

SLICE = "slice_of(distance_along));"
CLAMP = "int(clamp(floor(guess), 0.0, float(grid_slices - 1)))"
FIRST = "int first = slice_of(max(s.center.z - s.radius, 0.0) * (1.0 - pad));"
LAST = "int last = far > 0.0 ? slice_of(far * (1.0 + pad)) : -1;"

MUTANTS = [
    ("F1 no clamp at the near end", "ClusterSlices.distances*",
     [(GRID, CLAMP, "int(min(floor(guess), float(grid_slices - 1)))")]),
    ("F1 no clamp at the far end", "ClusterSlices.distances*",
     [(GRID, CLAMP, "int(max(floor(guess), 0.0))"),
      (GRID, "if (slice < grid_slices - 1 && distance_along", "if (distance_along")]),
    ("F1 nearest slice", "ClusterSlices.slices_begin*",
     [(GRID, CLAMP, "int(clamp(floor(guess + 0.5), 0.0, float(grid_slices - 1)))"),
      (GRID, "if (slice > 0 && distance_along < slice_start(slice)) slice -= 1;", "")]),
    ("F1 guess of the logarithm as it is", "ClusterSlices.slices_begin*:ClusterSlices.distances*:ClusterSlices.points*",
     [(GRID, "if (slice > 0 && distance_along < slice_start(slice)) slice -= 1;", ""),
      (GRID, "if (slice < grid_slices - 1 && distance_along >= slice_start(slice + 1)) slice += 1;", "")]),
    ("F1 last slice left out", "ClusterSlices.points*:ClusterLights.a_thousand*",
     [(ASSIGN, "slice <= last", "slice < last")]),
    ("F1 no padding", "ClusterSlices.points*:ClusterLights.a_thousand*",
     [(ASSIGN, "const float pad = 1e-5;", "const float pad = 0.0;")]),
    ("F3 depth of the window for that of the clip space", "ClusterSlices.slices_on*",
     [(GRID, SLICE, "slice_of(gbufferProjection[3][2] / ((gbufferProjection[3][2] / distance_along -"
                    " gbufferProjection[2][2]) * 0.5 + 0.5 + gbufferProjection[2][2])));")]),
    ("F3 distance to the eye, not along the axis", "ClusterSlices.slices_on*",
     [(GRID, SLICE, "slice_of(length(view)));")]),
    ("F4 lights behind the eye dropped", "ClusterLights.lights*",
     [(ASSIGN, LAST, LAST.replace("far > 0.0", "s.center.z > 0.0"))]),
    ("F4 logarithm of what is behind the eye", "ClusterLights.lights*",
     [(ASSIGN, FIRST, "int first = slice_of(abs(s.center.z - s.radius) * (1.0 - pad));")]),
    ("F4 slopes of a sphere that holds the eye", "ClusterLights.lights*:ClusterLights.a_thousand*",
     [(ASSIGN, "if (squared <= 0.0) return vec2(-unbounded, unbounded);", "squared = abs(squared);")]),
    ("F5 no window", "ClusterLights.light_fades*", [(LIGHT, "spot * window * window /", "spot /")]),
    ("F5 window ends beyond the range", "ClusterLights.a*:ClusterLights.points*:ClusterLights.light_fades*",
     [(LIGHT, "float reach = squared * place.w;", "float reach = 0.9 * squared * place.w;")]),
    ("F5 sphere of a tile's corner too small", "ClusterLights.a_thousand*",
     [(ASSIGN, "wide * wide + high * high > radius * radius", "wide + high > radius")]),
    ("F5 box of slopes taken at the wrong distance", "ClusterLights.a_thousand*",
     [(ASSIGN, "low / (low < 0.0 ? between.x : between.y)", "low / (low < 0.0 ? between.y : between.x)")]),
    ("F5 tiles end before the next begins", "ClusterLights.a_thousand*",
     [(ASSIGN, "float end = tile_start(tile + 1, axis);", "float end = tile_start(tile + 1, axis) * 0.8;")]),
    ("F5 beside the screen as in the tile at its border", "ClusterLights.points*",
     [(GRID, "return no_cluster;", "slope = clamp(slope, -1.0 / tile_scale(), 1.0 / tile_scale());")]),
    ("F7 tiles at the border have no end", "ClusterLoad.tiles*",
     [(ASSIGN, "float end = tile_start(tile + 1, axis);",
       "float end = tile == (axis == 0 ? grid_columns : grid_rows) - 1 ? unbounded : tile_start(tile + 1, axis);"),
      (ASSIGN, "if (slopes.x > edge || slopes.y < -edge) return ivec2(0, -1);", "")]),
    ("F9 lights beside the screen tested", "ClusterLoad.each*",
     [(ASSIGN, "if (slopes.x > edge || slopes.y < -edge) return ivec2(0, -1);", "")]),
    ("F5 columns for rows", "ClusterLights.a_thousand*",
     [(GRID, "ivec2(tile_of(slope.y, 1) * grid_columns + tile_of(slope.x, 0),", "ivec2(tile_of(slope.x, 0) * grid_rows + tile_of(slope.y, 1),")]),
    ("F5 bits of the frame before stay", "ClusterLists.lists*",
     [(LISTS, "imageStore(light_bits, ivec3(word, cluster), uvec4(bits));", "")]),
    ("F6 corners of tiles not looked at", "ClusterLoad.clusters*",
     [(ASSIGN, "if (wide * wide + high * high > radius * radius) continue;", "")]),
    ("F6 whole range in every slice", "ClusterLoad.clusters*",
     [(ASSIGN, "float radius = sqrt(max(s.radius * s.radius - off * off, 0.0));", "float radius = s.radius;")]),
    ("F7 lists of the tile in every slice", "ClusterLoad.tiles*:ClusterLoad.lights*:ClusterLoad.clusters*",
     [(ASSIGN, "for (int slice = first; slice <= last; ++slice)",
       "for (int slice = 0; slice < grid_slices; ++slice)"),
      (ASSIGN, "vec2 slab = vec2(slice_start(slice), last ? unbounded : slice_start(slice + 1));",
       "vec2 slab = vec2(0.0, unbounded);")]),
    ("F9 every tile tested", "ClusterLoad.each*",
     [(ASSIGN, "return ivec2(tile_of(slopes.x, axis), tile_of(slopes.y, axis));",
       "return ivec2(0, (axis == 0 ? grid_columns : grid_rows) - 1);")]),
    ("F2 logarithm from the near plane", "ClusterSlices.no*:ClusterSlices.slices_begin*",
     [(GRID, "const float first_slice = LIGHT_FIRST_SLICE;", "const float first_slice = 0.05;")]),
    ("F8 lists without an end", "ClusterLists.what_a*:ClusterLists.points*",
     [(LISTS, "bits != 0u && count < list_capacity;", "bits != 0u;")]),
    ("F8 overflow not counted", "ClusterLists.what_a*",
     [(LISTS, "if (found.y > 0u) imageAtomicAdd", "if (found.y > 4096u) imageAtomicAdd")]),
    ("F8 overflow dark", "ClusterLists.points*", [(SUM, "int end = first < 0 ? first :", "int end = true ? first :")]),
    ("F8 overflow a word late", "ClusterLists.points*", [(LISTS, "rest = uint(word + 1);", "rest = uint(word + 2);")]),
    ("F8 overflow of the frame before stays", "ClusterLists.what_lists*",
     [(REST, "if (rest == 0u) continue;", "if (rest != 9999u) continue;")]),
    ("F8 lists from behind", "ClusterLists.lists*",
     [(LISTS, "uvec4(uint(word * 32 + findLSB(bits)))", "uvec4(uint(word * 32 + 31 - findLSB(bits)))")]),
    ("F8 table past its end", "ClusteredLamps.table_without*",
     [(CHANGES, "min(tally_of(lamp_total), table_capacity)", "tally_of(lamp_total)")]),
    ("E1 no least distance", "LampFalloff.*", [(LIGHT, "max(squared, radius)", "squared")]),
    ("E1 lamp lights its own block", "LampFalloff.*",
     [(LIGHT, "float outside = step(own_cell, off);", "float outside = 1.0;")]),
    ("table in the order of arrival", "ClusteredLamps.table_is*:ClusteredLamps.two*",
     [(TABLE, "uint slot = lamps_before(y, z);", "uint slot = listed_lamps() - left - lamps_before(y, z);")]),
    ("every quad a lamp", "ClusteredLamps.nothing*:ClusteredLamps.table_without*",
     [(LIST, "if (imageAtomicMax(lamp_cells, cell, lamp) != 0u) return;",
       "imageAtomicMax(lamp_cells, cell, lamp);")]),
    ("made anew in every frame", "ClusteredLamps.nothing*",
     [(CHANGES, "return state_of(state_tables) == 0u ||", "return true ||")]),
    ("lists kept when lamps change", "ClusteredLamps.a_lamp*:ClusteredLamps.nothing*",
     [(CHANGES, "state_of(state_grids) == 0u || lights_changed() || view_changed()",
       "state_of(state_grids) == 0u || view_changed()")]),
    ("lists kept when the view changes", "ClusteredLamps.nothing*",
     [(CHANGES, "lights_changed() || view_changed()", "lights_changed()")]),
    ("checksum without place", "ClusteredLamps.a_lamp*:ClusteredLamps.nothing*",
     [(LIST, "hash(uvec3(place.x | place.y << 16, place.z, lamp)).x", "lamp")]),
    ("automatic choice one lamp off", "ClusteredLamps.few*", [(LAMPS, "lamps > auto_lamps", "lamps >= auto_lamps")]),
    ("automatic choice forgotten in the sum", "ClusteredLamps.few*",
     [(SUM, "listed ? imageLoad(light_list, ivec3(i, cluster)).r : uint(i)",
       "imageLoad(light_list, ivec3(i, cluster)).r")]),
    ("translucent surfaces without lamps", "ClusteredLamps.translucent*",
     [(TRANSLUCENT, "radiance += lamps_radiance(player, n, 0.0, albedo);", "")]),
    ("spots shine both ways", "ClusteredLamps.spots*", [(LIGHT, "float cosine = along * inverse_distance *",
                                                "float cosine = abs(along) * inverse_distance *"),
                                               (LIGHT, "(positive ? -1.0 : 1.0);", "1.0;")]),
    ("spots reach half as far in lists", "ClusteredLamps.spots_are*",
     [(ASSIGN, "float radius = inversesqrt(stored.w);",
       "float radius = inversesqrt(stored.w) * "
       "(imageLoad(light_table, table_texel(lamp) + ivec2(1, 0)).w < 0.0 ? 0.3 : 1.0);")]),
    ("spots shine the other way", "ClusteredLamps.spots*",
     [(LIGHT, "(positive ? -1.0 : 1.0)", "(positive ? 1.0 : -1.0)")]),
    ("highlights seen from above", "ClusteredLamps.highlights*",
     [(LIGHT, "reflect_direct(albedo, n, view, to_lamp * inverse)", "reflect_direct(albedo, n, n, to_lamp * inverse)")]),
    ("highlights seen otherwise by each method", "ClusteredLamps.every_method_gives_the_same_h*",
     [(SUM, "lamp_view = -normalize(player);", "lamp_view = -normalize(player) * float(LIGHT_METHOD);")]),
    ("heat without white", "ClusteredLamps.views*", [(DEBUG, "count > list_capacity ? vec3(1.0) : ", "")]),
    ("tiles for slices in the view", "ClusteredLamps.views*", [(DEBUG, "cluster.y & 7", "cluster.x & 7")]),
    ("rays see every lamp", "ClusteredLamps.rays*", [(RAYS, "bool sees =", "bool sees = true ||")]),
    ("rays see no lamp", "ClusteredLamps.rays*",
     [(RAYS, "return sees ? hit.transmittance : vec3(0.0);", "return vec3(0.0);")]),
    ("glass hides lamps", "ClusteredLamps.rays_to*",
     [(RAYS, "return sees ? hit.transmittance", "return sees ? floor(hit.transmittance)")]),
    ("glass has no colour for lamps", "ClusteredLamps.rays_to*",
     [(RAYS, "return sees ? hit.transmittance", "return sees ? vec3(1.0)")]),
    ("shadows of the weakest lamps", "ClusteredLamps.as_many*",
     [(RAYS, "dot(light, vec3(1.0)) > dot(kept.light[i], vec3(1.0))",
       "kept.light[i] == vec3(0.0) || dot(light, vec3(1.0)) < dot(kept.light[i], vec3(1.0))")]),
    ("rays count the lamp again", "ClusteredLamps.light_is*",
     [(GATHER, "float(!lit_directly(goes_straight ? 0 : bounce, hit.position))", "1.0")]),
    ("lightmap counts the lamp again", "ClusteredLamps.lightmap*",
     [(LIT, "light.x *= unlisted_share(s.player);", "")]),
]
