"""Mistakes put into the face cache, and the tests that must find them.

For tests/stability/kill_list.py --table; rows as in tests/stability/mutants.py.
"""

UPDATE = "program/s7_face_update.glsl"
COMMIT = "program/s8_face_commit.glsl"
GI = "program/d0_gi.glsl"
CACHE = "include/faces/face_cache.glsl"
VOLUME = "include/voxel/volume.glsl"
LIST = "include/faces/face_list.glsl"

MUTANTS = [
    ("key without direction", "face_cache.closed_wall*",
     [(CACHE, "place.x * 6 + face, place.yz);\n}\n\nint face_of",
       "place.x * 6, place.yz);\n}\n\nint face_of")]),
    ("entered never", "face_cache.teleport*",
     [(VOLUME, "bool entered(ivec3 cell) { return",
       "bool entered(ivec3 cell) { return false &&")]),
    ("buried faces not emptied", "face_cache.teleport*",
     [(COMMIT, "if (!entered(cell)) continue;",
       "continue;")]),
    ("lamp hit and lamp ray both count", "face_cache.lamps_at*",
     [(UPDATE, "is_near_lamp(hit, f.origin) ? lamp_light(hit.voxel) : vec3(0.0)",
       "lamp_light(hit.voxel)")]),
    ("no lamp ray", "face_cache.lamps_at*",
     [(UPDATE, " + lamp_sample(f);",
       ";")]),
    ("shadow ray not traced", "face_cache.closed_wall*",
     [(UPDATE, "bool seen = hit.found && hit.cell == chosen.cell;",
       "bool seen = true;")]),
    ("no albedo in the feedback", "face_cache.one_cell*",
     [(UPDATE, "radiance = hit.voxel.color * (",
       "radiance = (")]),
    ("no feedback", "face_cache.one_cell*",
     [(UPDATE, "light_of(hit.cell, face_of(hit.normal)).rgb",
       "vec3(0.0)")]),
    ("plain mean for ever", "face_cache.removed_lamp*",
     [(UPDATE, "max(1.0 / float(FACE_WINDOW), FACE_GAIN / (updates + FACE_GAIN))",
       "1.0 / (updates + 1.0)")]),
    ("no reset on an edit", "face_cache.removed_lamp*",
     [(UPDATE, "if (last != frameCounter - 1) return updates;",
       "return updates;")]),
    ("no reset when a wall opens", "face_cache.opened*",
     [(UPDATE, "if (last != frameCounter - 1) return updates;",
       "return updates;")]),
    ("no hurry after an edit", "face_cache.removed_lamp*:face_cache.only_a*",
     [(LIST, "entered(cell) || light_changes(imageLoad(face_memory, memory_last).r)",
       "entered(cell)")]),
    ("all faces always", "face_cache.only_a*",
     [(LIST, "% uint(FACE_SHARE) == 0u",
       ">= 0u")]),
    ("pixels keep their mean", "face_cache.picture_follows*",
     [(GI, "before.a = min(before.a, face_edited_updates);",
       ";")]),
    ("moving counts as an edit", "face_cache.teleport*:face_cache.faces_keep*",
     [(COMMIT, "if (now == before || !same || !whole_now || !whole_before) continue;",
       "if (now == before) continue;")]),
    ("edits unnoticed while moving", "face_cache.edits*",
     [(COMMIT, "if (now == before || !same",
       "if (volume_origin() != volume_origin_before() || now == before || !same")]),
    ("checksum without texture", "face_cache.edits*",
     [(LIST, "floatBitsToUint(look.x + 3.0 * look.y)",
       "0u")]),
    ("cells by volume, not by world", "face_cache.faces_keep*",
     [(CACHE, "return wrap(volume_origin() + cell, VOLUME);",
       "return cell;")]),
    ("truncating remainder", "face_cache.faces_keep*",
     [(CACHE, "ivec3 wrap(ivec3 a, int size) { return a - divide_down(a, size) * size; }",
       "ivec3 wrap(ivec3 a, int size) { return abs(a % size); }")]),
    ("quads enter a face again", "face_cache.only_a*",
     [(LIST, "if (!first_of_face(cell, face)) return;",
       "")]),
]
