// Adds the new samples of the listed faces to their means, empties the cells that came into the volume,
// and notes whether the blocks have changed, or the eye moved.
#include "/settings.glsl"

#include "/include/face_cache/face_cache.glsl"
#include "/include/gi/rest.glsl"
#include "/include/math/half.glsl"
#include "/include/math/random.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(16, 1, 1);

layout(rgba16f) uniform image3D face_light;
layout(rgba16f) uniform readonly image2D face_fresh;
layout(r32ui) uniform uimage2D face_list;
layout(r32ui) uniform readonly uimage2D voxel_sums;
layout(r32ui) uniform uimage2D face_memory;
layout(r32ui) uniform readonly uimage3D face_seen;

// Quick enough for a room of albedo .9 to come to rest in a hundred updates, and slow enough to take half of the noise.
const float recent_gain = 0.25;

/// `old` as stored, `sampled` as in face_fresh. Rounded up or down by chance: a slow mean moves by less than a step of half
/// floats, and would stay where it is.
vec4 mean_with(vec4 old, vec4 sampled, float gain, float chance) {
    vec3 mean = mix(trusted(old).rgb / face_unit, sampled.rgb, gain);
    return vec4(dithered_half(mean, chance), min(sampled.a + 1.0, 2047.0));
}

void add_sample(ivec3 texel, vec4 sampled) {
    uvec3 chance = hash(uvec3(texel.x + 2048 * texel.y, texel.z, frameCounter)) >> 8u;
    vec2 at = vec2(chance.xy) * (1.0 / 16777216.0);
    float gain = max(1.0 / float(FACE_WINDOW), FACE_GAIN / (sampled.a + FACE_GAIN));
    imageStore(face_light, texel, mean_with(imageLoad(face_light, texel), sampled, gain, at.x));
    texel = recent_texel(texel);
    imageStore(face_light, texel, mean_with(imageLoad(face_light, texel), sampled, max(gain, recent_gain), at.y));
}

void commit_faces(uint first, uint stride) {
    uint count = min(imageLoad(face_seen, listed_faces_texel).r, face_capacity);
    for (uint i = first; i < count; i += stride) {
        uint entry = imageLoad(face_list, face_slot(i)).r;
        vec4 fresh = imageLoad(face_fresh, face_slot(i));
        bool upper = fresh.a < 0.0;
        fresh.a = upper ? -1.0 - fresh.a : fresh.a;
        add_sample(face_texel(packed_cell(entry), packed_face(entry) + int(upper) * face_inner), fresh);
    }
}

/// Does the texel of the face belong to one of the list? Inner faces share theirs with those that look back.
bool is_listed(uint listed, int face) {
    return (listed >> uint(face) & 1u) == 1u ||
           (face >= face_inner && (listed >> uint(face ^ 1) & 1u) == 1u);
}

/// Faces that are covered now may be uncovered later, and must not show the light of the place that
/// had their texel before.
void empty_entered_cells(uint first, uint stride) {
    if (volume_origin() == volume_origin_before()) return;
    for (uint i = first; i < uint(VOLUME * VOLUME * VOLUME); i += stride) {
        ivec3 cell = ivec3(i % uint(VOLUME), i / uint(VOLUME) % uint(VOLUME),
                           i / uint(VOLUME * VOLUME));
        if (!entered(cell)) continue;
        uint listed = imageLoad(face_seen, cell).r;
        for (int face = 0; face < face_inner + 6; ++face)
            if (face != face_ball && face != 7 && !is_listed(listed, face)) {
                imageStore(face_light, face_texel(cell, face), vec4(0.0));
                imageStore(face_light, recent_texel(face_texel(cell, face)), vec4(0.0));
            }
    }
}

/// World brick that has this place in a volume. It is whole if all of its cells are inside.
ivec3 brick_at(ivec3 place, ivec3 origin, out bool whole) {
    ivec3 lowest = divide_down(origin, ivec3(brick_size));
    ivec3 brick = lowest + wrap(place - lowest, bricks);
    whole = all(greaterThanEqual(brick * brick_size, origin));
    return brick;
}

/// Bricks at the edge change when the volume moves, which is no edit.
void compare_bricks(uint first, uint stride) {
    for (uint i = first; i < uint(brick_count); i += stride) {
        ivec2 texel = ivec2(int(i), 0);
        uint now = imageLoad(voxel_sums, texel).r;
        uint before = imageLoad(face_memory, texel).r;
        imageStore(face_memory, texel, uvec4(now));

        ivec3 place = brick_place(int(i));
        bool whole_now, whole_before;
        ivec3 brick = brick_at(place, volume_origin(), whole_now);
        bool same = brick == brick_at(place, volume_origin_before(), whole_before);
        if (now == before || !same || !whole_now || !whole_before) continue;

        // The first to notice moves the frame of the last edit on.
        uint frame = uint(frameCounter);
        uint last = imageAtomicExchange(face_list, last_edit, frame);
        if (last != frame) imageStore(face_list, edit_before, uvec4(last));
    }
}

void note_motion() {
    if (gl_GlobalInvocationID.x == 0u && !camera_is_still())
        imageStore(face_list, last_motion, uvec4(uint(frameCounter)));
}

void main() {
    note_motion();
    uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    commit_faces(gl_GlobalInvocationID.x, stride);
    empty_entered_cells(gl_GlobalInvocationID.x, stride);
    compare_bricks(gl_GlobalInvocationID.x, stride);
}
