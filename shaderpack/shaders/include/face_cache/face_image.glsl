// The face cache as an image, for programs of the picture.
#if !defined INCLUDED_FACE_CACHE_FACE_IMAGE
#define INCLUDED_FACE_CACHE_FACE_IMAGE

#include "/include/face_cache/face_cache.glsl"

layout(rgba16f) uniform readonly image3D face_light;

/// B of a face, and its number of updates.
vec4 light_of(ivec3 cell, int face) { return trusted(imageLoad(face_light, face_texel(cell, face))); }

#endif
