// Notes what table and grid are made for, and what did not fit.
#include "/settings.glsl"

#include "/include/lights/changes.glsl"

layout(local_size_x = 1) in;
const ivec3 workGroups = ivec3(1, 1, 1);

void note(int what, uint value) { imageStore(light_state, ivec2(what, 0), uvec4(value)); }

void main() {
    bool table = lights_changed();
#if HAS_LIGHT_GRID
    if (grid_changed()) {
        note(state_spilled, tally_of(lamp_spilled));
        note(state_longest, tally_of(lamp_longest));
        note(state_entries, tally_of(lamp_entries));
        note(state_grids, state_of(state_grids) + 1u);
    }
#endif
    if (!table) return;
    note(state_checksum, tally_of(lamp_checksum));
    note(state_lamps, listed_lamps());
    note(state_lamps_dropped, tally_of(lamp_total) - listed_lamps());
    note(state_tables, state_of(state_tables) + 1u);
}
