// What the shadow map knows of the surface nearest to the light beside its depth, one texel of shadowcolor0: rgb the
// fourth root of what the block behind it leaves of the light, or of an opaque one's colour; a: is there such a block, or a surface
// that has holes and no shadow volume?
#if !defined INCLUDED_SHADOW_SHEETS
#define INCLUDED_SHADOW_SHEETS

#include "/include/voxels/voxel.glsl"

const vec4 sheet_with_holes = vec4(0.0, 0.0, 0.0, 1.0);

vec3 fourth_root(vec3 color) { return sqrt(sqrt(color)); }

/// `thickness`: through how many blocks of the colour light comes; none where it is 0.
vec4 encode_sheet(vec3 color, float thickness) {
    return vec4(fourth_root(filtered(min(color, vec3(1.0)), thickness)), 0.5) * float(thickness > 0.0);
}

vec4 encode_opaque(vec3 color) { return vec4(fourth_root(min(color, vec3(1.0))), 0.0); }

bool has_holes(vec4 texel) { return texel.a > 0.75; }

/// Is the surface translucent?
bool is_sheet(vec4 texel) { return texel.a > 0.25 && !has_holes(texel); }

/// What is left of light that passed it, or the colour of an opaque surface.
vec3 sheet_color(vec4 texel) {
    vec3 square = texel.rgb * texel.rgb;
    return square * square;
}

vec3 sheet_tint(vec4 texel) { return is_sheet(texel) ? sheet_color(texel) : vec3(1.0); }

#endif
