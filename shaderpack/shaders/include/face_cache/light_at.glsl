// Light at a place on a face, from its mean and those of the faces beside it in its plane, or from the means of its halves. The
// program has light_of(cell, face), B of a face and its number of updates.
#if !defined INCLUDED_FACE_CACHE_LIGHT_AT
#define INCLUDED_FACE_CACHE_LIGHT_AT

#include "/include/face_cache/face_cache.glsl"
#include "/include/gi/hit.glsl"

/// B of the face of a cell, as far as it is in the volume.
vec4 known_light(ivec3 cell, int face) { return in_volume(cell) ? light_of(cell, face) : vec4(0.0); }

/// A face and those beside it along an axis of its plane.
struct FaceRow {
    vec4 own;
    vec4 next;
    vec4 last;
};

FaceRow face_row(vec4 own, ivec3 cell, ivec3 along, int face) {
    return FaceRow(own, known_light(cell + along, face), known_light(cell - along, face));
}

bool is_alone(FaceRow row) { return max(row.next.a, row.last.a) == 0.0; }

/// How many powers of two B rises by from one face to the next; at an end as from the last one to this.
vec3 powers_of_light(FaceRow row) {
    const vec3 dark = vec3(1e-8);
    vec3 own = max(row.own.rgb, dark);
    vec3 next = row.next.a > 0.0 ? max(row.next.rgb, dark) : own;
    vec3 last = row.last.a > 0.0 ? max(row.last.rgb, dark) : own;
    float steps = float(row.next.a > 0.0) + float(row.last.a > 0.0);
    return clamp(log2(next / last) / max(steps, 1.0), -4.0, 4.0);
}

/// The axes of a face's plane.
ivec3 first_axis(int face) { return (face & 7) >> 1 == 0 ? ivec3(0, 1, 0) : ivec3(1, 0, 0); }
ivec3 second_axis(int face) { return (face & 7) >> 1 == 2 ? ivec3(0, 1, 0) : ivec3(0, 0, 1); }

/// The axis along which the light of a face that has none beside it, as the sides of an opening in a wall of one block, is kept
/// in two halves, the upper one at the place of an inner face; else 0. Not if the block shows its opposite side, too, whose
/// upper half would have that place, nor before what is neither air nor stained glass.
ivec3 halved_axis(ivec3 cell, int face, FaceRow u, FaceRow v) {
    bool alone = is_alone(u) || is_alone(v);
    if (!alone || u.own.a == 0.0 || light_of(cell, face ^ 1).a > 0.0) return ivec3(0);
    ivec3 before = cell + ivec3(face_normal(face));
    int code = voxel_at(before).code;
    if (code != voxel_air && code != voxel_translucent) return ivec3(0);
    ivec3 along = first_axis(face);
    bool is_open = !is_full(voxel_at(before + along).code) && !is_full(voxel_at(before - along).code);
    return is_alone(u) && (is_open || !is_alone(v)) ? along : second_axis(face);
}

/// Is the face a side at the edge of water, whose part above the surface keeps its light at the place of an inner face? Not if
/// the block shows its opposite side, too, as in halved_axis.
bool is_shore(ivec3 cell, int face) {
    ivec3 before = cell + ivec3(face_normal(face));
    bool beside = face < face_inner && face_normal(face).y == 0.0 && voxel_at(before).code == voxel_water_surface;
    return beside && light_of(cell, face ^ 1).a == 0.0;
}

vec3 place_on_face(vec3 position, ivec3 cell) { return clamp(position - vec3(cell) - 0.5, vec3(-0.5), vec3(0.5)); }

/// How much more of a face's light there is at a place `at`, -0.5 to 0.5, along an axis: it rises by as many powers of two,
/// since from block to block light falls by a factor, with the face's B as its mean.
vec3 rise_along(float at, FaceRow row) {
    vec3 powers = powers_of_light(row);
    vec3 half_way = 0.34657 * powers;  // ln 2 / 2
    vec3 mean = 1.0 + half_way * half_way * (1.0 / 6.0 + half_way * half_way / 120.0);  // sinh(x) / x
    return exp2(at * powers) / mean;
}

/// B at a place `at`, -0.5 to 0.5, along the axis of two halves, on a line that has theirs.
vec3 light_of_halves(float at, vec3 lower, vec4 upper) {
    vec3 rise = upper.a > 0.0 ? upper.rgb - lower : vec3(0.0);
    vec3 half_light = at > 0.0 ? lower + rise : lower;
    return half_light + (at - 0.25 * sign(at)) * clamp(2.0 * rise, -4.0 * half_light, 4.0 * half_light);
}

/// B at a place on a face (volume space) that fills a side of its cell, and its number of updates.
vec4 light_at(vec3 position, ivec3 cell, int face) {
    vec4 own = light_of(cell, face);
    FaceRow u = face_row(own, cell, first_axis(face), face);
    FaceRow v = face_row(own, cell, second_axis(face), face);
    vec3 off = place_on_face(position, cell);
    vec3 axis = vec3(0.0);
    if (is_alone(u) || is_alone(v)) axis = vec3(halved_axis(cell, face, u, v));
    vec3 light = u.own.rgb;
    if (axis != vec3(0.0))
        light = light_of_halves(dot(off, axis), light, light_of(cell, face + face_inner));
    vec3 rise = rise_along(dot(off, vec3(first_axis(face))), u) * rise_along(dot(off, vec3(second_axis(face))), v);
    return vec4(light * rise, u.own.a);
}

/// B where a ray hits. Beside a pane a face has two halves, and parts of blocks have faces of other sizes: these have their
/// means alone.
vec3 light_of_face(Hit hit) {
    int face = face_of_hit(hit);
    ivec3 before = hit.cell + ivec3(hit.normal);
    bool whole = is_full(hit.voxel.code) && !hit.inner && parted_axis(voxel_at(before).code, before) == vec3(0.0);
    if (!whole) return light_of(hit.cell, face).rgb;
    vec4 above = vec4(0.0);
    if (hit.position.y - float(hit.cell.y) > water_height) {
        if (is_shore(hit.cell, face)) above = light_of(hit.cell, face + face_inner);
    }
    if (above.a > 0.0) return above.rgb;
    return light_at(hit.position, hit.cell, face).rgb;
}

/// B where a ray hits, as far as it comes to the hit. What is drawn of a small lamp has no faces: in their places is what faces
/// of a block that stood there got.
vec3 light_on(Hit hit) {
    float share = is_on_body(hit) ? 0.0 : 1.0;
    if (is_within_pane(hit)) share = open_share(holes_of_side(hit.voxel.code, face_of(hit.normal)));
    return share * light_of_face(hit);
}

#endif
