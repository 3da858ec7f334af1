// The light of all lamps on a surface: of the whole table, or of the lists of its cluster.
#if !defined INCLUDED_LIGHTS_LIT_BY_LAMPS
#define INCLUDED_LIGHTS_LIT_BY_LAMPS

#if HAS_LAMP_SHADOWS
#define HAS_VOXEL_READS
#include "/include/lights/lamp_shadows.glsl"
#endif
#include "/include/lights/lamp_light.glsl"
#if HAS_LAMP_VOLUMES && defined HAS_LAMP_VOLUME_READS
#include "/include/lights/lamp_volumes.glsl"
#endif

layout(rgba32f) uniform readonly image2D light_table;
layout(r32ui) uniform readonly uimage2D light_state;

#if HAS_LIGHT_GRID
#include "/include/lights/grid.glsl"

layout(r16ui) uniform readonly uimage3D light_list;
layout(r32ui) uniform readonly uimage3D light_bits;
#endif

#if HAS_LAMP_SHADOWS
Strongest strongest;  // of the lamps asked for this point
#endif
#if HAS_LAMP_GLOSS
vec3 lamp_albedo;  // of this point
vec3 lamp_view;    // from it to the eye
#endif

/// Irradiance; with LIGHT_GLOSS what of it is reflected to the eye.
vec3 light_of_lamp(uint lamp, vec3 position, vec3 normal, float thin) {
    ivec2 texel = table_texel(lamp);
    vec4 place = imageLoad(light_table, texel);
    vec4 power = imageLoad(light_table, texel + ivec2(1, 0));
#if HAS_LAMP_GLOSS
    vec3 light = light_reflected_at(place, power, position, normal, thin, lamp_albedo, lamp_view);
#else
    vec3 light = light_irradiance_at(place, power, position, normal, thin);
#endif
#if HAS_LAMP_VOLUMES && defined HAS_LAMP_VOLUME_READS
    light *= arrives_past_volumes(place.xyz);
#endif
#if HAS_LAMP_SHADOWS
    keep_strongest(strongest, light, place.xyz);
#endif
    return light;
}

uint lamp_count() { return imageLoad(light_state, ivec2(state_lamps, 0)).r; }

#if HAS_LIGHT_GRID
bool has_list(ivec2 cluster) { return has_lists(lamp_count()) && cluster != no_cluster; }

/// Lamps to ask at the cluster; without a list all.
uint cluster_length(ivec2 cluster) {
    return has_list(cluster) ? imageLoad(light_bits, ivec3(length_word, cluster)).r : lamp_count();
}

uint cluster_count(ivec2 cluster) { return packed_lamps(cluster_length(cluster)); }

vec3 cluster_irradiance(ivec2 cluster, vec3 position, vec3 normal, float thin) {
    vec3 sum = vec3(0.0);
    bool listed = has_list(cluster);
    uint length = cluster_length(cluster);
    uint count = packed_lamps(length);
    int end_of_list = int(listed ? min(count, list_capacity) : count);
    for (int i = 0; i < end_of_list; ++i) {
        uint lamp = listed ? imageLoad(light_list, ivec3(i, cluster)).r : uint(i);
        sum += light_of_lamp(lamp, position, normal, thin);
    }
    // Those beyond, in the table's order still.
    int first = int(packed_rest(length)) - 1;
    int end = first < 0 ? first : (int(lamp_count()) + 31) / 32;
    for (int word = first; word < end; ++word)
        for (uint bits = imageLoad(light_bits, ivec3(word, cluster)).r; bits != 0u; bits &= bits - 1u)
            sum += light_of_lamp(uint(word * 32 + findLSB(bits)), position, normal, thin);
    return sum;
}
#endif

vec3 table_irradiance(vec3 position, vec3 normal, float thin) {
    vec3 sum = vec3(0.0);
    uint count = lamp_count();
    for (uint i = 0u; i < count; ++i) sum += light_of_lamp(i, position, normal, thin);
    return sum;
}

/// What a surface reflects of the lamps; `thin`: 1 if it is lit from either side.
vec3 lamps_radiance(vec3 player, vec3 normal, float thin, vec3 albedo) {
    vec3 position = to_lamp_space(player);
#if HAS_LAMP_GLOSS
    lamp_albedo = albedo;
    lamp_view = -normalize(player);
#endif
#if HAS_LAMP_SHADOWS
    strongest = no_lamps();
#endif
#if HAS_LIGHT_GRID
    vec3 view = (gbufferModelView * vec4(player, 1.0)).xyz;
    vec3 light = cluster_irradiance(cluster_of(view), position, normal, thin);
#else
    vec3 light = table_irradiance(position, normal, thin);
#endif
#if HAS_LAMP_SHADOWS
    light = max(light - hidden_light(strongest, player, normal), 0.0);
#endif
#if HAS_LAMP_GLOSS
    return light;
#else
    return albedo / pi * light;
#endif
}

#endif
