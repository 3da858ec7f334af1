// Shadows of the lamps near the eye: a bit of stenciltex1 for each, 1 where a volume holds what the pixel
// shows.
#if !defined INCLUDED_LIGHTS_LAMP_VOLUMES
#define INCLUDED_LIGHTS_LAMP_VOLUMES

#include "/include/lights/lamps.glsl"

uniform usampler2D stenciltex1;

// Place in player space, range in blocks; 0 where there is none.
uniform vec4 shadowVolumeLight0;
uniform vec4 shadowVolumeLight1;
uniform vec4 shadowVolumeLight2;
uniform vec4 shadowVolumeLight3;
uniform vec4 shadowVolumeLight4;
uniform vec4 shadowVolumeLight5;
uniform vec4 shadowVolumeLight6;
uniform vec4 shadowVolumeLight7;

uint lamps_hidden;  // from what the pixel shows

void read_lamp_volumes(ivec2 pixel) { lamps_hidden = texelFetch(stenciltex1, pixel, 0).r; }

vec4 volume_lamp(int i) {
    return i == 0 ? shadowVolumeLight0
#if LIGHT_VOLUMES > 1
         : i == 1 ? shadowVolumeLight1
#endif
#if LIGHT_VOLUMES > 2
         : i == 2 ? shadowVolumeLight2
         : i == 3 ? shadowVolumeLight3
#endif
#if LIGHT_VOLUMES > 4
         : i == 4 ? shadowVolumeLight4
         : i == 5 ? shadowVolumeLight5
         : i == 6 ? shadowVolumeLight6
         : i == 7 ? shadowVolumeLight7
#endif
         : vec4(0.0);
}

/// Does the light of the lamp at `place`, in lamp space, arrive? 1 for lamps without volumes.
float arrives_past_volumes(vec3 place) {
    if (lamps_hidden == 0u) return 1.0;
    for (int i = 0; i < LIGHT_VOLUMES; ++i) {
        vec3 off = abs(to_lamp_space(volume_lamp(i).xyz) - place);
        if ((lamps_hidden >> i & 1u) != 0u && max(off.x, max(off.y, off.z)) < 0.25) return 0.0;
    }
    return 1.0;
}

#ifdef SHADOW_VIEW
/// 1 where lamp `i` arrives; 0 beyond its range and on what turns away from it or lies along it.
float lamp_arrives(int i, vec3 player, vec3 normal, bool thin) {
    vec4 lamp = volume_lamp(i);
    vec3 to_lamp = lamp.xyz - player;
    float cosine = dot(normal, normalize(to_lamp));
    bool faces = (thin ? abs(cosine) : cosine) > 0.01;
    return float(faces && length(to_lamp) < lamp.w && (lamps_hidden >> i & 1u) == 0u);
}
#endif

#endif
