// Light at a place on a face, from its mean and those of the faces beside it in its plane. The program has light_of(cell,
// face), B of a face and its number of updates.
#if !defined INCLUDED_FACE_CACHE_LIGHT_AT
#define INCLUDED_FACE_CACHE_LIGHT_AT

#include "/include/face_cache/face_cache.glsl"

/// B of the face of a cell, as far as it is in the volume.
vec4 known_light(ivec3 cell, int face) { return in_volume(cell) ? light_of(cell, face) : vec4(0.0); }

/// How B changes from one face to the next along this axis, in their plane; at an end as from the last one to this.
vec3 slope_of_light(vec3 own, ivec3 cell, ivec3 along, int face) {
    vec4 next = known_light(cell + along, face);
    vec4 last = known_light(cell - along, face);
    float known = float(next.a > 0.0) + float(last.a > 0.0);
    vec3 rise = float(next.a > 0.0) * (next.rgb - own) + float(last.a > 0.0) * (own - last.rgb);
    return clamp(rise / max(known, 1.0), -own, own);
}

/// B at a place on the face (volume space), which fills a side of its cell: a plane that has the face's B as its mean.
vec4 light_at(vec3 position, ivec3 cell, int face) {
    vec4 own = light_of(cell, face);
    vec3 off = clamp(position - vec3(cell) - 0.5, vec3(-0.5), vec3(0.5));
    int axis = (face & 7) >> 1;
    vec3 u = vec3(axis != 0, axis == 0, 0.0);
    vec3 v = vec3(0.0, axis == 2, axis != 2);
    own.rgb += dot(off, u) * slope_of_light(own.rgb, cell, ivec3(u), face) +
               dot(off, v) * slope_of_light(own.rgb, cell, ivec3(v), face);
    return own;
}

#endif
