#version 330 compatibility
#define FRAGMENT_STAGE
#define FILTER_STEP 2
#include "/program/d1_filter.glsl"
