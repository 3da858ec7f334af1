// One step of the floodfill over the whole volume, every FLOODFILL_INTERVAL frames. Reads one side of
// colortex4 and writes the other. Both sides are equal when a frame begins, as the target is not
// cleared, so a frame without a step discards everything and leaves the light bit for bit as it is.
#include "/settings.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#define HAS_VOXEL_READS
#include "/include/floodfill/propagation.glsl"

/* RENDERTARGETS: 4 */
layout(location = 0) out vec4 out_light;

void main() {
    bool step_now = frameCounter % FLOODFILL_INTERVAL == 0;
    ivec3 scroll = volume_scroll();
    if (!step_now && scroll == ivec3(0)) discard;

    ivec3 cell = atlas_cell(ivec2(gl_FragCoord.xy));
    out_light = vec4(next_light(cell, scroll, step_now), 1.0);
}

#endif
