#include "/lib/a.glsl"
