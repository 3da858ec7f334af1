// Radiance to the screen.
#include "/settings.glsl"
#include "/include/buffers.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#include "/include/math/color.glsl"
#include "/include/post/tone_map.glsl"

uniform sampler2D colortex0;
#if HAS_AUTO_EXPOSURE
uniform sampler2D colortex9;
#endif

layout(location = 0) out vec4 out_color;

void main() {
    vec3 color = texelFetch(colortex0, ivec2(gl_FragCoord.xy), 0).rgb;
#if HAS_AUTO_EXPOSURE
    color *= texelFetch(colortex9, ivec2(0), 0).r;
#endif
    out_color = vec4(to_display(tone_map(color * EXPOSURE)), 1.0);
}

#endif
