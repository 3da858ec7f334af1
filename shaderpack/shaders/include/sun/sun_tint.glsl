// The colour of sun or moon light in water, in stained glass and behind it. Needs HAS_VOXEL_READS.
#if !defined INCLUDED_SUN_SUN_TINT
#define INCLUDED_SUN_SUN_TINT

#include "/include/shadow/shadow.glsl"
#include "/include/shadow/sheets.glsl"
#include "/include/voxels/voxel.glsl"

#if HAS_SHADOW_MAP
uniform sampler2D shadowtex0;

// Nearer than this, in blocks, the surface in the map is the one that is lit.
const float sheet_distance = 0.2;

ivec2 sheet_texel(ivec2 texel) {
    return clamp(texel, ivec2(0), shadow_map_size - 1) + ivec2(0, shadow_map_bottom);
}

/// How far below the first surface in the map a depth (0..1) lies, translucent ones included, in blocks.
float blocks_below(ivec2 texel, float depth) {
    return (depth - texelFetch(shadowtex0, texel, 0).r) / (0.5 * abs(shadowProjection[2][2]));
}

/// What the first surface in the map leaves of the light at a depth; a: 0 where it is opaque.
vec4 tint_at(ivec2 texel, float depth) {
    vec4 sheet = texelFetch(shadowcolor0, texel, 0);
    return blocks_below(texel, depth) > sheet_distance ? vec4(sheet_tint(sheet), float(is_sheet(sheet))) : vec4(1.0);
}

/// Of light in water or glass at a depth of the map.
vec3 tint_within(Voxel before, ivec2 texel, float depth) { return filtered(before.color, max(0.0, blocks_below(texel, depth))); }

/// Is light tinted by what it passes in a cell, and not by its surface?
bool tints_within(Voxel before) { return is_filter_voxel(before.code) && !is_tinted_pane(before.code); }

/// What is left of the light at a point of the surface before which `cell` lies. The colour comes from the texels about the
/// point, as light_visibility() does: one beside a stained window knows only the wall, and would leave all light.
vec3 sun_tint(vec3 player, vec3 normal, vec3 light, ivec3 cell) {
    Voxel before = voxel_at(cell);
    if (tints_within(before)) {
        vec3 unit = shadow_clip(shadowProjection * (shadowModelView * vec4(player, 1.0))).xyz * 0.5 + 0.5;
        return tint_within(before, sheet_texel(ivec2(floor(unit.xy * vec2(shadow_map_size)))), unit.z);
    }
    vec3 receiver = shadow_receiver(player, normal, light, 1).xyz;
    ivec2 middle = ivec2(floor(receiver.xy));
    vec4 tint = tint_at(sheet_texel(middle), receiver.z);
    // In a penumbra the colour is that of the texels around which are lit.
    vec4 lit = vec4(0.0);
    int texels = tint.a == 0.0 ? 9 : 0;
    for (int i = 0; i < texels; ++i) {
        vec4 next = tint_at(sheet_texel(middle + ivec2(i % 3, i / 3) - 1), receiver.z);
        lit += vec4(next.rgb, 1.0) * next.a;
    }
    return lit.a > 0.0 ? lit.rgb / lit.a : tint.rgb;
}

/// The same at a point of a plane for the texel of the map that says whether light arrives there.
vec3 point_tint(ivec2 texel, float depth, Voxel before) {
    texel = sheet_texel(texel);
    return tints_within(before) ? tint_within(before, texel, depth) : tint_at(texel, depth).rgb;
}
#else
vec3 sun_tint(vec3 player, vec3 normal, vec3 light, ivec3 cell) { return vec3(1.0); }
#endif

#endif
