// One step of the floodfill over the whole volume, every FLOODFILL_INTERVAL frames:
//
//   I' = alpha/6 * (sum over the open neighbours of I^gamma)^(1/gamma)
//
// The power is taken before the sum, so the scheme is linear in I^gamma; it stays bounded while
// alpha < 6^(1 - 1/gamma). Reads one side of colortex4 and writes the other; p1_floodfill_keep
// brings the result back, so frames between the steps leave it bit for bit as it is.
#include "/settings.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#define READ_VOXELS
#include "/include/voxel/light_field.glsl"

/* RENDERTARGETS: 4 */
layout(location = 0) out vec4 out_light;

// pow is undefined at 0; this is 0 again in a half float.
vec3 raise(vec3 x, float exponent) { return pow(max(x, vec3(1e-12)), vec3(exponent)); }

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
        sum += raise(light_from(cell + offset, scroll), FLOODFILL_GAMMA);
        sum += raise(light_from(cell - offset, scroll), FLOODFILL_GAMMA);
    }
    return raise(sum, 1.0 / FLOODFILL_GAMMA) * (FLOODFILL_ALPHA / 6.0);
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
    out_light = vec4(clamp(light, 0.0, light_max), 1.0);
}

#endif
