// One step of the floodfill over the whole volume, every FLOODFILL_INTERVAL frames:
//
//   I' = alpha/6 * (sum over the open neighbours of I^gamma)^(1/gamma)
//
// The power is taken before the sum, so the scheme is linear in I^gamma; it stays bounded while
// alpha < 6^(1 - 1/gamma). Reads one side of colortex4 and writes the other. Both sides are equal
// when a frame begins, as the target is not cleared, so a frame without a step discards everything
// and leaves the light bit for bit as it is.
#include "/settings.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#define READ_VOXELS
#include "/include/voxel/light_field.glsl"

/* RENDERTARGETS: 4 */
layout(location = 0) out vec4 out_light;

// pow is undefined at 0. A darkness of 1e-14 keeps the sum a normal float for every gamma and is 0
// again in a half float.
vec3 to_power(vec3 light) { return pow(max(light, vec3(1e-14)), vec3(FLOODFILL_GAMMA)); }

vec3 from_power(vec3 sum) { return pow(sum, vec3(1.0 / FLOODFILL_GAMMA)); }

// Drivers may cut a half float off instead of rounding it, and the loop amplifies that loss
// twelvefold: round to its 10 bits here.
vec3 round_to_half(vec3 x) {
    return uintBitsToFloat((floatBitsToUint(x) + 0x1000u) & 0xFFFFE000u);
}

/// Light a neighbour sends: selected by what it is, never multiplied, as infinity times 0 is not 0.
vec3 light_from(ivec3 cell, ivec3 scroll) {
    Voxel v = voxel_at(cell);
    if (is_lamp_voxel(v.code)) return lamp_radiance(v);
    if (is_opaque_voxel(v.code)) return vec3(0.0);
    return light_at(cell + scroll);
}

vec3 propagate(ivec3 cell, ivec3 scroll) {
    vec3 sum = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        ivec3 offset = ivec3(axis == 0, axis == 1, axis == 2);
        sum += to_power(light_from(cell + offset, scroll));
        sum += to_power(light_from(cell - offset, scroll));
    }
    return from_power(sum) * (FLOODFILL_ALPHA / 6.0);
}

void main() {
    bool step_now = frameCounter % FLOODFILL_INTERVAL == 0;
    ivec3 scroll = volume_scroll();
    if (!step_now && scroll == ivec3(0)) discard;

    ivec3 cell = atlas_cell(ivec2(gl_FragCoord.xy));
    Voxel own = voxel_at(cell);
    vec3 light = step_now ? propagate(cell, scroll) : light_at(cell + scroll);
    if (step_now && own.code == voxel_translucent) light *= own.color;
    if (is_opaque_voxel(own.code)) light = vec3(0.0);
    if (is_lamp_voxel(own.code)) light = lamp_radiance(own);
    if (!in_volume(cell)) light = vec3(0.0);
    out_light = vec4(round_to_half(clamp(light, 0.0, light_max)), 1.0);
}

#endif
