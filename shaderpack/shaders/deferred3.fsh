#version 330 compatibility
// Smooths the gathered light within each face: pixels 1 apart.
#define FRAGMENT_STAGE
#define FILTER_STEP 1
#include "/program/gi/filter.glsl"
