// The published step on y = I^gamma: y' = (alpha/6)^gamma * the sum of the open neighbours' y. Linear, so
// without powers, of roots that are stored; by columns, so that a cell takes what its neighbours below and above have loaded.
// Lamps and walls hold what they send (p1_floodfill_list).
#if !defined INCLUDED_VOXEL_POWER_STEP
#define INCLUDED_VOXEL_POWER_STEP

#include "/include/voxel/changes.glsl"
#include "/include/voxel/light_field.glsl"
#include "/include/math/half.glsl"

const float step_gain = pow(FLOODFILL_ALPHA / 6.0, FLOODFILL_GAMMA);
// Smaller changes are none, by this share and the least light: about what half floats round.
const float change_least = 1.0 / 1024.0;
const float power_least = stored_least * stored_least;

vec3 power_at(ivec3 place, uint before) {
    vec3 root = imageLoad(flood_light, flood_texel(place, before)).rgb;
    return root * root;
}

int code_at(ivec3 cell) {
    return int(texelFetch(shadowcolor0, atlas_texel(cell), 0).a * 255.0 + 0.5);
}

/// The four neighbours beside a cell; x and z of their places and whether they are in the volume.
struct Ring {
    ivec4 place;   // x - 1, x + 1, z - 1, z + 1
    bvec4 inside;
};

Ring ring_about(ivec3 place, ivec3 cell) {
    Ring ring;
    ring.place = ivec4(wrap(ivec3(place.x - 1, place.x + 1, place.z - 1), VOLUME),
                       wrap(ivec3(place.z + 1), VOLUME).x);
    ring.inside = bvec4(cell.x > 0, cell.x < VOLUME - 1, cell.z > 0, cell.z < VOLUME - 1);
    return ring;
}

vec3 ring_power(Ring ring, ivec3 place, uint before) {
    vec3 sum = vec3(0.0);
    vec3 dark = vec3(0.0);
    vec3 power = power_at(ivec3(ring.place.x, place.yz), before);
    sum += ring.inside.x ? power : dark;
    power = power_at(ivec3(ring.place.y, place.yz), before);
    sum += ring.inside.y ? power : dark;
    power = power_at(ivec3(place.xy, ring.place.z), before);
    sum += ring.inside.z ? power : dark;
    power = power_at(ivec3(place.xy, ring.place.w), before);
    return sum + (ring.inside.w ? power : dark);
}

/// A branch would be reckoned for every cell, a loop without turns is not.
vec3 tinted(vec3 power, ivec3 cell, int code) {
    for (int turn = 0; turn < int(is_filter_voxel(code)); ++turn)
        power *= pow(max(voxel_at(cell).color, vec3(1e-4)), vec3(FLOODFILL_GAMMA));
    return power;
}

/// Is something of the column's light new?
bool step_column(ivec3 lowest, uint stamp) {
    uint before = stamp - 1u;
    bool changed = false;
    ivec3 cell = stored_at(lowest);
    Ring ring = ring_about(lowest, cell);
    ivec3 under = wrap(lowest - ivec3(0, 1, 0), VOLUME);
    int code_below = code_at(stored_at(under));
    vec3 below = power_at(under, before);
    int code = code_at(cell);
    vec3 own = power_at(lowest, before);
    for (int y = 0; y < brick_size; ++y) {
        ivec3 place = lowest + ivec3(0, y, 0);
        ivec3 over = wrap(place + ivec3(0, 1, 0), VOLUME);
        ivec3 cell_above = stored_at(over);
        int code_above = code_at(cell_above);
        vec3 above = power_at(over, before);

        bool down = cell.y > 0 && code != voxel_slab_bottom && code_below != voxel_slab_top;
        bool up = cell.y < VOLUME - 1 && code != voxel_slab_top && code_above != voxel_slab_bottom;
        vec3 sum = ring_power(ring, place, before);
        sum += down ? below : vec3(0.0);
        sum += up ? above : vec3(0.0);

        vec3 power = tinted(step_gain * sum, cell, code);
        vec3 root = min(sound(sqrt(power)), stored_max);
        root = mix(round_to_half(root), vec3(0.0), lessThan(root, vec3(stored_least)));
        // Written so that a cell that holds no number takes one.
        bvec3 rests = lessThanEqual(abs(power - own), change_least * min(own, stored_max * stored_max) + power_least);
        vec3 before_root = sqrt(own);
        bool fixed_light = is_opaque_voxel(code);
        root = fixed_light ? before_root : mix(root, before_root, rests);
        imageStore(flood_light, flood_texel(place, stamp), vec4(root, 1.0));
        changed = changed || !(all(equal(root, before_root)) || fixed_light);

        below = own;
        code_below = code;
        own = above;
        code = code_above;
        cell = cell_above;
    }
    return changed;
}

#endif
