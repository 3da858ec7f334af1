#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/gbuffers/sky.glsl"
