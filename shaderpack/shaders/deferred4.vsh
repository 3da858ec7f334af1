#version 330 compatibility
// Smooths the gathered light within each face: pixels 2 apart.
#define VERTEX_STAGE
#define FILTER_STEP 2
#include "/program/gi/filter.glsl"
