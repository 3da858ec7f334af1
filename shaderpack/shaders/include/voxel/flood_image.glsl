// Floodfill light in an image, FLOODFILL_STORAGE=IMAGE_3D: the root of what the rule sums, I^(gamma/2), so
// that a step needs no powers and half floats hold its range; the lookup takes the rest of the power.
// Cells keep their place when the volume moves (store_cell).
//
//   flood_light  two sides along z: a step reads the one and writes the other, and of cells that no
//                step reckons both are equal. rgba16f; with FLOODFILL_RULE=CONSERVING light itself, rgba32f
#if !defined INCLUDED_VOXEL_FLOOD_IMAGE
#define INCLUDED_VOXEL_FLOOD_IMAGE

#include "/include/voxel/volume.glsl"

const float light_max = 65504.0;  // as in half floats

#if FLOODFILL_RULE == CONSERVING
const float stored_max = light_max;

vec3 to_stored(vec3 light) { return light; }
vec3 from_stored(vec3 stored) { return stored; }
#else
const float stored_max = 60000.0;  // of light_max
const float light_least = 1e-4;    // less is darkness; AMBIENT_MINIMUM is 20 of it
const float stored_least = stored_max * pow(light_least / light_max, FLOODFILL_GAMMA / 2.0);

vec3 to_stored(vec3 light) {
    vec3 stored = pow(max(light, vec3(light_least)) / light_max, vec3(FLOODFILL_GAMMA / 2.0));
    return mix(stored * stored_max, vec3(0.0), lessThan(light, vec3(light_least)));
}

vec3 from_stored(vec3 stored) {
    vec3 light = pow(max(stored, vec3(stored_least)) / stored_max, vec3(2.0 / FLOODFILL_GAMMA));
    return mix(light * light_max, vec3(0.0), lessThan(stored, vec3(stored_least)));
}
#endif

/// Steps are numbered from 1; frames between two steps have the number of the one before.
uint step_stamp() { return uint(frameCounter / FLOODFILL_INTERVAL) + 1u; }

/// `place`: where a cell is stored. The side that step `stamp` writes.
ivec3 flood_texel(ivec3 place, uint stamp) {
    return place + ivec3(0, 0, int(stamp & 1u) * VOLUME);
}

/// 0 for anything that is no light: comparisons with NaN are false, min and max need not be.
vec3 sound(vec3 stored) {
    const float most = 8.0 * stored_max;  // a step may pass the largest before it is cut
    return mix(vec3(0.0), stored,
               bvec3(stored.r >= 0.0 && stored.r <= most, stored.g >= 0.0 && stored.g <= most,
                     stored.b >= 0.0 && stored.b <= most));
}

#endif
