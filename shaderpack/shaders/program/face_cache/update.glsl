// A sample of the light on each face of this frame's list: the mean of FACE_RAYS rays into the hemisphere, each with a ray
// to a lamp. commit.glsl adds it to the means.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(16, 1, 1);  // idle threads cost as much as busy ones on some drivers

layout(rgba16f) uniform readonly image3D face_light;
layout(rgba16f) uniform writeonly image2D face_fresh;
layout(r32ui) uniform readonly uimage2D face_list;
layout(r32ui) uniform readonly uimage3D face_seen;

#define HAS_VOXEL_READS
const int lamp_candidates = 16;
#include "/include/lights/lamp_sample.glsl"

struct Face {
    ivec3 cell;
    int face;
    Receiver from;
    float sky;  // level where it lies, 0..1
};

/// B and number of updates; nothing where the cell was elsewhere in the frame before.
vec4 light_of(ivec3 cell, int face) {
    if (entered(cell)) return vec4(0.0);
    return trusted(imageLoad(face_light, recent_texel(face_texel(cell, face))));
}

#include "/include/face_cache/path_end.glsl"
#include "/include/gi/thin.glsl"

// Rays more where the light on what one hits is ill known: between the sides of glass one after the other.
const int most_rays_on = 3;

/// Radiance along a cosine ray, which goes on where the light on what it hits is ill known.
vec3 hemisphere_sample(Face f, vec2 u, vec3 light) {
    vec3 from = f.from.origin;
    vec3 direction = cosine_direction(f.from.normal, u);
    vec3 throughput = vec3(1.0);
    vec3 radiance = vec3(0.0);
    Sunlit sunlit = no_sunlit();
    Hit hit;
    for (int ray = 0; ray <= most_rays_on; ++ray) {
        hit = trace_from_face(from, direction);
        throughput *= hit.transmittance;
        // Rays to lamps end at the first small one: what lies behind it is found by rays that pass it, and counts in full.
        radiance += throughput * lamp_light(hit, from, direction) * (ray == 0 ? met_share(hit, f.from, direction) : 1.0);
        bool passes = goes_on(hit);
        if (ray == most_rays_on || !(passes || is_ill_known(hit))) break;
        if (!passes) {
            throughput *= albedo_of(hit);
            choose_sunlit(sunlit, hit, direction, throughput, light);
        }
        begins_on_lamp = !passes && is_on_body(hit);
        from = passes ? point_in_ball(hit, from, direction) : hit.position + hit.normal * face_offset;
        direction = passes ? direction : cosine_direction(hit.normal, next_random().xy);
    }
    begins_on_lamp = false;
    return radiance + end_of_path(hit, from, direction, throughput, sunlit, light, f.sky);
}

/// Updates that count, after an edit in the frame before: none, or a few if edits follow each other.
float trusted_updates(float updates) {
    int last = int(imageLoad(face_list, last_edit).r);
    int before = int(imageLoad(face_list, edit_before).r);
    if (last != frameCounter - 1) return updates;
    return edits_follow(last, before) ? min(updates, face_edited_updates) : 0.0;
}

uint octants_at(ivec3 cell) { return octants_of(voxel_at(cell).code, cell); }

/// Of a face beside a pane or a portal the half on one side of it: the upper one has the place of an inner face. What lies between the
/// sides of a stained pane sees more of every colour than the halves, and is seen through the pane alone.
vec2 half_beside_pane(vec2 at, ivec3 pane, int face) {
    int code = voxel_at(pane).code;
    vec3 axis = parted_axis(code, pane);
    bool parts = dot(face_normal(face), axis) == 0.0;
    float width = 0.5 - (is_portal(code) ? portal_radius : pane_radius);
    return mix(at, at * width + (1.0 - width) * float(face >= face_inner), axis.xz * float(parts));
}

/// A point of a plant that is no hole, if one is found soon. `normal`: of its plane, to the side that shows it.
vec3 point_on_plant(ivec3 cell, int code, vec3 normal) {
    vec2 at = next_random().xy;
    for (int i = 0; i < 4 && is_hole(holes_of_plane(code), at); ++i) at = next_random().xy;
    return vec3(cell) + 0.5 + point_of_plant(at, normal) + face_offset * normal;
}

/// A point of a face; of a plant's, on the plane that looks to `normal`.
vec3 point_of(ivec3 cell, int code, int face, vec3 normal, vec2 at) {
    if (is_plant(code)) return point_on_plant(cell, code, normal);
    if (is_post(code)) return point_of_post(cell, code, face, at);
    if (is_portal(code)) return point_of_side(cell, normal, at) - (0.5 - portal_radius) * normal;
    ivec3 before = cell + ivec3(face_normal(face));
    at = half_beside_pane(at, before, face);
    if (is_full(code)) face &= 7;
    if (code == voxel_lava && face == face_up && !is_whole_lava(cell))
        return point_of_side(cell, vec3(0.0, 1.0, 0.0), at) - vec3(0.0, 1.0 - water_height, 0.0);
    vec3 point = point_of_face(cell, octants_of(code, cell), octants_at(before), face, at);
    int code_before = voxel_at(ivec3(floor(point))).code;
    if (code_before == voxel_lava) return point_above_lava(point, face_normal(face));
    if (is_ball(code_before) && face == face_up) return point_beside_lamp(point, kept_shape(ivec3(floor(point))));
    return is_plate(code_before) ? point_beside_plate(point, code_before, kept_shape(ivec3(floor(point)))) : point;
}

/// The axis along which the light of a face is kept in two halves; 0: it has one value.
ivec3 axis_of_halves(Face f) {
    int code = voxel_at(f.cell).code;
    bool whole = (is_full(code) || code == voxel_translucent) && f.face < face_inner;
    if (!whole) return ivec3(0);
    vec4 own = light_of(f.cell, f.face);
    return halved_axis(f.cell, f.face, face_row(own, f.cell, first_axis(f.face), f.face),
                       face_row(own, f.cell, second_axis(f.face), f.face));
}

/// B / face_unit by this frame's rays, and on how many updates the old light rests; that, less than 0, if they are of the upper
/// half.
vec4 fresh_sample(uint entry, vec3 light) {
    Face f;
    f.cell = packed_cell(entry);
    f.face = packed_face(entry);
    f.from.normal = face_normal(f.face);
    f.sky = entry_level(entry);
    uvec3 place = uvec3(face_texel(f.cell, f.face));
    // Independent numbers: along a sequence, what a face looks up would follow how it came about.
    seed_random(ivec2(place.x + 2048u * place.y, place.z), frameCounter);
    vec3 halves = vec3(axis_of_halves(f));
    Voxel own = voxel_at(f.cell);
    bool shore = is_full(own.code) && is_shore(f.cell, f.face);
    float upper = halves == vec3(0.0) && !shore ? 0.0 : floor(2.0 * next_random().x);
    vec2 shore_span = upper > 0.0 ? vec2(water_height, 1.0) : vec2(0.0, water_height);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < FACE_RAYS; ++i) {
        if (is_plant(own.code)) f.from.normal = plane_through_middle(own.code, int(2.0 * next_random().x));
        f.from.origin = point_of(f.cell, own.code, f.face, f.from.normal, next_random().xy);
        f.from.origin += 0.5 * halves * (upper - dot(f.from.origin - vec3(f.cell), halves));
        if (shore) f.from.origin.y = float(f.cell.y) + mix(shore_span.x, shore_span.y, f.from.origin.y - float(f.cell.y));
        Face seen = f;
        vec3 counts = choose_side(is_thin(own.code), own.color, seen.from.normal);
        seen.from.origin += face_offset * (seen.from.normal - f.from.normal);
        vec3 sampled = counts * (hemisphere_sample(seen, next_random().xy, light) + lamp_sample(seen.from));
        sum += min(sampled, vec3(face_light_max));
    }
    float updates = trusted_updates(light_of(f.cell, f.face + int(upper) * face_inner).a);
    return vec4(sum / (face_unit * float(FACE_RAYS)), upper > 0.0 ? -1.0 - updates : updates);
}

void main() {
    uint count = min(imageLoad(face_seen, listed_faces_texel).r, face_capacity);
    vec3 light = light_direction();
    uint threads = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    uint i = gl_GlobalInvocationID.x;
    if (i < count) do {
        ivec2 slot = face_slot(i);
        imageStore(face_fresh, slot, fresh_sample(imageLoad(face_list, slot).r, light));
    } while ((i += threads) < count);
}
