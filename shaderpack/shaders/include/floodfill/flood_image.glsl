// Floodfill light in an image, FLOODFILL_STORAGE=IMAGE_3D: what the rule sums, I^gamma, so that a step needs
// no powers; the lookup takes the root. Cells keep their place when the volume moves (store_cell).
//
//   flood_light  two sides along z: a step reads the one and writes the other, and of cells that no
//                step computes both are equal. Rows and layers are longer than the volume, as processors
//                keep few lines at addresses that lie powers of two apart.
//                rg32ui: red and green; blue and, from bit 16 on, traits of the cell's block, so that a
//                step loads nothing else. Each colour has 16 bits, 7 of them exponent: 0, or
//                2^-64..2^64 in steps of 2^-9, where 2^63 is the power of light_max.
//                With FLOODFILL_RULE=CONSERVING light itself, rgba32f, without traits.
#if !defined INCLUDED_FLOODFILL_FLOOD_IMAGE
#define INCLUDED_FLOODFILL_FLOOD_IMAGE

#include "/include/voxels/volume.glsl"

const float light_max = 65504.0;  // as in half floats

// Traits.
const uint trait_fixed = 1u << 16;        // a lamp or a wall: no step changes its light
const uint trait_closed_down = 1u << 17;  // a slab closes the side to the cell below, or above
const uint trait_closed_up = 1u << 18;
const uint trait_filter = 1u << 19;

/// 0 for anything that is no light: comparisons with NaN are false, min and max need not be.
vec3 sound(vec3 light) {
    return mix(vec3(0.0), light,
               bvec3(light.r >= 0.0 && light.r <= light_max, light.g >= 0.0 && light.g <= light_max,
                     light.b >= 0.0 && light.b <= light_max));
}

#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
#define FLOOD_TEXEL vec4

vec4 flood_texel_of(vec3 light, uint traits) { return vec4(light, 1.0); }

vec3 light_of(vec4 texel) { return sound(texel.rgb); }

vec4 with_traits(vec4 texel, uint traits) { return texel; }

uint traits_in(vec4 texel) { return 0u; }
#else
#define FLOOD_TEXEL uvec4

const float light_least = 1e-4;  // less is darkness; AMBIENT_MINIMUM is 20 of it
const float power_max = 9223372036854775808.0;
const float power_least = power_max * pow(light_least / light_max, FLOODFILL_GAMMA);
const uint bits_of_code_0 = 0x1F800000u;  // of the float 2^-64, for which 0 stands

/// Where a code is 0 the power is too little to count beside any other.
vec3 power_of(uvec2 texel) {
    uvec3 codes = uvec3(texel.x << 14, texel.x >> 2, texel.y << 14) & 0x3FFFC000u;
    return uintBitsToFloat(codes + bits_of_code_0);
}

/// `power` up to power_max. There is no code for what is not a number, and none follows from light.
uvec4 texel_of_power(vec3 power, uint traits) {
    uvec3 codes = (floatBitsToUint(power) - (bits_of_code_0 - 0x2000u)) >> 14;
    codes *= uvec3(greaterThanEqual(power, vec3(power_least)));
    return uvec4(codes.r | codes.g << 16, codes.b | traits, 0u, 0u);
}

uvec4 flood_texel_of(vec3 light, uint traits) {
    vec3 share = clamp(light, 1e-9, light_max) / light_max;
    return texel_of_power(power_max * pow(share, vec3(FLOODFILL_GAMMA)), traits);
}

vec3 light_of(uvec4 texel) {
    vec3 power = power_of(texel.xy);
    vec3 light = pow(power / power_max, vec3(1.0 / FLOODFILL_GAMMA)) * light_max;
    return mix(light, vec3(0.0), lessThan(power, vec3(0.99 * power_least)));
}

uint traits_in(uvec4 texel) { return texel.y & 0xFFFF0000u; }

uvec4 with_traits(uvec4 texel, uint traits) { return uvec4(texel.x, (texel.y & 0xFFFFu) | traits, 0u, 0u); }
#endif

/// Steps are numbered from 1; frames between two steps have the number of the one before.
uint step_stamp() { return uint(frameCounter / FLOODFILL_INTERVAL) + 1u; }

/// `place`: where a cell is stored. The side that step `stamp` writes.
ivec3 flood_texel(ivec3 place, uint stamp) {
    return place + ivec3(0, 0, int(stamp & 1u) * VOLUME);
}

#endif
