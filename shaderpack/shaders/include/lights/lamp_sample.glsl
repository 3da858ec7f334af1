// Light of one lamp, drawn at random from the list of the shadow pass, by a ray to it. Rays into the
// hemisphere find lamps too, near ones more surely: both count a share of each, by the balance
// heuristic (Veach & Guibas 1995), and together all of it. The images face_list and face_seen belong to
// the program, and lamp_candidates: how many lamps are looked at for each that gets a ray; all if there are no more.
#if !defined INCLUDED_LIGHTS_LAMP_SAMPLE
#define INCLUDED_LIGHTS_LAMP_SAMPLE

#include "/include/face_cache/face_cache.glsl"
#include "/include/gi/hit.glsl"
#include "/include/math/random.glsl"

/// Where light arrives: volume space.
struct Receiver {
    vec3 origin;
    vec3 normal;
};

/// Point of a side of a cell at `at` (0..1), a little off it.
vec3 point_of_side(ivec3 cell, vec3 normal, vec2 at) {
    vec3 axis = abs(normal);
    vec3 unit = axis.x > 0.5 ? vec3(0.5, at) : axis.y > 0.5 ? vec3(at.x, 0.5, at.y) : vec3(at, 0.5);
    return vec3(cell) + unit + normal * (0.5 + face_offset);
}

bool has_octant(uint octants, vec3 within) {
    return (octants >> uint(dot(floor(within * 2.0), vec3(1.0, 2.0, 4.0))) & 1u) == 1u;
}

/// Point of a face of a block, a little off it. `before`: the octants of the cell on that side, which hide
/// parts of a face on the side.
vec3 point_of_face(ivec3 cell, uint octants, uint before, int face, vec2 at) {
    vec3 normal = face_normal(face);
    bool inner = face >= face_inner;
    float inward = inner ? 0.5 : 0.0;
    // A quarter of the side without a face passes its points on to another quarter.
    for (int i = 0; i < 4; ++i) {
        vec2 quarter = fract(at + 0.5 * vec2(i & 1, i >> 1));
        vec3 side = point_of_side(ivec3(0), normal, quarter);
        vec3 outer = side - 0.25 * normal;
        bool on_side = has_octant(octants, outer);
        bool hidden = has_octant(before, outer - 0.5 * normal);
        bool in_middle = !on_side && has_octant(octants, outer - 0.5 * normal);
        if (inner ? in_middle : on_side && !hidden) return vec3(cell) + side - inward * normal;
    }
    return point_of_side(cell, normal, at) - inward * normal;
}

/// Point of a side of a post, chest or plate.
vec3 point_of_post(ivec3 cell, int code, int face, vec2 at) {
    Box post = main_box(code, kept_shape(cell));
    return vec3(cell) + 0.5 + mix(post.low, post.high, point_of_side(ivec3(0), face_normal(face), at));
}

/// A point of a face that looks into a cell of lava, moved to what is seen of it above the lava.
vec3 point_above_lava(vec3 point, vec3 normal) {
    float height = mix(water_height, 1.0, fract(point.y));
    return normal.y == 0.0 && !is_whole_lava(ivec3(floor(point))) ? vec3(point.x, floor(point.y) + height, point.z) : point;
}

/// A point of a face that looks into the cell of a plate, moved out of what the plate covers of it.
vec3 point_beside_plate(vec3 point, int code, uint parts) {
    Box plate = main_box(code, parts);
    vec3 covered = plate_thickness * vec3(lessThan(plate.high - plate.low, vec3(0.5)));
    vec3 first = covered * vec3(lessThan(plate.low, vec3(0.0)));
    return floor(point) + first + fract(point) * (1.0 - covered);
}

/// A point of the floor below a small lamp, moved out of what that covers to what is as large about it.
vec3 point_beside_lamp(vec3 point, uint parts) {
    float covered = lamp_radius(parts);
    vec2 off = fract(point.xz) - 0.5;
    float far = max(abs(off.x), abs(off.y));
    float share = far / covered;
    float moved = sqrt(mix(covered * covered, 0.25, share * share));
    off *= far < covered ? moved / max(far, 1e-4) : 1.0;
    return vec3(floor(point.x) + 0.5 + off.x, point.y, floor(point.z) + 0.5 + off.y);
}

uint listed_lamps() { return min(imageLoad(face_seen, listed_lamps_texel).r, lamp_capacity); }

/// The share that rays to lamps count of light from a direction in which they have this density, were
/// lamps chosen evenly. Any share would be right that both kinds of rays agree on.
float sampled_share(float density, uint lamps, float cosine) {
    float sampled = density * min(1.0, float(lamp_candidates) / float(max(lamps, 1u)));
    return sampled / (sampled + max(cosine, 1e-6) / pi);
}

/// Densities over directions, of points on the face of a cube and of directions to a ball.
float density_of_face(float far, float cosine) { return far * far / max(cosine, 1e-6); }

float density_of_ball(float far) {
    float ratio = min(small_lamp_radius / max(far, 1e-3), 0.999);
    return 0.5 * (1.0 + sqrt(1.0 - ratio * ratio)) / (pi * ratio * ratio);
}

/// Of the light of a lamp that a ray into the hemisphere met, what rays to lamps do not count.
float met_share(Hit hit, Receiver r, vec3 direction) {
    bool ball = is_ball(hit.voxel.code);
    float density = ball ? density_of_ball(distance(vec3(hit.cell) + 0.5, r.origin))
                         : density_of_face(distance(hit.position, r.origin), -dot(hit.normal, direction));
    // Rays to lamps look for fire on the outside of its cell.
    if (is_fire(hit.voxel.code) && hit.cell == ivec3(floor(r.origin))) density = 0.0;
    return 1.0 - sampled_share(density, listed_lamps(), dot(direction, r.normal));
}

/// About what a lamp gives if nothing hides it, to choose by: by its middle, and never 0 where a part of
/// it gives something.
float promise(Receiver r, uint entry) {
    int face = packed_face(entry);
    vec3 normal = face == face_ball ? vec3(0.0) : face_normal(face);
    vec3 to_lamp = vec3(packed_cell(entry)) + 0.5 + 0.5 * normal - r.origin;
    float squared = dot(to_lamp, to_lamp);
    float far = sqrt(squared);
    float here = max(0.0, dot(to_lamp, r.normal) + 0.75);
    float there = face == face_ball ? 0.25 * far : max(0.0, 0.75 - dot(to_lamp, normal));
    float level = entry_level(entry);
    return level * level * here * there / (squared * squared + 0.1);
}

struct LampSample {
    ivec3 cell;
    vec3 direction;
    vec3 light;     // mean radiance that it gives if it is seen
    float density;  // of the direction
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
    vec3 to_lamp = vec3(cell) + 0.5 - r.origin;
    float far = length(to_lamp);
    float density = density_of_ball(far);
    vec3 direction = cone_direction(to_lamp / far, 1.0 - 0.5 / (pi * density), u);
    float cosine = max(0.0, dot(direction, r.normal));
    // From inside no ray sees it.
    float share = far < small_lamp_radius ? 0.0 : cosine / (pi * density);
    return LampSample(cell, direction, radiance * share, density);
}

/// Of lava the top lies lower, the planes of a portal lie inside.
LampSample sample_cube(Receiver r, ivec3 cell, int face, int code, vec3 radiance, vec2 u) {
    vec3 normal = face_normal(face);
    vec3 to_lamp = point_of_side(cell, normal, u) - r.origin;
    to_lamp.y -= code == voxel_lava && normal.y > 0.5 ? 1.0 - water_height : 0.0;
    to_lamp -= is_portal(code) ? normal * (0.5 - portal_radius) : vec3(0.0);
    float far = length(to_lamp);
    vec3 direction = to_lamp / far;
    float cosine = max(0.0, -dot(direction, normal));
    float share = max(0.0, dot(direction, r.normal)) * cosine / (pi * far * far);
    return LampSample(cell, direction, radiance * share, density_of_face(far, cosine));
}

LampSample sample_lamp(Receiver r, uint entry, uint lamps, vec2 u) {
    ivec3 cell = packed_cell(entry);
    Voxel voxel = voxel_at(cell);
    vec3 radiance = lamp_light(voxel, cell);
    LampSample lamp = packed_face(entry) == face_ball
                          ? sample_ball(r, cell, radiance, u)
                          : sample_cube(r, cell, packed_face(entry), voxel.code, radiance, u);
    lamp.light *= sampled_share(lamp.density, lamps, dot(lamp.direction, r.normal));
    return lamp;
}

/// One lamp of a few from all parts of the list, chosen by what they promise (resampling, Talbot et al. 2005), and by `u`
/// a point of it; light: what it gives where it is seen, over the probability of the choice.
LampSample choose_lamp(Receiver r, uint lamps, vec2 u) {
    LampSample lamp = LampSample(ivec3(-1), r.normal, vec3(0.0), 0.0);
    uint chosen = 0u;
    float sum = 0.0;
    float weight = 0.0;
    int candidates = min(lamp_candidates, int(lamps));
    float stride = float(lamps) / float(candidates);
    // One number for all choices: where it falls within what it decided is as random as it was.
    vec2 v = next_random().xy;
    int i = 0;
    do {
        uint index = min(uint((float(i) + v.x) * stride), lamps - 1u);
        uint entry = imageLoad(face_list, lamp_slot(index)).r;
        float own = promise(r, entry);
        sum += own;
        float bound = own / max(sum, 1e-30);
        bool taken = v.y < bound;
        chosen = taken ? entry : chosen;
        weight = taken ? own : weight;
        v.y = taken ? v.y / bound : (v.y - bound) / (1.0 - bound);
    } while (++i < candidates);
    if (weight <= 0.0) return lamp;
    lamp = sample_lamp(r, chosen, lamps, u);
    lamp.light *= sum * stride / weight;
    return lamp;
}

/// Light of one lamp, by a ray to it.
vec3 lamp_sample(Receiver r) {
    uint lamps = listed_lamps();
    if (lamps == 0u) return vec3(0.0);
    LampSample lamp = choose_lamp(r, lamps, next_random().xy);
    Hit hit = trace_from_face(r.origin, lamp.direction);
    return hit.found && hit.cell == lamp.cell ? hit.transmittance * lamp.light : vec3(0.0);
}

#endif
