// Brings a step's result to the side that the frame started with: the two programs flip colortex4
// twice, and a frame without a step discards in both and so changes neither side.
#include "/settings.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#include "/include/voxel/volume.glsl"

uniform sampler2D colortex4;

/* RENDERTARGETS: 4 */
layout(location = 0) out vec4 out_light;

void main() {
    if (frameCounter % FLOODFILL_INTERVAL != 0 && volume_scroll() == ivec3(0)) discard;
    out_light = texelFetch(colortex4, ivec2(gl_FragCoord.xy), 0);
}

#endif
