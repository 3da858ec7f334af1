// What has changed since table and grid were made.
#if !defined INCLUDED_LIGHTS_CHANGES
#define INCLUDED_LIGHTS_CHANGES

#include "/include/lights/lamps.glsl"

layout(r32ui) uniform uimage2D light_state;
layout(r32ui) uniform uimage2D lamp_tally;

uint state_of(int what) { return imageLoad(light_state, ivec2(what, 0)).r; }

uint tally_of(ivec2 what) { return imageLoad(lamp_tally, what).r; }

/// The checksum is of places in the volume, so it changes when that moves.
bool lights_changed() {
    return state_of(state_tables) == 0u || state_of(state_checksum) != tally_of(lamp_checksum);
}

bool view_changed() {
    return gbufferModelView != gbufferPreviousModelView ||
           gbufferProjection != gbufferPreviousProjection ||
           cameraPositionFract != previousCameraPositionFract;
}

/// Lamps of the table, also in the frame that makes it.
uint listed_lamps() { return min(tally_of(lamp_total), table_capacity); }

/// Have the lists to be made?
bool grid_changed() {
    return has_lists(listed_lamps()) &&
           (state_of(state_grids) == 0u || lights_changed() || view_changed());
}

#endif
