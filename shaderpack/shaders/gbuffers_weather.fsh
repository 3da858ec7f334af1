#version 330 compatibility
#define PROGRAM_WEATHER
#define FRAGMENT_STAGE
#include "/program/gbuffers/translucent.glsl"
