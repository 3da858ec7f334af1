"""Mistakes in light itself, and the pictures of the path tracer that must show them.

For tests/stability/kill_list.py --table; rows as in tests/stability/mutants.py. Most are too small to see, and none
shows in a test that asks the pack for its own numbers.
"""

UPDATE = "program/face_cache/update.glsl"
GATHER = "include/gi/gather.glsl"
HIT = "include/gi/hit.glsl"
PATH_END = "include/face_cache/path_end.glsl"
OCTANTS = "include/voxels/octants.glsl"
POSTS = "include/voxels/posts.glsl"
VOXEL = "include/voxels/voxel.glsl"
TRACE = "include/voxels/trace.glsl"
HOLES = "include/voxels/holes.glsl"
TILES = "include/voxels/tiles.glsl"
SHADOW = "program/shadow/shadow.glsl"
COMMIT = "program/face_cache/commit.glsl"
LIST = "include/face_cache/due_faces.glsl"
LIGHT_AT = "include/face_cache/light_at.glsl"
TINT = "include/sun/sun_tint.glsl"
LAMP_SAMPLE = "include/lights/lamp_sample.glsl"
TRANSLUCENT = "program/gbuffers/translucent.glsl"
SUN = "include/sun/sun_visibility.glsl"

HOUSE = "Views/Reference.*/house"
HALL = "Views/Reference.*/hall"
BEND = "Views/Reference.*/bend"
CAVE = "Views/Reference.*/cave"
CHAPEL = "Views/Reference.*/chapel"
GLASS = "ReferenceGlass.*"
LEAVES = "ReferenceLeaves.*"
PLANTS = "ReferencePlants.*"
PORTAL = "ReferenceSpot.*portal"
FIRE = "ReferenceSpot.*fire"
MIRROR = "ReferenceMirrorOfWater.*"
ONE = "Views/Reference.*/one_bounce"

MUTANTS = [
    ("albedo times .9", HOUSE, [(VOXEL, "vec3 root = sqrt(clamp(color, 0.0, 1.0));", "vec3 root = sqrt(0.9 * clamp(color, 0.0, 1.0));")]),
    ("red and blue of voxels swapped", BEND, [(VOXEL, "vec3 square = texel.rgb * texel.rgb;", "vec3 square = texel.bgr * texel.bgr;")]),
    ("no feedback", HOUSE, [(UPDATE, "return radiance + end_of_path(", "return radiance + float(!hit.found) * end_of_path(")]),
    ("feedback twice", HOUSE, [(UPDATE, "return radiance + end_of_path(", "return radiance + (hit.found ? 2.0 : 1.0) * end_of_path(")]),
    ("no cache where pixels' rays end", BEND, [(GATHER, "radiance += end_of_path(", "radiance += float(!hit.found) * end_of_path(")]),
    ("sky of rays halved", HALL, [(HIT, "return sky_radiance(direction) *", "return 0.5 * sky_radiance(direction) *")]),
    ("sky by the level where a ray begins", HALL, [(HIT, "(sky_comes_to(hit.position) ? 1.0 : smoothstep(0.0, 0.1, sky))", "smoothstep(0.0, 0.1, sky)")]),
    ("no sky in the face update", HALL, [(UPDATE, "return radiance + end_of_path(", "return radiance + float(hit.found) * end_of_path(")]),
    ("sky in caves below lit floors", "ReferenceCave.*", [(OCTANTS, "height >= lit_floor;", "lit_floor < height_end;")]),
    ("sky in all caves", "ReferenceCave.*", [(HIT, "sky_comes_to(hit.position) ?", "true ?")]),
    ("no sky for pixels", HALL, [(GATHER, "radiance += end_of_path(", "radiance += float(hit.found) * end_of_path(")]),
    ("no sun in the face update", HOUSE, [(UPDATE, "sunlit, light, f.sky)", "sunlit, vec3(0.0, -1.0, 0.0), f.sky)")]),
    ("sun bounce without 1/pi", HOUSE, [(HIT, "(max(slope, 0.0) / pi)", "max(slope, 0.0)")]),
    ("no sun on what pixels' rays hit", HOUSE, [(GATHER, "sunlit, light, s.light.y)", "sunlit, vec3(0.0, -1.0, 0.0), s.light.y)")]),
    ("sun bounce without 1/pi, one bounce", ONE, [(HIT, "(max(slope, 0.0) / pi)", "max(slope, 0.0)")]),
    ("sky of rays halved, one bounce", ONE, [(HIT, "return sky_radiance(direction) *", "return 0.5 * sky_radiance(direction) *")]),
    ("sun through glass by mean alpha", GLASS, [(SHADOW, "textureLod(gtexture, place, 0.0).a < cutout_alpha", "textureLod(gtexture, place, 4.0).a < cutout_alpha")]),
    ("sun through glass by an edge that repeats", GLASS, [(SHADOW, "fract((place - tile.xy) / size)", "clamp((place - tile.xy) / size, 0.0, 1.0)")]),
    ("sun behind stained glass white", GLASS, [(TINT, "blocks_below(texel, depth) > sheet_distance ?", "false ?")]),
    ("sun beside a stained window white", "*ReferenceWindow.*roof", [(HIT, "texel = is_exact && passes && edge.found ? edge.lit : texel;", "")]),
    ("updates look up the slow mean", "*ReferenceRoom.*wool", [(UPDATE, "recent_texel(face_texel(cell, face))", "face_texel(cell, face)")]),
    ("slow means rounded to the next step", "*ReferenceRoom.*", [("program/face_cache/commit.glsl", "dithered_half(mean, chance)", "dithered_half(mean, 0.0)")]),
    ("colours of voxels rounded alike", "*ReferenceRoom.*wool", [(SHADOW, "float(hash(place).y >> 8u) * (1.0 / 16777216.0)", "0.5")]),
    ("lava in a cell is not met from inside", "*ReferenceRoom.*lava*", [(TRACE, "if (code == voxel_lava) met =", "if (code == voxel_lava && !begins) met =")]),
    ("faces beside lava lit as if they were whole", "*ReferenceRoom.*lava*", [(UPDATE, "if (code_before == voxel_lava) return", "if (false) return")]),
    ("top of lava lit as if it were the cell's", "*ReferenceRoom.*lava*", [(UPDATE, "if (code == voxel_lava && face == face_up", "if (false && face == face_up")]),
    ("water fills what lies below its bottom", "ReferenceGlass.*water", [("program/voxels/lakes.glsl", "if (water.a > 0.0 && (kept_shape", "if (false && (kept_shape")]),
    ("sun behind water white", "ReferenceGlass.*water", [(SHADOW, "id == block_water ? water_height : 0.0", "0.0")]),
    ("glass is nothing to shadow volumes", GLASS, [(SUN, "lit *= open_share(player, normal, light);", "")]),
    ("lava green", CAVE, [("include/blocks.glsl", "vec3(1.0, 0.34, 0.06));  // 9", "vec3(0.34, 1.0, 0.06));  // 9")]),
    ("lamp levels linear", "ReferenceSpot.*torch", [(VOXEL, "EMISSION_STRENGTH * share * share", "EMISSION_STRENGTH * share")]),
    ("stained panes stop rays", CHAPEL, [(SHADOW, "voxel_tinted_pane + int(abs(normal.z) > 0.5)", "voxel_solid")]),
    ("stained panes tint by the distance in their cell", "ReferenceSpot.*behind_stained_panes", [(TRACE, "return is_tinted_pane(code) ? crossed :", "return false ? crossed :")]),
    ("one value for both sides of a stained pane", "ReferenceSpot.*behind_stained_panes", [(TRACE, "return beside && dot(hit.position - cell, axis) > 0.5;", "return false;")]),
    ("stained panes tint across the other axis", "ReferenceSpot.*behind_stained_panes", [(VOXEL, "(code & 1) == 1 ? vec3(1.0, 0.0, 0.0)", "(code & 1) == 0 ? vec3(1.0, 0.0, 0.0)")]),
    ("panes of one side", "ReferenceSpot.*behind_panes", [(TRACE, "if (passes && is_pane(code)) {", "if (false) {")]),
    ("one hole in the middle of a pane", "ReferenceSpot.*before_a_lamp", [(TRACE, "if (is_glass(code) || is_pane(code)) return", "if (is_glass(code)) return")]),
    ("holes of panes by mean alpha", "ReferenceSpot.*behind_panes", [(HOLES, "per_block * at, 0.0)", "per_block * at, 4.0)")]),
    ("glass sends no rays", "ReferenceSpot.*glass_*_the_shadow*",
     [(TRANSLUCENT, "float share = inside_volume(to_volume(player));", "float share = 0.0;")]),
    ("what gathered for glass is blended", "ReferenceSpot.*glass_*_the_shadow*",
     [("shaders.properties", "blend.gbuffers_water.colortex12 = off", "")]),
    ("holes of one row of glass in the next", "ReferenceSky.*/glass", [(HOLES, "texel.y >> 1u, 0", "0, 0")]),
    ("light within panes by their outer side", "ReferenceSunlitPanes.light*", [(HIT, " || is_within_pane(hit)", "")]),
    ("rays from within a pane pass its sides", "ReferenceSunlitPanes.light*", [(TRACE, "(t > 0.0 || begins)", "t > 0.0")]),
    ("panes beside a point do not shade it", "ReferenceSunlitPanes.shade*", [(HIT, "boxes = near_pane || beside_glass;", "boxes = near_pane;")]),
    ("panes alone shade what is beside them", "ReferenceSunlitPanes.stand*", [(HIT, "is_stopped(from, light, is_exact, boxes)", "is_stopped(from, light, false, boxes)")]),
    ("tint beside a stained pane by the map's texels", "ReferenceSunlitPanes.tint*", [(HIT, "beside_stained || tint != vec3(1.0) ? tint : mapped", "mapped")]),
    ("holes of leaves unknown", "ReferenceSpot.*by_a_hole", [(SHADOW, " || is_thin(code) || is_fire(code)) {", " || is_fire(code)) {")]),
    ("no ground beyond the volume", "ReferenceGround.*", [(PATH_END, "if (ground.code != voxel_solid || !near || !is_there)", "if (true)")]),
    ("ground beyond the volume wherever there is none", "ReferenceGround.*", [(PATH_END, "|| !near || !is_there)", "|| !near)")]),
    ("ground beyond the volume has the colour of that within", "ReferenceGround.*", [(PATH_END, "if (above < 0.75 &&", "if (false &&")]),
    ("ground at the roof", "ReferenceGround.*", [(OCTANTS, "return position.y > highest ? highest : lit_floor;", "return highest;")]),
    ("rays stop at leaves", LEAVES, [(TRACE, "met = meet_planes(walk, code, begins);", "met = code == voxel_leaves ? Meeting(true, span.x, vec3(0.0)) : meet_crossed(walk, code);")]),
    ("leaves have no inside", LEAVES, [(TRACE, "bool drawn = is_fire(code) || beyond == voxel_leaves || !is_full(beyond);", "const bool drawn = false;")]),
    ("leaves are lit from outside", LEAVES, [(UPDATE, "choose_side(is_thin(own.code),", "choose_side(false,")]),
    ("sun on the outside of leaves alone", LEAVES, [(HIT, "hit.normal *= slope < 0.0 ? -1.0 : 1.0;\n        slope = abs(slope);", "")]),
    ("rays pass plants", PLANTS, [(TRACE, "met = meet_planes(walk, code, begins);", "met = code == voxel_leaves || begins ? meet_planes(walk, code, begins) : Meeting(false, 0.0, vec3(0.0));")]),
    ("rays from beside plants pass them", PLANTS, [(TRACE, "met = meet_planes(walk, code, begins);", "met = code == voxel_leaves || !begins ? meet_planes(walk, code, begins) : Meeting(false, 0.0, vec3(0.0));")]),
    ("plants have no holes", PLANTS, [(TRACE, " && !is_hole(holes_of_plane(code), at)", "")]),
    ("plants upside down", PLANTS, [(POSTS, "0.5, 0.5 - off.y)", "0.5, 0.5 + off.y)")]),
    ("plants reflect nothing", PLANTS, [(SHADOW, "is_plant(code) ? face_of_plant : inner", "inner")]),
    ("plants are lit from one side", PLANTS, [(UPDATE, "choose_side(is_thin(own.code),", "choose_side(own.code == voxel_leaves,")]),
    ("fire is a cube", FIRE, [(SHADOW, "if (id == block_soul_fire) return", "if (false) return")]),
    ("planes of fire as bright as its cube", FIRE, [(HIT, "return open / max(shown, 1e-3);", "return is_fire(code) ? 1.0 : open / max(shown, 1e-3);")]),
    ("sides of fire have no holes", FIRE, [(TRACE, "return outward.y != 0.0 || in_hole_of_plane(code, within - 0.5, toward);", "return outward.y != 0.0;")]),
    ("fire has a roof", FIRE, [(TRACE, "return outward.y != 0.0 || in_hole", "return in_hole")]),
    ("fire has no planes through its middle", FIRE, [(TRACE, "if (is_plant(code) || is_fire(code)) {", "if (is_plant(code)) {")]),
    ("rays that begin within fire pass it", FIRE, [(TRACE, "!(begins && is_fire(code) && begins_on_lamp)", "!(begins && is_fire(code))")]),
    ("rays to lamps find the drawn sides of fire alone", FIRE, [(SHADOW, "is_cube = is_fire(code) || (code", "is_cube = (code")]),
    ("rays to lamps look for fire from within", FIRE, [(LAMP_SAMPLE, "hit.cell == ivec3(floor(r.origin))) density = 0.0;", "false) density = 0.0;")]),
    ("portals are cubes", PORTAL, [(SHADOW, "if (id == block_portal) return", "if (false) return")]),
    ("planes of a portal as bright as its cube", PORTAL, [(HIT, "return open / max(shown, 1e-3);", "return is_portal(code) ? 1.0 : open / max(shown, 1e-3);")]),
    ("rays to lamps look for portals on the sides of their cell", PORTAL, [(LAMP_SAMPLE, "is_portal(code) ? normal * (0.5 - portal_radius) : vec3(0.0)", "vec3(0.0)")]),
    ("one value for both sides of a portal", PORTAL, [(OCTANTS, "return is_partition(code) ?", "return is_tinted_pane(code) ?")]),
    ("water mirrors no sky through openings", "ReferenceMirrorOfWater.*opening", [(TRANSLUCENT, "light_of_end(hit, from, direction, light.y);", "(hit.found ? light_of_end(hit, from, direction, light.y) : sky_radiance(direction) * light.y * light.y);")]),
    ("mirrored glass hides what is behind it", MIRROR, [(TRANSLUCENT, "share *= 1.0 - alpha;", "share = 0.0;")]),
    ("mirrored glass tints what is behind it", MIRROR, [(TRACE, "if (as_drawn && depth > 0.0", "if (false && depth > 0.0"), (TRACE, "if (!as_drawn) hit", "hit")]),
    ("one alpha for mirrored glass", MIRROR, [(TRANSLUCENT, "textureLod(gtexture, place, 0.0).a", "textureLod(gtexture, place, 4.0).a")]),
    ("mirrored glass has the texture beside it", MIRROR, [(TILES, "part.x << 8", "part.x + 1u << 8")]),
    ("mirrored panes in a row are one", MIRROR, [(TRACE, "|| is_tinted_pane(code) ||", "||")]),
    ("mirrored glass before glass is one", MIRROR, [(TRACE, "(code == voxel_translucent && other_color)", "false")]),
    ("mirrored panes lie on the side of their cell", MIRROR, [(TRACE, "return Meeting(is_tinted_pane(code), max(t, span.x), axis);", "return Meeting(false, 0.0, axis);")]),
    ("textures of panes by their parts", MIRROR, [(SHADOW, "if (id == block_pane || id == block_tinted_pane) {", "if (id == block_pane) {")]),
    ("stained panes tint in their middle", "ReferenceSpot.*between_the_sides*", [(TRACE, "pane_radius * dot(abs(inverse), axis)", "0.0")]),
    ("stained panes of the next cell tint nothing", "ReferenceSunlitPanes.tint*", [(HIT, ": beside_stained ? 2.0 : 0.0;", ": beside_stained ? 1e-4 : 0.0;")]),
    ("one value a face", "ReferenceCorner.*", [(LIGHT_AT, "return vec4(light * rise, u.own.a);", "return vec4(light, u.own.a);")]),
    ("light falls the other way over a face", "ReferenceCorner.*", [(LIGHT_AT, "rise_along(dot(off, vec3(first_axis(face))), u)", "rise_along(-dot(off, vec3(first_axis(face))), u)")]),
    ("the sides of an opening have one value", "ReferenceOpening.*", [(LIGHT_AT, "bool alone = is_alone(u) || is_alone(v);", "bool alone = false;")]),
    ("the lower half alone is sampled", "ReferenceOpening.*", [(UPDATE, "floor(2.0 * next_random().x)", "0.0")]),
    ("samples of halves are of the whole side", "ReferenceOpening.*", [(UPDATE, "0.5 * halves * (upper", "0.0 * halves * (upper")]),
    ("the upper half enters the lower one", "ReferenceOpening.*", [(COMMIT, "bool upper = fresh.a < 0.0;", "bool upper = false;")]),
    ("halves along the other axis", "ReferenceOpening.*", [(LIGHT_AT, "(is_open || !is_alone(v)) ? along", "!(is_open || !is_alone(v)) ? along")]),
    ("opposite sides share a half", "ReferenceOpening.*", [(LIGHT_AT, " || light_of(cell, face ^ 1).a > 0.0", "")]),
    ("light of halves falls the other way", "ReferenceOpening.*", [(LIGHT_AT, "(at - 0.25 * sign(at)) * clamp", "-(at - 0.25 * sign(at)) * clamp")]),
    ("ends of stained panes tint nothing", "ReferenceStainedPane.*", [(TRACE, " || (!goes_on && center + half_way > span.x)", "")]),
    ("stained panes tint anew in each cell", "ReferenceSpot.*behind_stained_panes", [(TRACE, "filter_depth(code, last_code == code,", "filter_depth(code, false,")]),
    ("panes part no light", "ReferenceSky.*/low_panes", [(OCTANTS, "arms = kept_shape(cell) & arms_of_pane;", "arms = 0u;")]),
    ("faces beside a pane have a lower half only", "ReferenceSky.*/low_panes", [(LIST, "more = is_cube || parted != vec3(0.0) ? 6 : 0;", "more = is_cube ? 6 : 0;")]),
    ("both halves beside a pane lit alike", "ReferenceSky.*/low_panes", [(UPDATE, "bool parts = dot(face_normal(face), axis) == 0.0;", "bool parts = false;")]),
    ("light within glass by its outer side", "ReferenceGlazedRoom.*", [(HIT, "return is_on_body(hit) || is_glass(hit.voxel.code) ||", "return is_on_body(hit) ||")]),
    ("parts of a pane have edges of their own", "ReferencePanes.*", [(SHADOW, "if (id == block_pane || ", "if (")]),
    ("balls of small lamps stop light", "ReferenceSmallLamp.balls*", [(HIT, "return hit.found && is_ball(hit.voxel.code) && !hit.inner;", "return false;")]),
    ("bodies of small lamps are black", "ReferenceSmallLamp.balls*", [(HIT, "0.3 * sqrt(brightest(hit.voxel.color))", "vec3(0.0)")]),
    ("after a body faces see no lamp beside them", "ReferenceSmallLamp.body*", [(UPDATE, "    begins_on_lamp = false;\n", "")]),
    ("campfires have no logs", "ReferenceSmallLamp.logs*", [(POSTS, "on_logs ? lamp_logs : 0u", "0u")]),
    ("small lamps have no body", "ReferenceSmallLamp.body*", [(POSTS, "code == voxel_cover || is_ball(code) ?", "code == voxel_cover ?")]),
    ("halves beside a pane reach to its middle", "ReferencePaneInWindow.*", [(UPDATE, "float width = 0.5 - (is_portal(code) ? portal_radius : pane_radius);", "float width = 0.5;"), (HIT, "return between || stained;", "return stained;")]),
    ("between the sides of a pane the light of a half", "ReferencePaneInWindow.*", [(HIT, "return between || stained;", "return stained;")]),
    ("faces within stained glass have one light", "ReferenceGlassWall.*", [(HIT, "return between || stained;", "return between;")]),
    ("snow as thin as a carpet", "ReferenceSnow.*",
     [(POSTS, "return bit == 0 ? 0.0625 : 0.125 * float(bit);", "return 0.0625;")]),
    ("snow has the height of its underside", "ReferenceSnow.*",
     [(POSTS, "normal.y < 0.0 ? 0u : part_of_cover(high.y + 0.5)", "part_of_cover(0.0)")]),
    ("rays go on from near hits once", "ReferenceCorner.rays_go_on*",
     [(GATHER, "bool is_near = distance", "bool is_near = bounce == 0 && distance")]),
    ("one ray between the sides of glass", "ReferenceGlassInWindow.*", [(GATHER, "bounce == gi_bounces - 1 || !(is_near", "bounce == 1 || !(is_near"), (UPDATE, "most_rays_on = 3", "most_rays_on = 1")]),
    ("the edge of water has one light", "ReferenceShore.*", [(LIGHT_AT, "if (above.a > 0.0) return above.rgb;", "")]),
    ("the edge of water is sampled below it", "ReferenceShore.*", [(UPDATE, "upper > 0.0 ? vec2(water_height, 1.0) : vec2(0.0, water_height)", "vec2(0.0, water_height)")]),
    ("sides of stained glass are sampled whole", "ReferenceGlassBesideGlass.*", [(UPDATE, "(is_full(code) || code == voxel_translucent)", "is_full(code)")]),
    ("sides in stained glass have one value", "ReferenceGlassBesideGlass.*", [(LIGHT_AT, " && code != voxel_translucent", "")]),
    ("paths of sunlight in glass by the map", "ReferenceLowSun.*", [(HIT, "beside_stained || tint != vec3(1.0) ? tint : mapped", "beside_stained ? tint : mapped")]),
    ("low sun through panes by texels of the map", "ReferenceLowSun.*panes*", [(HIT, "bool by_glass = edge.dark && ", "bool by_glass = false && ")]),
    ("low sun through glass by texels of the map", "ReferenceLowSun.*_glass_by_its_holes", [(HIT, "is_clear(voxel_at(ivec3(floor(caster - 0.1 * light))).code)", "is_pane(voxel_at(cell).code)")]),
    ("sunlight by the exact ray before glass, too", "ReferenceGlazedRoom.*", [(HIT, "is_clear(voxel_at(ivec3(floor(caster - 0.1 * light))).code)", "(is_clear(voxel_at(ivec3(floor(caster - 0.1 * light))).code) || is_clear(voxel_at(ivec3(floor(caster + 0.1 * light))).code))")]),
    ("sunlight within a window meets no glass", "ReferenceGlazedRoom.*", [(HIT, "boxes = near_pane || beside_glass;", "boxes = near_pane;")]),
    ("light falls by as much everywhere", "ReferenceCorner.*factor*", [(LIGHT_AT, "return exp2(at * powers) / mean;", "return 1.0 + clamp(at * 0.6931 * powers, -0.5, 0.5);")]),
    ("low sun through panes without holes of their own", "ReferenceLowSun.*holes", [(TRACE, "(beyond && is_clear(code))", "false")]),
]
