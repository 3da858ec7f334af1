#version 330 compatibility
// Smooths the gathered light within each face: pixels 4 apart.
#define VERTEX_STAGE
#define FILTER_STEP 4
#include "/program/gi/filter.glsl"
