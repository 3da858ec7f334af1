// Where the shadow map lies in the shadow targets: the whole width, above the rows of the voxels.
#if !defined INCLUDED_LIGHTING_SHADOW_SPACE
#define INCLUDED_LIGHTING_SHADOW_SPACE

#include "/include/uniforms.glsl"

#if VOXELS
const int shadow_map_bottom = ATLAS_ROWS * VOLUME;
#else
const int shadow_map_bottom = 0;
#endif
const ivec2 shadow_map_size = ivec2(SHADOW_RESOLUTION, SHADOW_RESOLUTION - shadow_map_bottom);

/// Clip space of the light to clip space of the target.
vec4 place_shadow(vec4 clip) {
    const float share = float(shadow_map_size.y) / float(SHADOW_RESOLUTION);
    return vec4(clip.x, clip.y * share + (1.0 - share) * clip.w, clip.zw);
}

#endif
