// Light from everything but the direct sun: GI_SAMPLES rays a pixel through the voxels, averaged
// with the frames before. Radiance is constant along a ray, so nothing is divided by distance.
#include "/settings.glsl"

#if defined VERTEX_STAGE

#include "/include/gi/rest.glsl"

#if HAS_FACE_CACHE
flat out int drawing;
#endif

void main() {
    gl_Position = drawn_corner(ftransform());
#if HAS_FACE_CACHE
    drawing = number_of_drawing();
#endif
}

#else

#if HAS_VOXEL_CHANGES
#extension GL_ARB_shader_image_load_store : enable
#endif

#define HAS_GBUFFER_READS
#define HAS_VOXEL_READS
#include "/include/gbuffer.glsl"
#if HAS_FACE_CACHE
layout(rgba16f) uniform readonly image3D face_light;
#include "/include/face_cache/face_cache.glsl"

/// B of a face, and its number of updates.
vec4 light_of(ivec3 cell, int face) { return trusted(imageLoad(face_light, face_texel(cell, face))); }
#endif
#include "/include/gi/gather.glsl"
#include "/include/gi/history.glsl"
#if HAS_GLOSSY
#include "/include/brdf/glossy.glsl"

uniform sampler2D colortex8;
#endif
#if HAS_FACE_CACHE
flat in int drawing;
#endif

uniform sampler2D colortex3;
uniform sampler2D colortex5;

#if HAS_TRANSLUCENT_MEANS
uniform sampler2D colortex12;
uniform sampler2D colortex13;

#if HAS_GLOSSY
/* RENDERTARGETS: 3,5,10,11,8 */
#else
/* RENDERTARGETS: 3,5,10,11 */
#endif
layout(location = 2) out vec4 out_translucent;
layout(location = 3) out vec4 out_translucent_plane;
#if HAS_GLOSSY
layout(location = 4) out vec4 out_mirrored;
#endif
#elif HAS_GLOSSY
/* RENDERTARGETS: 3,5,8 */
layout(location = 2) out vec4 out_mirrored;
#else
/* RENDERTARGETS: 3,5 */
#endif
layout(location = 0) out vec4 out_radiance;
layout(location = 1) out vec4 out_plane;

#if HAS_GLOSSY
/// One sample of what a polished block or a metal mirrors.
vec3 mirrored(Surface s, vec3 light) {
    vec3 v = -normalize(s.player);
    float alpha = gloss_alpha(s.gloss);
    vec3 facet = ggx_facet(s.normal, v, alpha, next_random().xy);
    vec3 direction = reflect(-v, facet);
    vec3 weight = gloss_fresnel(s.gloss, s.albedo, dot(v, facet)) *
                  ggx_masking(dot(s.normal, direction), alpha);
    vec3 from = to_volume(s.player) + s.normal * pixel_offset(s.player);
    Hit hit = trace_from_face(from, direction);
    weight *= hit.transmittance;
    vec3 seen = lamp_light(hit, from, direction) + end_of_path(hit, from, direction, vec3(1.0), no_sunlit(), light, s.light.y);
    return weight * seen;
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = read_surface(pixel);
    seed_random(pixel, frameCounter);
    vec3 light = light_direction();

    vec3 radiance = vec3(0.0);
    // No ray is sent from the sky.
    int samples = s.sky ? 0 : GI_SAMPLES;
#if HAS_FACE_CACHE
    int first = drawing * GI_SAMPLES;
#else
    int first = 0;
#endif
    for (int i = 0; i < samples; ++i) radiance += gather(s, light, first + i);
    radiance /= float(GI_SAMPLES);

    out_radiance = vec4(radiance, 1.0);
    out_plane = surface_plane(s.player, s.normal);
    vec4 mean = vec4(0.0);
    float noise = 0.0;
#ifdef TEMPORAL_ACCUMULATION
    Before before = before_of(s);
    mean = history(colortex3, colortex5, before.pixel, before.plane);
    if (mean.a > 0.0) noise = texelFetch(colortex5, before.pixel, 0).w;
    out_radiance = accumulate(radiance, mean);
#endif
#ifdef GI_FILTER
    out_plane.w = noise_with(noise, radiance, mean, out_radiance);
#endif
#if HAS_TRANSLUCENT_MEANS
    // What the translucent surfaces of the last frame left is history to those of this one, which cannot read what
    // they write.
    out_translucent = texelFetch(colortex12, pixel, 0);
    out_translucent_plane = of_last_frame(texelFetch(colortex13, pixel, 0));
#endif
#if HAS_GLOSSY
    out_mirrored = vec4(0.0);
    if (s.gloss > 0) out_mirrored = vec4(mirrored(s, light), 1.0);
#ifdef TEMPORAL_ACCUMULATION
    // What is mirrored moves with the eye.
    out_mirrored =
        accumulate(out_mirrored.rgb, camera_is_still() ? texelFetch(colortex8, pixel, 0) : vec4(0.0));
#endif
#endif
    if (s.sky) {
        out_radiance = vec4(0.0);
        out_plane = vec4(0.0);
    }
}

#endif
