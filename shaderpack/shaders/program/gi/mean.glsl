// Light from everything but the direct sun: the samples of this frame (rays.glsl), averaged with the frames before.
#include "/settings.glsl"

#if defined VERTEX_STAGE

#include "/include/gi/rest.glsl"
#if HAS_LAMP_RAYS
#include "/include/gi/turns.glsl"

flat out int lamps;
flat out int drawing;
#endif

void main() {
    gl_Position = drawn_corner(ftransform());
#if HAS_LAMP_RAYS
    lamps = listed_lamps();
    drawing = number_of_drawing();
#endif
}

#else

#if HAS_GLOSSY
#extension GL_ARB_shader_image_load_store : enable
#define HAS_VOXEL_READS
#endif

#define HAS_GBUFFER_READS
#include "/include/gbuffer.glsl"
#include "/include/gi/history.glsl"
#if HAS_GLOSSY
#include "/include/brdf/glossy.glsl"
#include "/include/face_cache/face_image.glsl"
#include "/include/face_cache/path_end.glsl"

uniform sampler2D colortex8;
#endif
#if HAS_LAMP_RAYS
#include "/include/gi/turns.glsl"

flat in int lamps;
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

uniform sampler2D colortex14;
#if HAS_LAMP_RAYS
uniform sampler2D colortex15;
#endif

/// The mean of this frame's samples of a pixel.
vec3 sample_of(ivec2 pixel) {
#if HAS_LAMP_RAYS
    if (kinds_take_turns(lamps)) {
        int number = drawing;
        ivec2 place = place_of_sample(pixel);
        return is_turn_of_lamps(pixel, number) ? texelFetch(colortex15, place, 0).rgb : texelFetch(colortex14, place, 0).rgb;
    }
    if (lamps > 0) return 0.5 * (texelFetch(colortex14, pixel, 0).rgb + texelFetch(colortex15, pixel, 0).rgb);
#endif
    return texelFetch(colortex14, pixel, 0).rgb;
}

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
    vec3 radiance = sample_of(pixel);
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
    seed_random(pixel, frameCounter);
    if (s.gloss > 0) out_mirrored = vec4(mirrored(s, light_direction()), 1.0);
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
