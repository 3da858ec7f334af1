// The face cache as a texture, for programs after the shadow pass.
#if !defined INCLUDED_FACE_CACHE_FACE_LOOKUP
#define INCLUDED_FACE_CACHE_FACE_LOOKUP

#include "/include/face_cache/face_cache.glsl"

uniform sampler3D face_light_texture;

/// B of a block's face; a: on how many updates it rests, 0 where there is none.
vec4 cached_light(ivec3 cell, int face) {
    if (!in_volume(cell)) return vec4(0.0);
    return trusted(texelFetch(face_light_texture, face_texel(cell, face), 0));
}

#endif
