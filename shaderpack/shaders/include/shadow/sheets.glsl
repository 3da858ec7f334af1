// What the shadow map knows of the surface nearest to the light beside its depth, one texel of shadowcolor0: rgb the
// square root of a translucent colour, a through how many blocks of it light comes, or that the surface has holes
// and no shadow volume.
#if !defined INCLUDED_SHADOW_SHEETS
#define INCLUDED_SHADOW_SHEETS

const float sheet_thickness = 8.0;  // the largest that is kept, blocks

const vec4 sheet_with_holes = vec4(0.0, 0.0, 0.0, 1.0);

vec4 encode_sheet(vec3 color, float thickness) {
    return vec4(sqrt(clamp(color, 0.0, 1.0)), min(thickness / sheet_thickness, 0.9)) * float(thickness > 0.0);
}

bool has_holes(vec4 texel) { return texel.a > 0.95; }

/// What is left of light that passed it.
vec3 sheet_tint(vec4 texel) {
    bool tints = texel.a > 0.0 && !has_holes(texel);
    return tints ? pow(max(texel.rgb * texel.rgb, vec3(1e-3)), vec3(texel.a * sheet_thickness)) : vec3(1.0);
}

#endif
