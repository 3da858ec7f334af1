// Shadows of the lamps that light a point most: a ray through the voxels to each of LIGHT_SHADOWS.
#if !defined INCLUDED_LIGHTS_LAMP_SHADOWS
#define INCLUDED_LIGHTS_LAMP_SHADOWS

#include "/include/lights/lamps.glsl"
#include "/include/voxels/trace.glsl"

// Off the surface, in blocks, as far as rays of global illumination begin.
const float lamp_ray_offset = 0.02;

/// Strongest first.
struct Strongest {
    vec3 light[LIGHT_SHADOWS];  // irradiance
    vec3 place[LIGHT_SHADOWS];  // lamp space
};

Strongest no_lamps() {
    Strongest none;
    for (int i = 0; i < LIGHT_SHADOWS; ++i) {
        none.light[i] = vec3(0.0);
        none.place[i] = vec3(0.0);
    }
    return none;
}

/// Ties keep their order, which is that of the table.
void keep_strongest(inout Strongest kept, vec3 light, vec3 place) {
    for (int i = 0; i < LIGHT_SHADOWS; ++i) {
        bool stronger = dot(light, vec3(1.0)) > dot(kept.light[i], vec3(1.0));
        vec3 weaker_light = stronger ? kept.light[i] : light;
        vec3 weaker_place = stronger ? kept.place[i] : place;
        kept.light[i] = stronger ? light : kept.light[i];
        kept.place[i] = stronger ? place : kept.place[i];
        light = weaker_light;
        place = weaker_place;
    }
}

/// What of a lamp's light arrives, by colour. Beyond the volume of voxels nothing hides it.
vec3 lamp_visibility(vec3 player, vec3 normal, vec3 lamp) {
    vec3 target = to_volume(from_lamp_space(lamp));
    vec3 origin = to_volume(player);
    // Of a leaf either side.
    origin += normal * (lamp_ray_offset * sign(dot(target - origin, normal)));
    if (!in_volume(ivec3(floor(origin)))) return vec3(1.0);
    Hit hit = trace(origin, normalize(target - origin), voxel_at(ivec3(floor(origin))).code, ray_from_point);
    bool sees = !hit.found || hit.cell == ivec3(floor(target)) ||
                distance(hit.position, origin) > distance(target, origin);
    return sees ? hit.transmittance : vec3(0.0);
}

/// What walls, glass and water keep of the light of the lamps kept.
vec3 hidden_light(Strongest kept, vec3 player, vec3 normal) {
    vec3 hidden = vec3(0.0);
    for (int i = 0; i < LIGHT_SHADOWS; ++i) {
        if (kept.light[i] == vec3(0.0)) break;
        hidden += kept.light[i] * (1.0 - lamp_visibility(player, normal, kept.place[i]));
    }
    return hidden;
}

#endif
