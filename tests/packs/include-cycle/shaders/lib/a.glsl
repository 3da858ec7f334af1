#ifndef A
#define A
#include "b.glsl"
#endif
