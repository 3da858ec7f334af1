// One sample of the light on each face of this frame's list: a ray into the hemisphere, and a ray
// to a lamp. Lamps nearer than lamp_near are found by the first, all others by the second, so each
// is counted once.
#include "/settings.glsl"

#define READ_VOXELS
#include "/include/faces/face_cache.glsl"
#include "/include/lighting/hit.glsl"
#include "/include/math/half.glsl"
#include "/include/math/random.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

layout(rgba16f) uniform readonly image3D face_light;
layout(rgba16f) uniform writeonly image2D face_fresh;
layout(r32ui) uniform readonly uimage2D face_list;
layout(r32ui) uniform readonly uimage2D face_tally;
layout(r32ui) uniform readonly uimage2D face_memory;

// Off the face, in blocks. Points of faces are exact, so this can be less than ray_offset.
const float face_offset = 0.001;
// Nearer, sampling the surface of a lamp is noisier than hitting it.
const float lamp_near = 2.0;
// Lamps looked at for each that gets a ray.
const int lamp_candidates = 4;

struct Face {
    ivec3 cell;
    int face;
    vec3 origin;  // of its rays, volume space
    vec3 normal;
    float sky;    // level where it lies, 0..1
};

/// B and number of updates; nothing where the cell was elsewhere in the frame before.
vec4 light_of(ivec3 cell, int face) {
    if (entered(cell)) return vec4(0.0);
    return trusted(imageLoad(face_light, face_texel(cell, face)));
}

/// Point of the face at `at` (0..1), a little off it. Slabs fill half of the height.
vec3 point_of_face(ivec3 cell, int code, vec3 normal, vec2 at) {
    vec3 axis = abs(normal);
    vec3 unit = axis.x > 0.5 ? vec3(0.5, at) : axis.y > 0.5 ? vec3(at.x, 0.5, at.y) : vec3(at, 0.5);
    unit += 0.5 * normal;
    if (code == voxel_slab_bottom) unit.y *= 0.5;
    if (code == voxel_slab_top) unit.y = 0.5 + 0.5 * unit.y;
    return vec3(cell) + unit + normal * face_offset;
}

bool is_near_lamp(Hit hit, vec3 origin) {
    bool ball = hit.voxel.code >= voxel_small_lamp;
    return distance(ball ? vec3(hit.cell) + 0.5 : hit.position, origin) < lamp_near;
}

/// Radiance along a cosine ray.
vec3 hemisphere_sample(Face f, vec2 u, vec3 light) {
    vec3 direction = cosine_direction(f.normal, u);
    Hit hit = trace(f.origin, direction);
    vec3 radiance;
    if (!hit.found) {
        radiance = sky_beyond(direction, f.sky);
    } else if (is_lamp_voxel(hit.voxel.code)) {
        radiance = is_near_lamp(hit, f.origin) ? lamp_light(hit.voxel) : vec3(0.0);
    } else {
        radiance = hit.voxel.color * (sun_at(hit, light, f.sky) +
                                      light_of(hit.cell, face_of(hit.normal)).rgb);
    }
    return hit.transmittance * radiance;
}

struct LampSample {
    ivec3 cell;
    vec3 direction;
    vec3 light;  // what it adds to B if it is seen
};

/// A direction within the cone about `axis` with this cosine.
vec3 cone_direction(vec3 axis, float cosine, vec2 u) {
    float z = mix(cosine, 1.0, u.x);
    vec3 side = normalize(cross(axis, abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    float phi = 2.0 * pi * u.y;
    return axis * z + sqrt(max(0.0, 1.0 - z * z)) *
                          (cos(phi) * side + sin(phi) * cross(axis, side));
}

LampSample sample_ball(Face f, ivec3 cell, vec3 radiance, vec2 u) {
    vec3 way = vec3(cell) + 0.5 - f.origin;
    float far = length(way);
    float cosine = sqrt(1.0 - pow(small_lamp_radius / max(far, lamp_near), 2.0));
    vec3 direction = cone_direction(way / far, cosine, u);
    float share = far < lamp_near ? 0.0 : 2.0 * (1.0 - cosine) * max(0.0, dot(direction, f.normal));
    return LampSample(cell, direction, radiance * share);
}

LampSample sample_cube(Face f, ivec3 cell, int face, vec3 radiance, vec2 u) {
    vec3 normal = face_normal(face);
    vec3 way = point_of_face(cell, voxel_solid, normal, u) - f.origin;
    float far = length(way);
    vec3 direction = way / far;
    float cosines = max(0.0, dot(direction, f.normal)) * max(0.0, -dot(direction, normal));
    float share = far < lamp_near ? 0.0 : cosines / (pi * far * far);
    return LampSample(cell, direction, radiance * share);
}

LampSample sample_lamp(Face f, uint lamps) {
    vec3 u = next_random();
    uint entry = imageLoad(face_list, lamp_slot(min(uint(u.z * float(lamps)), lamps - 1u))).r;
    ivec3 cell = packed_cell(entry);
    vec3 radiance = lamp_light(voxel_at(cell)) * float(lamps);
    if (packed_face(entry) == face_ball) return sample_ball(f, cell, radiance, u.xy);
    return sample_cube(f, cell, packed_face(entry), radiance, u.xy);
}

/// Light of one lamp of a few, chosen by what each would give unhindered (Talbot et al. 2005).
vec3 lamp_sample(Face f) {
    uint lamps = min(imageLoad(face_tally, tally_lamps).r, lamp_capacity);
    if (lamps == 0u) return vec3(0.0);
    LampSample chosen = LampSample(ivec3(0), vec3(0.0), vec3(0.0));
    float sum = 0.0;
    float weight = 0.0;
    for (int i = 0; i < lamp_candidates; ++i) {
        LampSample candidate = sample_lamp(f, lamps);
        float own = dot(candidate.light, vec3(1.0));
        sum += own;
        if (next_random().x * sum < own) {
            chosen = candidate;
            weight = own;
        }
    }
    if (weight <= 0.0) return vec3(0.0);
    Hit hit = trace(f.origin, chosen.direction);
    bool seen = hit.found && hit.cell == chosen.cell;
    return seen ? hit.transmittance * chosen.light * (sum / (weight * float(lamp_candidates)))
                : vec3(0.0);
}

/// Updates that count, after an edit in the frame before: none, or a few if edits follow each other.
float trusted_updates(float updates) {
    int last = int(imageLoad(face_memory, memory_last).r);
    int before = int(imageLoad(face_memory, memory_before).r);
    if (last != frameCounter - 1) return updates;
    return last - before > face_calm_frames ? 0.0 : min(updates, face_edited_updates);
}

vec4 updated(uint entry, vec3 light) {
    Face f;
    f.cell = packed_cell(entry);
    f.face = packed_face(entry);
    f.normal = face_normal(f.face);
    f.sky = packed_sky(entry);
    vec4 old = light_of(f.cell, f.face);

    uvec3 place = uvec3(face_texel(f.cell, f.face));
    // Independent numbers: along a sequence, what a face looks up would follow how it came about.
    seed_random(ivec2(place.x + 1024u * place.y, place.z), frameCounter);
    f.origin = point_of_face(f.cell, voxel_at(f.cell).code, f.normal, next_random().xy);
    vec3 sampled = hemisphere_sample(f, next_random().xy, light) + lamp_sample(f);

    float updates = trusted_updates(old.a);
    float gain = max(1.0 / float(FACE_WINDOW), FACE_GAIN / (updates + FACE_GAIN));
    vec3 mean = mix(old.rgb, min(sampled, vec3(65504.0)), gain);
    return vec4(round_to_half(mean), min(updates + 1.0, 2047.0));
}

void main() {
    uint count = min(imageLoad(face_tally, tally_faces).r, face_capacity);
    vec3 light = light_direction();
    uint threads = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += threads) {
        ivec2 slot = face_slot(i);
        imageStore(face_fresh, slot, updated(imageLoad(face_list, slot).r, light));
    }
}
