// Radiance to the screen.
#include "/settings.glsl"
#include "/include/buffers.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#include "/include/math/color.glsl"
#include "/include/post/tone_map.glsl"

uniform sampler2D colortex0;

layout(location = 0) out vec4 out_color;

void main() {
    vec3 color = texelFetch(colortex0, ivec2(gl_FragCoord.xy), 0).rgb;
    out_color = vec4(to_display(tone_map(color * EXPOSURE)), 1.0);
}

#endif
