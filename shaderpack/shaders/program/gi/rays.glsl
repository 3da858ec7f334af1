// This frame's samples of the light on what pixels show, by rays of one kind: into the hemisphere, or to lamps. mean.glsl averages
// both over frames.
#include "/settings.glsl"

#if defined VERTEX_STAGE

#include "/include/gi/rest.glsl"
#if HAS_LAMP_RAYS
#include "/include/gi/turns.glsl"

flat out int lamps;
#endif
flat out int drawing;

void main() {
    drawing = number_of_drawing();
    gl_Position = drawn_corner(ftransform());
#if HAS_LAMP_RAYS
    lamps = listed_lamps();
#if defined RAYS_TO_LAMPS
    if (lamps == 0) gl_Position = vec4(2.0);  // nothing is drawn
#endif
    // Where the kinds take turns, the pixels of one fill the left half of the target side by side.
    float share = kinds_take_turns(lamps) ? float(width_of_samples(int(viewWidth))) / viewWidth : 1.0;
    gl_Position.x = share * (gl_Position.x + 1.0) - 1.0;
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
#include "/include/face_cache/face_image.glsl"
#endif
#include "/include/gi/gather.glsl"
#include "/include/math/half.glsl"

#if HAS_LAMP_RAYS
flat in int lamps;
#endif
flat in int drawing;

#if defined RAYS_TO_LAMPS
/* RENDERTARGETS: 15 */
const bool to_lamp = true;

vec3 sample_of(Surface s, ivec2 pixel, int number) { return gather_by_lamp(s, pixel, number); }
#else
/* RENDERTARGETS: 14 */
const bool to_lamp = false;

vec3 sample_of(Surface s, ivec2 pixel, int number) { return gather(s, pixel, light_direction(), number, false); }
#endif
layout(location = 0) out vec4 out_sample;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int samples = GI_SAMPLES;
#if HAS_LAMP_RAYS
    if (lamps > 0) samples = max(1, GI_SAMPLES / 2);
#endif
    int number = drawing * samples;
#if HAS_LAMP_RAYS
    if (kinds_take_turns(lamps)) {
        pixel = pixel_of_sample(pixel, number, to_lamp);
        is_turn_of_lamps(pixel, number);
    }
#endif
    Surface s = read_surface(min(pixel, ivec2(viewWidth, viewHeight) - 1));
    if (s.sky) discard;  // no ray is sent from there
    seed_random(pixel, frameCounter);
    vec3 radiance = vec3(0.0);
    int i = 0;
    do radiance += sample_of(s, pixel, number + i);
    while (++i < samples);
    radiance /= float(samples);
    // By chance up or down: of what is darker than a step of half floats, the mean over frames keeps all.
    out_sample = vec4(min(dithered_half(radiance, next_random().x), vec3(65504.0)), 1.0);
}

#endif
