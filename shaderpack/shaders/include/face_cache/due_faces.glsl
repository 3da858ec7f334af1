// The shadow pass' part of the face cache: each quad of a block enters its face into the lists. With a fourth image Mesa (22.3)
// would not find the stage in its cache and compile it at each start, which takes .7 s.
#if !defined INCLUDED_FACE_CACHE_FACE_LIST
#define INCLUDED_FACE_CACHE_FACE_LIST

#include "/include/face_cache/face_cache.glsl"
#include "/include/math/random.glsl"
#include "/include/voxels/voxel.glsl"

layout(r32ui) uniform uimage2D face_list;
layout(r32ui) uniform uimage3D face_seen;

/// In how many frames each face is updated once: FACE_SHARE, sooner while the light changes.
uint share_of_faces() {
    int last = int(imageLoad(face_list, last_edit).r);
    if (!light_changes(uint(last))) return uint(FACE_SHARE);
    return edits_follow(last, int(imageLoad(face_list, edit_before).r)) ? min(uint(FACE_SHARE), 2u) : 1u;
}

/// Is the face among those of this frame? All are when they are new.
bool is_due(ivec3 cell, int face) {
    if (entered(cell)) return true;
    ivec3 place = store_cell(cell);
    uint turn = hash(uvec3(place.x * 6 + face, place.yz)).x >> 8;
    return (turn + uint(frameCounter)) % share_of_faces() == 0u;
}

/// Enters a face once, however many quads it has.
bool first_of_face(ivec3 cell, int face) {
    uint bit = 1u << uint(face);
    return (imageAtomicOr(face_seen, cell, bit) & bit) == 0u;
}

void enter_face(uint entry) {
    uint slot = imageAtomicAdd(face_seen, listed_faces_texel, 1u);
    if (slot < face_capacity) imageStore(face_list, face_slot(slot), uvec4(entry));
}

void enter_lamp(uint entry) {
    uint slot = imageAtomicAdd(face_seen, listed_lamps_texel, 1u);
    if (slot < lamp_capacity) imageStore(face_list, lamp_slot(slot), uvec4(entry));
}

/// Lamps are faces, too: they reflect what light they get.
void list_face(ivec3 cell, int face, int code, int sky) {
    bool lamp = is_lamp_voxel(code);
    if (is_ball(code)) face = face_ball;
    bool due = face != face_ball && is_due(cell, face);
    if (!lamp && !due) return;
    if (!first_of_face(cell, face)) return;
    if (lamp) enter_lamp(pack_face(cell, face, level_of_lamp(code)));
    if (due) enter_face(pack_face(cell, face, sky));
}

/// The face of a quad, and what else it stands for. `is_cube`: all sides of a lamp that planes inside its cell draw, as fire does:
/// rays meet a cube, that of fire with holes, and what a ray into the hemisphere leaves to rays to lamps must be found by these on
/// every side. `parted`: the upper halves of the faces beside a pane or a portal that lies across this axis, should there be
/// blocks; 0: of none. One loop: drivers run each copy of its body for every quad.
void list_faces(ivec3 cell, int face, int code, int sky, bool is_cube, vec3 parted) {
    int more = is_cube || parted != vec3(0.0) ? 6 : 0;
    int i = 0;
    do {
        vec3 normal = face_normal(i - 1);
        bool is_half = i > 0 && !is_cube;
        ivec3 there = is_half ? cell - ivec3(normal) : cell;
        int listed = i == 0 ? face : is_half ? i - 1 + face_inner : i - 1;
        if (!is_half || (dot(normal, parted) == 0.0 && in_volume(there)))
            list_face(there, listed, is_half ? voxel_solid : code, sky);
    } while (++i <= more);
}

#endif
