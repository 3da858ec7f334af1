// Share of the sun's or the moon's light that reaches what a pixel shows.
#if !defined INCLUDED_SUN_SUN_VISIBILITY
#define INCLUDED_SUN_SUN_VISIBILITY

#include "/include/shadow/shadow.glsl"

#if HAS_SHADOW_VOLUMES

// Number of shadow volumes that hold what the pixel shows, modulo 256.
uniform usampler2D stenciltex0;

float sun_visibility(ivec2 pixel, vec3 player, vec3 normal, vec3 light, float sky) {
    float lit = float(texelFetch(stenciltex0, pixel, 0).r == 0u);
#if HAS_SHADOW_MAP && defined HAS_VOXEL_READS
    lit *= open_share(player, normal, light);
#endif
    return lit;
}

#else

float sun_visibility(ivec2 pixel, vec3 player, vec3 normal, vec3 light, float sky) {
    return light_visibility(player, normal, light, shadow_radius, sky);
}

#endif

#endif
