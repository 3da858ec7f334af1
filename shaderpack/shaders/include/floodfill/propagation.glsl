// What light a cell has after a step, from that of its six neighbours before it.
//
//   PUBLISHED   I' = alpha/6 * (sum over the open neighbours of I^gamma)^(1/gamma)
//     The power is taken before the sum, so the rule is linear in I^gamma; it stays bounded while
//     alpha < 6^(1 - 1/gamma).
//   CONSERVING  I' = (sum over the neighbours of I, E of a lamp, albedo * own I of a wall) / 6
//     Loses no light in the open: a diffusion, too bright far away where the other is too dark.
//     Slow: its time grows with the square of a room's size.
#if !defined INCLUDED_FLOODFILL_PROPAGATION
#define INCLUDED_FLOODFILL_PROPAGATION

#include "/include/floodfill/light_field.glsl"
#include "/include/math/half.glsl"
#if FLOODFILL_SKY == PUBLISHED
#include "/include/shadow/shadow.glsl"
#include "/include/sky/sky.glsl"

const int sky_reach = 20;  // cells that are searched for a roof

/// Sun and sky by which a cell's neighbours add to its light.
struct Daylight {
    vec3 sky;  // 0 under a roof
    vec3 sun;  // radiance of a white face that looks at it; 0 in shadow
    vec3 direction;
};

Daylight daylight_at(ivec3 cell) {
    bool open = true;
    for (int i = 1; i <= sky_reach && open; ++i)
        open = !is_opaque_voxel(voxel_at(cell + ivec3(0, i, 0)).code);
    Daylight day;
    day.direction = light_direction();
    float sun = light_visibility(from_volume(vec3(cell) + 0.5), day.direction, day.direction, 0,
                                 float(open));
    day.sky = open ? sky_zenith() : vec3(0.0);
    day.sun = sun / pi * light_irradiance();
    return day;
}

/// As published: the whole sky from every side of a cell that has no roof, as if walls mirrored it,
/// and the sun that a wall reflects towards the cell. Added under the power, so that in the open the
/// sky is counted G/(1 - G) times, 11.2 with the published constants.
vec3 daylight_from(Voxel v, ivec3 offset, Daylight day) {
    if (v.code == voxel_air) return day.sky;
    return v.color * (day.sky + day.sun * max(dot(vec3(-offset), day.direction), 0.0));
}
#endif

// pow is undefined at 0. A darkness of 1e-14 keeps the sum a normal float for every gamma and is 0
// again in a half float.
vec3 to_power(vec3 light) { return pow(max(light, vec3(1e-14)), vec3(FLOODFILL_GAMMA)); }

vec3 from_power(vec3 sum) { return pow(sum, vec3(1.0 / FLOODFILL_GAMMA)); }

/// Does a slab close the side of its cell that looks towards `offset`? Then a wall is there.
bool closes(int code, ivec3 offset) {
    return offset.y == (code == voxel_slab_bottom ? -1 : 1) &&
           (code == voxel_slab_bottom || code == voxel_slab_top);
}

/// Light a neighbour sends: selected by what it is, never multiplied, as infinity times 0 is not 0.
/// What left the volume as it moved sends none.
vec3 light_from(Voxel v, ivec3 there, ivec3 scroll, vec3 own) {
    if (is_lamp_voxel(v.code)) return lamp_radiance(v);
#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
    if (is_opaque_voxel(v.code)) return v.color * own;
#else
    if (is_opaque_voxel(v.code)) return vec3(0.0);
#endif
    return in_volume(there) ? light_at(there + scroll) : vec3(0.0);
}

/// `self`: the cell's voxel. `scroll`: a cell was at cell + scroll when the light was stored.
vec3 propagate(ivec3 cell, Voxel self, ivec3 scroll) {
    vec3 own = vec3(0.0);
#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
    own = light_at(cell + scroll);
#endif
#if FLOODFILL_SKY == PUBLISHED
    Daylight day = daylight_at(cell);
#endif
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        int axis = i >> 1;
        ivec3 offset = ivec3(axis == 0, axis == 1, axis == 2) * (1 - 2 * (i & 1));
        Voxel v = voxel_at(cell + offset);
        if (closes(v.code, -offset)) v.code = voxel_solid;
        if (closes(self.code, offset)) v = Voxel(self.color, voxel_solid);
        vec3 light = light_from(v, cell + offset, scroll, own);
#if FLOODFILL_SKY == PUBLISHED
        light += daylight_from(v, offset, day);
#endif
#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
        sum += light;
#else
        sum += to_power(light);
#endif
    }
#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
    return sum / 6.0;
#else
    return from_power(sum) * (FLOODFILL_ALPHA / 6.0);
#endif
}

/// What is stored of a cell in a frame; without a step what was stored of it before. What power_step.glsl steps gets the
/// colour of glass and water by program/floodfill/image_tint.glsl.
vec3 next_light(ivec3 cell, ivec3 scroll, bool step_now) {
    Voxel own = voxel_at(cell);
    vec3 light = step_now ? propagate(cell, own, scroll) : light_at(cell + scroll);
    if (step_now && is_filter_voxel(own.code)) light *= own.color;
    if (is_opaque_voxel(own.code)) light = vec3(0.0);
    if (is_lamp_voxel(own.code)) light = lamp_radiance(own);
    if (!in_volume(cell)) light = vec3(0.0);
    light = clamp(light, 0.0, light_max);
#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
    return light;
#else
    return round_to_half(light);
#endif
}

#endif
