// The voxel volume: VOLUME x VOLUME_HEIGHT x VOLUME cells of one block, centred on the camera's cell,
// and its place in a 2-D atlas.
//
//   volume space  player space + cameraPositionFract + volume_size / 2; cells are floor() of it
//   atlas         one tile of VOLUME x VOLUME texels for each layer y, left to right, then up:
//                 texel = (y mod COLUMNS, y div COLUMNS) * VOLUME + (x, z)
//
// Cells are tested before they are mapped: y+1 of the top layer would otherwise land in the tile
// of another layer.
#if !defined INCLUDED_VOXELS_VOLUME
#define INCLUDED_VOXELS_VOLUME

#include "/include/uniforms.glsl"

const ivec3 volume_size = ivec3(VOLUME, VOLUME_HEIGHT, VOLUME);
const ivec2 atlas_size = ivec2(ATLAS_COLUMNS, ATLAS_ROWS) * VOLUME;

bool in_volume(ivec3 cell) {
    return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, volume_size));
}

/// Only for cells in the volume.
ivec2 atlas_texel(ivec3 cell) {
    int row = cell.y / ATLAS_COLUMNS;
    return ivec2(cell.y - row * ATLAS_COLUMNS, row) * VOLUME + cell.xz;
}

/// Inverse of atlas_texel; spare tiles give a cell outside the volume.
ivec3 atlas_cell(ivec2 texel) {
    ivec2 tile = texel / VOLUME;
    ivec2 within = texel - tile * VOLUME;
    return ivec3(within.x, tile.y * ATLAS_COLUMNS + tile.x, within.y);
}

vec3 to_volume(vec3 player) { return player + cameraPositionFract + vec3(volume_size / 2); }

vec3 from_volume(vec3 position) { return position - cameraPositionFract - vec3(volume_size / 2); }

/// The volume's edge sees too little: 1 inside, fading to 0 over the outermost four cells.
float inside_volume(vec3 position) {
    vec3 margin = min(position, vec3(volume_size) - position);
    return clamp(min(margin.x, min(margin.y, margin.z)) / 4.0, 0.0, 1.0);
}

/// How many cells the volume moved since the last frame; a cell was at cell + scroll before.
/// Whole blocks as the host gives them: int() of a position would make the cell at 0 two wide.
ivec3 volume_scroll() { return cameraPositionInt - previousCameraPositionInt; }

/// Floor of a / size. The guess by floats is one off at most.
ivec3 divide_down(ivec3 a, ivec3 size) {
    ivec3 q = ivec3(floor(vec3(a) * (1.0 / vec3(size))));
    ivec3 rest = a - q * size;
    return q - ivec3(lessThan(rest, ivec3(0))) + ivec3(greaterThanEqual(rest, size));
}

/// Remainder, never negative. `size` is a constant.
ivec3 wrap(ivec3 a, ivec3 size) {
    return (size & (size - 1)) == ivec3(0) ? a & (size - 1) : a - divide_down(a, size) * size;
}

/// World block of the volume's first cell.
ivec3 volume_origin() { return cameraPositionInt - volume_size / 2; }

ivec3 volume_origin_before() { return previousCameraPositionInt - volume_size / 2; }

/// Was the cell outside of the volume in the frame before?
bool entered(ivec3 cell) { return !in_volume(cell + volume_scroll()); }

/// Place of a cell in the images that are kept: the same wherever the volume moves.
ivec3 store_cell(ivec3 cell) { return wrap(volume_origin() + cell, volume_size); }

/// Inverse of store_cell.
ivec3 stored_at(ivec3 place) { return wrap(place - volume_origin(), volume_size); }

const int face_up = 3;

// Added to the number of a face that lies in the middle of its cell.
const int face_inner = 8;

// That of both planes of a plant.
const int face_of_plant = face_inner + face_up;

/// Of an axis-parallel normal: 0..5 = -x +x -y +y -z +z.
int face_of(vec3 normal) {
    vec3 size = abs(normal);
    if (size.x > size.y && size.x > size.z) return normal.x > 0.0 ? 1 : 0;
    if (size.y > size.z) return normal.y > 0.0 ? 3 : 2;
    return normal.z > 0.0 ? 5 : 4;
}

/// Its inverse, and that of an inner face.
vec3 face_normal(int face) {
    int axis = (face & 7) >> 1;
    return vec3(axis == 0, axis == 1, axis == 2) * ((face & 1) == 1 ? 1.0 : -1.0);
}

#endif
