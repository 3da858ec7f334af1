// The lit opaque scene, and the sky where there is none.
#include "/settings.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#if HAS_VOXEL_VIEW
#extension GL_ARB_shader_image_load_store : enable
#endif
#define HAS_GBUFFER_READS
#if HAS_GI
#define HAS_VOXEL_READS
#endif
#include "/include/gbuffer.glsl"
#include "/include/gi/ambient.glsl"
#include "/include/math/half.glsl"
#include "/include/brdf/direct.glsl"
#if HAS_GLOSSY
#include "/include/brdf/glossy.glsl"

uniform sampler2D colortex8;
#endif
#include "/include/sun/sun_visibility.glsl"
#if HAS_FORWARD_LAMPS
#include "/include/lights/lamps.glsl"

uniform sampler2D colortex7;
#elif HAS_LAMPS
#extension GL_ARB_shader_image_load_store : enable
#define HAS_LAMP_VOLUME_READS
#include "/include/lights/lit_by_lamps.glsl"
#endif
#if HAS_GI
#include "/include/sun/sun_tint.glsl"
#include "/include/voxels/volume.glsl"
#ifdef GI_FILTER
uniform sampler2D colortex6;
#define GI_RESULT colortex6
#else
uniform sampler2D colortex3;
#define GI_RESULT colortex3
#endif
#endif

#if HAS_LIGHT_DEBUG
#include "/include/debug/lights.glsl"
#endif
#if HAS_VOXEL_VIEW
#include "/include/debug/voxel_view.glsl"
#endif

uniform sampler2D colortex0;

/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 out_color;

/// Mean radiance over the hemisphere, without the direct sun.
vec3 indirect_radiance(Surface s, ivec2 pixel) {
    vec2 light = s.light;
#if HAS_LAMPS
    light.x *= unlisted_share(s.player);
#endif
    vec3 lightmap = ambient_radiance(light, s.normal);
#if HAS_GI
    return mix(lightmap, texelFetch(GI_RESULT, pixel, 0).rgb + AMBIENT_MINIMUM,
               inside_volume(to_volume(s.player)));
#else
    return lightmap;
#endif
}

#ifdef SHADOW_VIEW
/// Visibility of sun or moon; 0 on what turns away from it or lies along it, as in the reference.
float sun_arrives(Surface s, ivec2 pixel) {
    vec3 l = light_direction();
    float cosine = dot(s.normal, l);
    vec3 n = s.thin && cosine < 0.0 ? -s.normal : s.normal;
    return float((s.thin ? abs(cosine) : cosine) > 0.01) * sun_visibility(pixel, s.player, n, l, s.light.y);
}
#endif

vec3 light_surface(Surface s, ivec2 pixel) {
    vec3 l = light_direction();
    vec3 v = -normalize(s.player);
    // A leaf is lit from either side.
    vec3 n = s.thin && dot(s.normal, l) < 0.0 ? -s.normal : s.normal;
    float level = s.emission / 15.0;
    vec3 radiance = s.albedo * (EMISSION_STRENGTH * level * level);
    vec3 diffuse = s.albedo;
#if HAS_GLOSSY
    if (s.gloss > 0) {
        diffuse *= diffuse_share(s.gloss, s.albedo, max(dot(n, v), 0.0));
        radiance += texelFetch(colortex8, pixel, 0).rgb;
    }
#endif
    radiance += diffuse * indirect_radiance(s, pixel);
#if DIRECT_LIGHT != NONE
    vec3 sun = light_irradiance() * sun_visibility(pixel, s.player, n, l, s.light.y);
#if HAS_GI
    sun *= sun_tint(s.player, n, l, ivec3(floor(to_volume(s.player + n * 0.02))));
#endif
#if HAS_GLOSSY
    radiance += sun * (s.gloss > 0 ? reflect_glossy(s.gloss, s.albedo, n, v, l)
                                   : reflect_direct(s.albedo, n, v, l));
#else
    radiance += sun * reflect_direct(s.albedo, n, v, l);
#endif
#endif
#if HAS_FORWARD_LAMPS
    radiance += texelFetch(colortex7, pixel, 0).rgb;
#elif HAS_LAMPS
    radiance += lamps_radiance(s.player, s.normal, float(s.thin), diffuse);
#endif
    return radiance;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = read_surface(pixel);
#if HAS_LAMP_VOLUMES
    read_lamp_volumes(pixel);
#endif
    // What the sky programs drew: stars, sun, moon.
    vec3 behind = texelFetch(colortex0, pixel, 0).rgb + sky_radiance(normalize(s.player));
    out_color = vec4(as_stored(s.sky ? behind : light_surface(s, pixel)), 1.0);
#if HAS_LIGHT_DEBUG
    out_color = vec4(light_debug(s), 1.0);
#endif
#if HAS_VOXEL_VIEW
    out_color = vec4(voxel_view(s.player), 1.0);
#endif
#ifdef SHADOW_VIEW
    out_color = vec4(vec3(s.sky ? 1.0 : sun_arrives(s, pixel)), 1.0);
#if HAS_LAMP_VOLUMES
    for (int i = 0; i < 2 && !s.sky; ++i)
        out_color[i + 1] = lamp_arrives(i, s.player, s.normal, s.thin);
#endif
#endif
}

#endif
