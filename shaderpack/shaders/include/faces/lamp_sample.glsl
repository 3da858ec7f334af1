// Light of one lamp, drawn at random from the list of the shadow pass, by a ray to it. Lamps nearer
// than lamp_near are left to rays into the hemisphere, which find them more surely, and there no
// others may count: see met_lamp. The images face_list and face_tally belong to the program.
#if !defined INCLUDED_FACES_LAMP_SAMPLE
#define INCLUDED_FACES_LAMP_SAMPLE

#include "/include/faces/face_cache.glsl"
#include "/include/lighting/hit.glsl"
#include "/include/math/random.glsl"

// Nearer, sampling the surface of a lamp is noisier than hitting it.
const float lamp_near = 2.0;
// Lamps looked at for each that gets a ray.
const int lamp_candidates = 4;
// Off a face, in blocks. Points of faces are exact, so this can be less than ray_offset.
const float face_offset = 0.001;

/// Where light arrives: volume space.
struct Receiver {
    vec3 origin;
    vec3 normal;
};

/// Point of the face at `at` (0..1), a little off it. Slabs fill half of the height.
vec3 point_of_face(ivec3 cell, int code, vec3 normal, vec2 at) {
    vec3 axis = abs(normal);
    vec3 unit = axis.x > 0.5 ? vec3(0.5, at) : axis.y > 0.5 ? vec3(at.x, 0.5, at.y) : vec3(at, 0.5);
    unit += 0.5 * normal;
    if (code == voxel_slab_bottom) unit.y *= 0.5;
    if (code == voxel_slab_top) unit.y = 0.5 + 0.5 * unit.y;
    return vec3(cell) + unit + normal * face_offset;
}

/// Light of a lamp that a ray into the hemisphere met; 0 if rays to lamps count it.
vec3 met_lamp(Hit hit, vec3 origin) {
    bool ball = hit.voxel.code >= voxel_small_lamp;
    float far = distance(ball ? vec3(hit.cell) + 0.5 : hit.position, origin);
    return far < lamp_near ? lamp_light(hit.voxel) : vec3(0.0);
}

struct LampSample {
    ivec3 cell;
    vec3 direction;
    vec3 light;  // mean radiance that it gives if it is seen
};

/// A direction within the cone about `axis` with this cosine.
vec3 cone_direction(vec3 axis, float cosine, vec2 u) {
    float z = mix(cosine, 1.0, u.x);
    vec3 side = normalize(cross(axis, abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    float phi = 2.0 * pi * u.y;
    return axis * z + sqrt(max(0.0, 1.0 - z * z)) *
                          (cos(phi) * side + sin(phi) * cross(axis, side));
}

LampSample sample_ball(Receiver r, ivec3 cell, vec3 radiance, vec2 u) {
    vec3 way = vec3(cell) + 0.5 - r.origin;
    float far = length(way);
    float cosine = sqrt(1.0 - pow(small_lamp_radius / max(far, lamp_near), 2.0));
    vec3 direction = cone_direction(way / far, cosine, u);
    float share = far < lamp_near ? 0.0 : 2.0 * (1.0 - cosine) * max(0.0, dot(direction, r.normal));
    return LampSample(cell, direction, radiance * share);
}

LampSample sample_cube(Receiver r, ivec3 cell, int face, vec3 radiance, vec2 u) {
    vec3 normal = face_normal(face);
    vec3 way = point_of_face(cell, voxel_solid, normal, u) - r.origin;
    float far = length(way);
    vec3 direction = way / far;
    float cosines = max(0.0, dot(direction, r.normal)) * max(0.0, -dot(direction, normal));
    float share = far < lamp_near ? 0.0 : cosines / (pi * far * far);
    return LampSample(cell, direction, radiance * share);
}

LampSample sample_lamp(Receiver r, uint lamps) {
    vec3 u = next_random();
    uint entry = imageLoad(face_list, lamp_slot(min(uint(u.z * float(lamps)), lamps - 1u))).r;
    ivec3 cell = packed_cell(entry);
    vec3 radiance = lamp_light(voxel_at(cell)) * float(lamps);
    if (packed_face(entry) == face_ball) return sample_ball(r, cell, radiance, u.xy);
    return sample_cube(r, cell, packed_face(entry), radiance, u.xy);
}

/// Light of one lamp of a few, chosen by what each would give unhindered (Talbot et al. 2005).
vec3 lamp_sample(Receiver r) {
    uint lamps = min(imageLoad(face_tally, tally_lamps).r, lamp_capacity);
    if (lamps == 0u) return vec3(0.0);
    LampSample chosen = LampSample(ivec3(0), vec3(0.0), vec3(0.0));
    float sum = 0.0;
    float weight = 0.0;
    for (int i = 0; i < lamp_candidates; ++i) {
        LampSample candidate = sample_lamp(r, lamps);
        float own = dot(candidate.light, vec3(1.0));
        sum += own;
        if (next_random().x * sum < own) {
            chosen = candidate;
            weight = own;
        }
    }
    if (weight <= 0.0) return vec3(0.0);
    Hit hit = trace_from_face(r.origin, chosen.direction);
    bool seen = hit.found && hit.cell == chosen.cell;
    return seen ? hit.transmittance * chosen.light * (sum / (weight * float(lamp_candidates)))
                : vec3(0.0);
}

#endif
