#version 330 compatibility
// Lights the opaque scene: sun with shadows, lamps, gathered light, sky.
#define FRAGMENT_STAGE
#include "/program/lighting.glsl"
