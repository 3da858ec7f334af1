#version 330 compatibility
#define FRAGMENT_STAGE
#define FILTER_STEP 1
#include "/program/gi/filter.glsl"
