// Where the shadow map lies in the shadow targets, the whole width above the rows of the voxels, and
// what of the world each of its texels sees.
#if !defined INCLUDED_SHADOW_SHADOW_SPACE
#define INCLUDED_SHADOW_SHADOW_SPACE

#include "/include/uniforms.glsl"

#if HAS_VOXELS
const int shadow_map_bottom = ATLAS_ROWS * VOLUME;
#else
const int shadow_map_bottom = 0;
#endif
const ivec2 shadow_map_size = ivec2(SHADOW_TARGET, SHADOW_TARGET - shadow_map_bottom);

/// Clip space of the light to clip space of the target.
vec4 place_shadow(vec4 clip) {
    const float share = float(shadow_map_size.y) / float(SHADOW_TARGET);
    return vec4(clip.x, clip.y * share + (1.0 - share) * clip.w, clip.zw);
}

/// What brings the texels to a lattice that rests in the world, in clip space: otherwise edges crawl
/// by up to a texel as the eye moves.
vec2 shadow_snap() {
#ifdef SHADOW_SNAP
    // Any point of the world will do that is not far away.
    vec3 anchor = -vec3(cameraPositionInt & 1023) - cameraPositionFract;
    vec2 texels = 0.5 * vec2(shadow_map_size);
    return -fract((shadowProjection * (shadowModelView * vec4(anchor, 1.0))).xy * texels) / texels;
#else
    return vec2(0.0);
#endif
}

/// First texel of a lattice that rests in the world, as the texels do.
vec2 shadow_lattice() {
    vec3 anchor = -vec3(cameraPositionInt & 1023) - cameraPositionFract;
    vec2 texels = 0.5 * vec2(shadow_map_size);
    return floor((shadowProjection * (shadowModelView * vec4(anchor, 1.0))).xy * texels);
}

/// A point of the square 0..1 for each place of the lattice; those of neighbours lie far apart.
vec2 point_in_texel(vec2 place) {
    place = mod(floor(place), 1024.0);
    return fract(place.x * vec2(0.7548777, 0.5698403) + place.y * vec2(0.3247180, 0.8191725));
}

/// More texels for what is near the eye. `clip` is x and y, -1..1.
vec2 distort_shadow(vec2 clip) {
    return clip / (SHADOW_DISTORTION * length(clip) + (1.0 - SHADOW_DISTORTION));
}

/// Inverse of distort_shadow.
vec2 straighten_shadow(vec2 clip) {
    return clip * (1.0 - SHADOW_DISTORTION) / max(1.0 - SHADOW_DISTORTION * length(clip), 1e-3);
}

/// The side of a texel at `clip`, x and y before the distortion; in blocks, at its longest.
float shadow_texel(vec2 clip) {
    const float side = 2.0 * SHADOW_DISTANCE / float(shadow_map_size.y);
    float scale = SHADOW_DISTORTION * length(clip) + (1.0 - SHADOW_DISTORTION);
    return side * scale * scale / (1.0 - SHADOW_DISTORTION);
}

/// `clip` of the light's projection to that of the map. Casters before the near plane stay, on it.
vec4 shadow_clip(vec4 clip) {
    return vec4(distort_shadow(clip.xy + shadow_snap()), max(clip.z, -1.0), clip.w);
}

#endif
