// Light of one lamp on a surface.
#if !defined INCLUDED_LIGHTS_LAMP_LIGHT
#define INCLUDED_LIGHTS_LAMP_LIGHT

#include "/include/lights/lamps.glsl"
#if HAS_LAMP_GLOSS
#include "/include/brdf/direct.glsl"
#endif
#include "/include/math/sampling.glsl"
#include "/include/voxels/voxel.glsl"

// Mean area that a cube shows to an observer (Cauchy: a quarter of its surface).
const float cube_area = 1.5;
const float ball_area = pi * small_lamp_radius * small_lamp_radius;

// A spot's light is full up to 30 degrees off its axis and gone at 50; its power is that of the ball.
const float spot_full = 0.866;
const float spot_none = 0.643;
const float spot_gain = 2.0 / (1.0 - spot_full + (spot_full - spot_none) / 3.0);

// A little less than half a block: faces of the neighbours are lit.
const float own_cell = 0.49;

struct Light {
    vec3 place;       // lamp space
    float inverse;    // 1 / range^2
    vec3 intensity;   // irradiance at distance 1
    float radius;     // squared, or minus (direction + 1) of a spot
};

/// `lamp` of pack_lamp in a cell.
Light make_light(ivec3 cell, uint lamp) {
    int kind = packed_kind(lamp);
    float level = float(packed_level(lamp));
    float range = LIGHT_RANGE * level;  // blocks: that of the game's light levels
    float area = kind == kind_cube ? cube_area : ball_area;
    float gain = kind == kind_cube ? 1.0 : small_lamp_boost;
    if (kind >= kind_spot) gain *= spot_gain;
    Light light;
    light.place = vec3(cell) + 0.5;
    light.inverse = 1.0 / (range * range);
    light.intensity = packed_color(lamp) * (EMISSION_STRENGTH * level * level / 225.0 * gain * area);
    // No nearer does irradiance grow: there it is that of the lamp's radiance from all sides.
    light.radius = kind >= kind_spot ? -float(kind - kind_spot + 1) : area / pi;
    return light;
}

/// Share of a spot's intensity; `to_lamp` from the surface.
float spot_share(float direction, vec3 to_lamp, float inverse_distance) {
    float along = direction < 2.5 ? to_lamp.x : direction < 4.5 ? to_lamp.y : to_lamp.z;
    bool positive = direction == 2.0 || direction == 4.0 || direction == 6.0;
    float cosine = along * inverse_distance * (positive ? -1.0 : 1.0);
    float share = clamp((cosine - spot_none) / (spot_full - spot_none), 0.0, 1.0);
    return share * share;
}

/// Irradiance of what faces the lamp: inverse square, windowed to be 0 at the range (Karis 2013, "Real
/// Shading in Unreal Engine 4"), so that leaving out lamps beyond it changes nothing.
vec3 light_on_facing(vec4 place, vec4 power, vec3 to_lamp, float squared, float inverse) {
    // What a lamp's own cell holds is the lamp: it shines, and is not lit by itself.
    float off = max(abs(to_lamp.x), max(abs(to_lamp.y), abs(to_lamp.z)));
    float outside = step(own_cell, off);
    float reach = squared * place.w;
    float window = max(1.0 - reach * reach, 0.0);
    float radius = power.w > 0.0 ? power.w : small_lamp_radius * small_lamp_radius;
    float spot = power.w > 0.0 ? 1.0 : spot_share(-power.w, to_lamp, inverse);
    return power.xyz * (outside * spot * window * window / max(squared, radius));
}

/// Irradiance. `thin`: lit from either side, 1.
vec3 light_irradiance_at(vec4 place, vec4 power, vec3 position, vec3 normal, float thin) {
    vec3 to_lamp = place.xyz - position;
    float squared = dot(to_lamp, to_lamp);
    float inverse = inversesqrt(max(squared, 1e-8));
    float cosine = dot(to_lamp, normal) * inverse;
    cosine = max(max(cosine, -thin * cosine), 0.0);
    return cosine * light_on_facing(place, power, to_lamp, squared, inverse);
}

#if HAS_LAMP_GLOSS
/// Radiance toward `view`, reflected as the sun's is.
vec3 light_reflected_at(vec4 place, vec4 power, vec3 position, vec3 normal, float thin, vec3 albedo,
                        vec3 view) {
    vec3 to_lamp = place.xyz - position;
    float squared = dot(to_lamp, to_lamp);
    float inverse = inversesqrt(max(squared, 1e-8));
    vec3 n = thin * dot(to_lamp, normal) < 0.0 ? -normal : normal;
    return light_on_facing(place, power, to_lamp, squared, inverse) *
           reflect_direct(albedo, n, view, to_lamp * inverse);
}
#endif

#endif
