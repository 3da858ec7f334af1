#version 330 compatibility
#define VERTEX_STAGE
#define FILTER_STEP 4
#include "/program/gi/filter.glsl"
