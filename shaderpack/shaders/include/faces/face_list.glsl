// The shadow pass' part of the face cache: each quad of a block enters its face into the lists.
#if !defined INCLUDED_FACES_FACE_LIST
#define INCLUDED_FACES_FACE_LIST

#include "/include/faces/face_cache.glsl"
#include "/include/math/random.glsl"
#include "/include/voxel/voxel.glsl"

layout(r32ui) uniform writeonly uimage2D face_list;
layout(r32ui) uniform uimage2D face_tally;
layout(r32ui) uniform readonly uimage2D face_memory;
layout(r32ui) uniform uimage3D face_seen;

/// Is the face among those of this frame? All are when they are new or the light has changed.
bool is_due(ivec3 cell, int face) {
    if (entered(cell) || light_changes(imageLoad(face_memory, memory_last).r)) return true;
    ivec3 place = store_cell(cell);
    uint turn = hash(uvec3(place.x * 6 + face, place.yz)).x >> 8;
    return (turn + uint(frameCounter)) % uint(FACE_SHARE) == 0u;
}

/// Enters a face once, however many quads it has.
bool first_of_face(ivec3 cell, int face) {
    uint bit = 1u << uint(face);
    return (imageAtomicOr(face_seen, cell, bit) & bit) == 0u;
}

void list_face(ivec3 cell, int face, int code, int sky) {
    bool lamp = is_lamp_voxel(code);
    if (code >= voxel_small_lamp) face = face_ball;
    if (!lamp && !is_due(cell, face)) return;
    if (!first_of_face(cell, face)) return;
    uint slot = imageAtomicAdd(face_tally, lamp ? tally_lamps : tally_faces, 1u);
    if (slot >= (lamp ? lamp_capacity : face_capacity)) return;
    imageStore(face_list, lamp ? lamp_slot(slot) : face_slot(slot),
               uvec4(pack_face(cell, face, lamp ? code & 15 : sky)));
}

#endif
