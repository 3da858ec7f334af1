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

/// How B changes from one face to the next along this axis, in their plane; at an end as from the last one to this.
vec3 slope_of_light(vec3 own, ivec3 cell, ivec3 along, int face) {
    vec4 next = cached_light(cell + along, face);
    vec4 last = cached_light(cell - along, face);
    float known = float(next.a > 0.0) + float(last.a > 0.0);
    vec3 rise = float(next.a > 0.0) * (next.rgb - own) + float(last.a > 0.0) * (own - last.rgb);
    return clamp(rise / max(known, 1.0), -own, own);
}

/// B at a place on the face (volume space): a plane that has the face's B as its mean.
vec4 cached_light_at(vec3 position, ivec3 cell, int face) {
    vec4 own = cached_light(cell, face);
    vec3 off = clamp(position - vec3(cell) - 0.5, vec3(-0.5), vec3(0.5));
    int axis = (face & 7) >> 1;
    vec3 u = vec3(axis != 0, axis == 0, 0.0);
    vec3 v = vec3(0.0, axis == 2, axis != 2);
    own.rgb += dot(off, u) * slope_of_light(own.rgb, cell, ivec3(u), face) +
               dot(off, v) * slope_of_light(own.rgb, cell, ivec3(v), face);
    return own;
}

#endif
