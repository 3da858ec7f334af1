// The colour of sun or moon light in water, in stained glass and behind it. Needs HAS_VOXEL_READS.
#if !defined INCLUDED_SUN_SUN_TINT
#define INCLUDED_SUN_SUN_TINT

#include "/include/shadow/shadow_space.glsl"
#include "/include/shadow/sheets.glsl"
#include "/include/voxels/voxel.glsl"

#if HAS_SHADOW_MAP
uniform sampler2D shadowtex0;

// Nearer than this, in blocks, the surface in the map is the one that is lit.
const float sheet_distance = 0.2;

/// What is left of the light at a point of the surface before which `cell` lies: the map that holds
/// translucent blocks knows how far away their surface is.
vec3 sun_tint(vec3 player, ivec3 cell) {
    Voxel before = voxel_at(cell);
    vec4 clip = shadow_clip(shadowProjection * (shadowModelView * vec4(player, 1.0)));
    vec3 unit = clip.xyz * 0.5 + 0.5;
    ivec2 texel = ivec2(floor(unit.xy * vec2(shadow_map_size)));
    texel = clamp(texel, ivec2(0), shadow_map_size - 1) + ivec2(0, shadow_map_bottom);
    float depth_per_block = 0.5 * abs(shadowProjection[2][2]);
    float depth = max(0.0, unit.z - texelFetch(shadowtex0, texel, 0).r) / depth_per_block;
    if (is_filter_voxel(before.code) && !is_tinted_pane(before.code)) return filtered(before.color, depth);
    return depth > sheet_distance ? sheet_tint(texelFetch(shadowcolor0, texel, 0)) : vec3(1.0);
}
#else
vec3 sun_tint(vec3 player, ivec3 cell) { return vec3(1.0); }
#endif

#endif
