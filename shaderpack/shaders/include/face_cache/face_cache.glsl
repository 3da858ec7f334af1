// Radiance cached for each exposed face of a block: B, the mean incoming radiance over the face from
// everything but the direct sun, so that a ray that ends there sees albedo * (sun + B).
//
//   face_light   rgba16f, 9 places a cell at (9 x + place, y, z): rgb B / face_unit, a number of updates. Places 0..5
//                are the faces on the sides of the cell, 6..8 those in the middle of it, by axis: treads of
//                stairs, tops of slabs. A shape with octants looks one way along an axis there. Of full blocks they are
//                the upper halves of faces beside a pane, which parts their light, and of the sides of small openings
//                (light_at.glsl).
//                Cells keep their place when the camera moves (store_cell), so nothing is copied.
//                Behind them (recent_texel) lie means of the last few updates, which updates look up: what is reflected often,
//                in bright rooms, comes to rest sooner by quick steps, whose noise the slow mean takes away (Polyak &
//                Juditsky 1992, "Acceleration of Stochastic Approximation by Averaging").
//   face_list    r32ui, kept: the faces to update in this frame, then the faces of lamps; see pack_face. Then a row of frames:
//                of the last edit, of the one before, and of the eye's last motion
//   face_fresh   rgba16f, the new samples of the faces of the list, as B / face_unit, and on how many updates the old light
//                rests: all updates read the old light, so that the order in which they run does not matter
//   face_memory  r32ui, kept: checksums of the bricks in the frame before (include/voxels/changes.glsl)
//   face_seen    r32ui, empty when a frame begins: which faces of a cell are in the list, and in a layer behind them the
//                lengths of the lists
//
// The shadow pass makes the lists from the quads that it draws: what the mesh hides is not exposed.
// faces: 0..5 = -x +x -y +y -z +z on the side of the cell; + face_inner: in the middle of it.
#if !defined INCLUDED_FACE_CACHE_FACE_CACHE
#define INCLUDED_FACE_CACHE_FACE_CACHE

#include "/include/voxels/changes.glsl"

const int face_ball = 6;  // a small lamp, which has no faces
const int face_places = 9;

// After an edit all faces are updated for so many frames, and what they hold counts for nothing. Where edits follow each other
// sooner than face_calm_frames, half of the faces are, in turn, and what they hold counts for no more than a few updates. The
// means over frames that pixels keep are cut to so many frames, too.
const int face_hurry_frames = 48;
const int face_calm_frames = 32;
const float face_edited_updates = 24.0;

// Sizes of the lists; shaders.properties repeats LIST_WIDTH and the sum of the rows.
const int list_width = 1024;
const int face_rows = 256;
const int lamp_rows = 16;
const uint face_capacity = uint(list_width * face_rows);
const uint lamp_capacity = uint(list_width * lamp_rows);

// Lengths of the lists, in face_seen.
const ivec3 listed_faces_texel = ivec3(0, VOLUME - 1, VOLUME);
const ivec3 listed_lamps_texel = ivec3(1, VOLUME - 1, VOLUME);
// The last row of face_list.
const ivec2 last_edit = ivec2(0, face_rows + lamp_rows);
const ivec2 edit_before = last_edit + ivec2(1, 0);
const ivec2 last_motion = last_edit + ivec2(2, 0);

/// Do edits follow each other? `last`, `before`: the frames of the last two; 0: there was none.
bool edits_follow(int last, int before) { return before > 0 && last - before <= face_calm_frames; }

/// Do the faces still adapt to an edit? `last`: its frame.
bool light_changes(uint last) {
    int since = frameCounter - int(last);
    return since >= 0 && since <= face_hurry_frames;
}

int place_of_face(int face) { return face < face_inner ? face : 6 + ((face - face_inner) >> 1); }

ivec3 face_texel(ivec3 cell, int face) {
    ivec3 place = store_cell(cell);
    return ivec3(place.x * face_places + place_of_face(face), place.yz);
}

ivec3 recent_texel(ivec3 texel) { return texel + ivec3(0, 0, VOLUME); }

/// An entry of the lists; `level`, 0..15: of the sky's light at the face, or of a lamp's own.
uint pack_face(ivec3 cell, int face, int level) {
    uvec3 c = uvec3(cell);
    return c.x | c.y << 7 | c.z << 14 | uint(face) << 21 | uint(level) << 25;
}

ivec3 packed_cell(uint entry) {
    return ivec3(uvec3(entry, entry >> 7, entry >> 14) & 127u);
}

int packed_face(uint entry) { return int(entry >> 21 & 15u); }

float entry_level(uint entry) { return float(entry >> 25) / 15.0; }

ivec2 face_slot(uint index) {
    return ivec2(int(index) % list_width, int(index) / list_width);
}

ivec2 lamp_slot(uint index) { return face_slot(index) + ivec2(0, face_rows); }

// Below 2^-14 half floats have steps of 2^-24, and an update that changes a mean by less than half of one is lost: what
// came through stained glass of another colour only grew. Small lamps, the brightest there is, have 5 EMISSION_STRENGTH.
const float face_unit = EMISSION_STRENGTH / 2048.0;
const float face_light_max = 65504.0 * face_unit;

/// Brightness of garbage is none: B and number of updates, or 0.
vec4 trusted(vec4 stored) {
    bvec4 above = greaterThanEqual(stored, vec4(0.0));
    bvec4 below = lessThanEqual(stored, vec4(65504.0));
    return all(above) && all(below) ? vec4(stored.rgb * face_unit, stored.a) : vec4(0.0);
}

#endif
