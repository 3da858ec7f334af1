// One pass over the terrain gives both the shadow map and the voxels: the geometry shader sends
// each triangle to the map and, for each quad, one texel to the atlas below it.
#include "/settings.glsl"
#include "/include/uniforms.glsl"
#include "/include/blocks.glsl"
#include "/include/shadow/shadow_space.glsl"
#include "/include/math/color.glsl"
#include "/include/math/encoding.glsl"
#include "/include/voxels/voxel.glsl"
#if HAS_VOXELS
#include "/include/voxels/volume.glsl"
#endif

// Texels of less are open: the game's test of cutout blocks.
const float cutout_alpha = 0.1;

#if defined VERTEX_STAGE

in vec2 mc_Entity;
in vec2 mc_midTexCoord;
in vec4 at_midBlock;

out vec2 vertex_uv;
out vec2 vertex_mid_uv;
out vec3 vertex_tint;
out vec3 vertex_center;  // of the block, player space
out float vertex_id;
out float vertex_emission;
out vec3 vertex_normal;
out float vertex_sky;  // level 0..15
out vec3 vertex_player;

void main() {
    vec4 view = gl_ModelViewMatrix * gl_Vertex;
    gl_Position = place_shadow(shadow_clip(gl_ProjectionMatrix * view));
    vertex_uv = (gl_TextureMatrix[0] * gl_MultiTexCoord0).xy;
    vertex_mid_uv = mc_midTexCoord;
    vertex_tint = gl_Color.rgb;
    vec3 player = (shadowModelViewInverse * view).xyz;
    vertex_center = player + at_midBlock.xyz / 64.0;
    vertex_id = mc_Entity.x;
    vertex_emission = block_emission(int(floor(mc_Entity.x + 0.5)), at_midBlock.w);
    vertex_normal = mat3(shadowModelViewInverse) * (gl_NormalMatrix * gl_Normal);
    vertex_sky = (gl_TextureMatrix[1] * gl_MultiTexCoord1).y * 16.0 - 0.5;
    vertex_player = player;
}

#elif defined GEOMETRY_STAGE

layout(triangles) in;
layout(triangle_strip, max_vertices = 6) out;

in vec2 vertex_uv[];
in vec2 vertex_mid_uv[];
in vec3 vertex_tint[];
in vec3 vertex_center[];
in float vertex_id[];
in float vertex_emission[];
in vec3 vertex_normal[];
in float vertex_sky[];
in vec3 vertex_player[];

out vec2 uv;
flat out vec4 voxel;  // a 0: part of the shadow map
flat out vec4 sheet;  // as include/shadow/sheets.glsl stores it; 0: nothing
flat out vec2 lattice;
flat out vec4 tile;  // part of the atlas: low, high

/// How far texture coordinates of a quad go in a block along each axis. Its first triangle has its corners in order.
mat3x2 uv_per_block() {
    vec3 a = vertex_player[1] - vertex_player[0];
    vec3 b = vertex_player[2] - vertex_player[1];
    return outerProduct((vertex_uv[1] - vertex_uv[0]) / dot(a, a), a) + outerProduct((vertex_uv[2] - vertex_uv[1]) / dot(b, b), b);
}

/// The part of the atlas that a quad shows, lower and upper end; of a pane, whose sides are made in parts, what the whole side would.
vec4 tile_of_triangle() {
    vec2 low = min(vertex_uv[0], min(vertex_uv[1], vertex_uv[2]));
    vec2 high = max(vertex_uv[0], max(vertex_uv[1], vertex_uv[2]));
    int id = int(floor(vertex_id[0] + 0.5));
    if (id == block_pane || id == block_tinted_pane) {
        mat3x2 per_block = uv_per_block();
        vec2 middle = vertex_uv[0] + per_block * (vertex_center[0] - vertex_player[0]);
        vec2 half_size = 0.5 * (abs(per_block[0]) + abs(per_block[1]) + abs(per_block[2]));
        low = middle - half_size;
        high = middle + half_size;
    }
    return vec4(mix(low, high, 0.001), mix(low, high, 0.999));
}

#if HAS_VOXELS || HAS_LAMPS

uniform sampler2D gtexture;

#include "/include/shadow/sheets.glsl"

uniform int blockEntityId;

/// Mean linear colour of the whole tile that a quad shows a part of.
vec3 tile_color() {
    return to_linear(textureLod(gtexture, vertex_mid_uv[0], 4.0).rgb) * to_linear(vertex_tint[0]);
}

/// What a triangle of the map takes of the light. Panes take as much as a block; so does water, of which more lies behind
/// air only in the air (of what is in water the voxels know the depth).
vec4 sheet_of_triangle() {
    int id = int(floor(vertex_id[0] + 0.5));
    bool holes = id == block_plant || id == block_open || id == block_glass || id == block_pane;
    if (renderStage != MC_RENDER_STAGE_TERRAIN_TRANSLUCENT) {
        if (holes) return sheet_with_holes;
#if HAS_FACE_CACHE
        return encode_opaque(tile_color());
#else
        return vec4(0.0);
#endif
    }
    float slope = abs((mat3(shadowModelView) * vertex_normal[0]).z);
    float height = id == block_translucent ? 1.0 : id == block_water ? water_height : 0.0;
    float thickness = id == block_tinted_pane ? 1.0 : height / max(slope, 0.25);
    return encode_sheet(tile_color(), thickness);
}

/// Quads of blocks, once: they arrive as pairs of triangles.
bool is_new_quad() {
    return (gl_PrimitiveIDIn & 1) == 0 && renderStage != MC_RENDER_STAGE_ENTITIES;
}

/// What is known of a block by one of its quads.
struct Block {
    vec3 middle;  // player space
    int id;
    float emission;
};

vec3 quad_low() { return min(vertex_player[0], min(vertex_player[1], vertex_player[2])); }

vec3 quad_high() { return max(vertex_player[0], max(vertex_player[1], vertex_player[2])); }

/// Vertices of block entities (chests, beds) have no id: theirs is the draw's. What is not listed counts
/// as open, as do small parts (locks, legs), which have neither the shape nor the colour of the block.
Block block_of_quad() {
    if (renderStage != MC_RENDER_STAGE_BLOCK_ENTITIES)
        return Block(vertex_center[0], int(floor(vertex_id[0] + 0.5)), vertex_emission[0]);
    vec3 size = quad_high() - quad_low();
    bool named = is_block_class(blockEntityId) && max(size.x, max(size.y, size.z)) > 0.3;
    vec3 inside = 0.5 * (quad_low() + quad_high()) - 0.01 * vertex_normal[0];
    vec3 cell = floor(inside + cameraPositionFract);
    return Block(cell + 0.5 - cameraPositionFract, named ? blockEntityId : block_open,
                 named ? lamp_level(blockEntityId) : 0.0);
}

#endif

#if HAS_LAMPS
#extension GL_ARB_shader_image_load_store : enable
#include "/include/lights/lamp_list.glsl"

void emit_lamp() {
    if (!is_new_quad()) return;
    Block block = block_of_quad();
    int level = int(clamp(block.emission, 0.0, 15.0) + 0.5);
    list_lamp(block.middle, block.id, level, brightest(tile_color()));
}
#endif

#if HAS_VOXELS
#include "/include/math/random.glsl"

#if HAS_VOXEL_CHANGES
#extension GL_ARB_shader_image_load_store : enable
#include "/include/voxels/checksum.glsl"
#include "/include/debug/count.glsl"
#define HAS_OCTANT_WRITES
#include "/include/voxels/tiles.glsl"
#endif
#if HAS_FACE_CACHE
#include "/include/face_cache/due_faces.glsl"
#endif

/// From the middle to the edges of the quad's part of the atlas.
vec2 half_uv() {
    vec2 mid = vertex_mid_uv[0];
    return max(abs(vertex_uv[0] - mid), max(abs(vertex_uv[1] - mid), abs(vertex_uv[2] - mid)));
}

/// Mean linear colour of the quad, weighted by alpha, and the mean of that: 16 taps over its part of the atlas,
/// in the level that has 16 texels a tile.
vec4 face_color() {
    vec2 half_size = half_uv();
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 16; ++i) {
        vec2 tap = vec2(i & 3, i >> 2) * 0.5 - 0.75;
        vec4 texel = textureLod(gtexture, vertex_mid_uv[0] + tap * half_size, 2.0);
        sum += vec4(to_linear(texel.rgb), 1.0) * texel.a;
    }
    return vec4(sum.rgb / max(sum.a, 1e-3) * to_linear(vertex_tint[0]), sum.a / 16.0);
}

#if HAS_VOXEL_CHANGES

/// What the alpha test leaves open of the quad, 0..1, by 256 points of its texture in full size. The mean of alpha is
/// another: a texel that is half open is drawn whole.
float open_texels() {
    vec2 half_size = half_uv();
    int open = 0;
    for (int i = 0; i < 256; ++i) {
        vec2 tap = (vec2(i & 15, i >> 4) + 0.5) / 8.0 - 1.0;
        open += int(textureLod(gtexture, vertex_mid_uv[0] + tap * half_size, 0.0).a < cutout_alpha);
    }
    return float(open) / 256.0;
}

/// Does the quad lie as those of a plant do, which cross?
bool is_plane_of_plant(vec3 normal) { return abs(abs(normal.x) - abs(normal.z)) < 0.1 && abs(normal.y) < 0.1; }

/// One of eight pictures for the texture: which plants share one is chance.
int picture_of_plant() { return int(hash(floatBitsToUint(vertex_mid_uv[0].xyy)).x >> 29u); }

/// A share in eighths, up or down by the block's place in the world, so that the mean over blocks is right.
int in_eighths(float share, ivec3 cell) {
    uvec3 place = uvec3(cell + volume_origin());
    return int(share * 8.0 + float(hash(place).x >> 8u) * (1.0 / 16777216.0));
}

#endif

/// What the block is to the voxels; a 0: nothing.
vec4 block_voxel(int id, float emission, vec3 normal, ivec3 cell) {
    vec4 face = face_color();
    vec3 color = face.rgb;
    int level = int(clamp(emission, 0.0, 15.0) + 0.5);
    if (level > 0) {
        int digit = is_lamp(id) ? id % 10 : 0;
#if HAS_VOXEL_CHANGES
        if (id == block_fire) return encode_voxel(color, voxel_fire);
        if (id == block_soul_fire) return encode_voxel(color, voxel_soul_fire);
        if (id == block_portal) return encode_voxel(color, voxel_portal + int(abs(normal.z) > 0.5));
#endif
        if (!is_small_lamp(id)) return encode_voxel(color, voxel_lamp + 16 * digit + level);
        return encode_voxel(digit > 0 ? lamp_color(digit) : brightest(color), voxel_small_lamp + level);
    }
#if HAS_VOXEL_CHANGES
    if (id == block_plant && is_plane_of_plant(normal)) return encode_voxel(color, voxel_plant + picture_of_plant());
#endif
    if (id == block_plant || id == block_open || is_small_lamp(id)) return vec4(0.0);
    bool surface = id == block_water && normal.y > 0.5;
    if (surface) return encode_voxel(color, voxel_water_surface);
    if (id == block_tinted_pane) return encode_voxel(tile_color(), voxel_tinted_pane + int(abs(normal.z) > 0.5));
    if (id == block_water || id == block_translucent) return encode_voxel(color, voxel_translucent);
    if (id == block_slab_bottom) return encode_voxel(color, voxel_slab_bottom);
    if (id == block_slab_top) return encode_voxel(color, voxel_slab_top);
#if HAS_VOXEL_CHANGES
    if (id == block_stairs) return encode_voxel(color, voxel_stairs);
    if (id == block_plate) return encode_voxel(color, voxel_plate + min(in_eighths(open_texels(), cell), 5));
    if (id == block_fence) return encode_voxel(color, voxel_fence);
    if (id == block_wall) return encode_voxel(color, voxel_wall);
    if (id == block_chest) return encode_voxel(color, voxel_chest);
    if (id == block_glass) return encode_voxel(color, voxel_glass);
    if (id == block_pane) return encode_voxel(color, voxel_pane);
    if (id == block_cover) return encode_voxel(color, voxel_cover);
    if (id == block_leaves) return encode_voxel(color, voxel_leaves);
#else
    bool is_thin = id == block_glass || id == block_pane || id == block_cover;
    if (is_thin || id == block_fence || id == block_wall || id == block_chest) return vec4(0.0);
#endif
    return encode_voxel(color, voxel_solid);
}

void emit_voxel() {
    Block block = block_of_quad();
    ivec3 cell = ivec3(floor(to_volume(block.middle)));
    if (!is_new_quad()) return;
#if HAS_FACE_CACHE
    if (vertex_normal[0].y > 0.5 && !lets_light_pass(block.id))
        note_height(to_volume(0.5 * (quad_low() + quad_high())), vertex_sky[0]);
#endif
    if (!in_volume(cell)) return;
    voxel = block_voxel(block.id, block.emission, vertex_normal[0], cell);
    if (voxel.a == 0.0) return;
    uvec3 place = uvec3(cell + volume_origin());
    voxel.rgb = in_bytes(voxel.rgb, float(hash(place).y >> 8u) * (1.0 / 16777216.0));
#if HAS_VOXEL_CHANGES
    count_voxel();
    int code = int(voxel.a * 255.0 + 0.5);
    int face = face_of(vertex_normal[0]);
    add_to_brick(cell, face, code, vertex_mid_uv[0]);
    if (code == voxel_water_surface) note_lake();
    bool side_of_pane = is_pane(code) && face != 2 && face != 3;
    if (is_glass(code) || side_of_pane || is_thin(code) || is_fire(code)) {
        vec3 across = face < 2 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
        vec3 up = face == 2 || face == 3 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
        bool upright = is_plant(code) || is_fire(code);
        if (upright) {
            across = width_of_plane(code) * side_of_plane(vertex_normal[0]);
            up = vec3(0.0, -1.0, 0.0);
        }
        note_holes(upright ? holes_of_plane(code) : holes_of_side(code, face), across, up, block.middle);
    }
    // Not the underside of its surface.
    bool bottom = vertex_normal[0].y < -0.5 && vertex_player[0].y - block.middle.y < -0.4;
    if (block.id == block_water && bottom) add_octants(cell, part_bottom);
    if (block.id == block_translucent || block.id == block_tinted_pane) note_tile(cell, tile_of_triangle());
    if (code == voxel_stairs || is_post(code) || is_ball(code)) {
        vec3 low = quad_low() - block.middle;
        vec3 high = quad_high() - block.middle;
        vec3 normal = round(vertex_normal[0]);
        add_octants(cell, code == voxel_stairs ? octants_behind(low, high, normal)
                                               : part_of_quad(code, low, high, normal));
    }
#endif
#if HAS_FACE_CACHE
    // What is thinner than half a block counts as half of it.
    float outward = dot(vertex_player[0] - block.middle, vertex_normal[0]);
    bool inner = has_octants(code) && outward < 0.25;
    int sky = int(clamp(vertex_sky[0], 0.0, 15.0) + 0.5);
    bool is_cube = is_fire(code) || (code >= voxel_lamp && abs(outward) < 0.3);
    vec3 parted = is_partition(code) ? partition_axis(code) : side_of_pane ? abs(face_normal(face)) : vec3(0.0);
    list_faces(cell, is_plant(code) ? face_of_plant : inner ? face + face_inner : face, code, sky, is_cube, parted);
#endif

    // The faces of a block share one texel; depth lets the one with the largest holes win, and the top of those
    // that are alike, whatever the order; of a pane a side that lies in its plane.
    int kind = int(voxel.a * 255.0 + 0.5);
    vec3 size = quad_high() - quad_low();
    float depth = -hole_share(kind) - (vertex_normal[0].y > 0.5 ? 0.1 : 0.0);
    if (is_plant(kind)) depth = 0.5;  // below the water that it stands in
    if (is_tinted_pane(kind) || is_pane(kind)) depth = abs(vertex_normal[0].y) < 0.5 && max(size.x, size.z) > 0.3 ? -0.5 : 0.0;
    // A right angle at the texel's corner that holds its centre and no other.
    vec2 corner = vec2(atlas_texel(cell));
    const vec2 legs[3] = vec2[3](vec2(0.0), vec2(1.5, 0.0), vec2(0.0, 1.5));
    for (int i = 0; i < 3; ++i) {
        vec2 unit = (corner + legs[i]) / float(SHADOW_TARGET);
        gl_Position = vec4(unit * 2.0 - 1.0, depth, 1.0);
        uv = vec2(0.0);
        sheet = vec4(0.0);
        lattice = vec2(0.0);
        tile = vec4(0.0);
        EmitVertex();
    }
    EndPrimitive();
}

#endif

void emit_triangle() {
    sheet = vec4(0.0);
#if HAS_VOXELS
    sheet = sheet_of_triangle();
#endif
    lattice = shadow_lattice();
    tile = tile_of_triangle();
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        uv = vertex_uv[i];
        voxel = vec4(0.0);
        EmitVertex();
    }
    EndPrimitive();
}

void main() {
#if HAS_SHADOW_MAP
    emit_triangle();
#endif
#if HAS_VOXELS
    emit_voxel();
#endif
#if HAS_LAMPS
    emit_lamp();
#endif
}

#else

in vec2 uv;
flat in vec4 voxel;
flat in vec4 sheet;
flat in vec2 lattice;
flat in vec4 tile;

uniform sampler2D gtexture;

/// What reaches over an edge of that part goes on at the opposite one, as in a neighbour with the same texture: the edge itself, a
/// frame of glass, would count too often.
vec2 in_tile(vec2 place) {
    vec2 size = max(tile.zw - tile.xy, vec2(1e-7));
    return tile.xy + size * fract((place - tile.xy) / size);
}

/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 out_voxel;

void main() {
    bool in_map = gl_FragCoord.y >= float(shadow_map_bottom);
    bool is_voxel = voxel.a > 0.0;
    // Triangles that cross the lower edge of the map would cover voxels.
    if (in_map == is_voxel) discard;
    // Holes by one point of the texel each, another in every texel, so that their mean is right however they lie to the
    // lattice of texels. Of the full size: the mean alpha of a smaller level would close what is open.
    vec2 off = point_in_texel(gl_FragCoord.xy - lattice) - 0.5;
    vec2 place = in_tile(uv + dFdx(uv) * off.x + dFdy(uv) * off.y);
    if (!is_voxel && textureLod(gtexture, place, 0.0).a < cutout_alpha) discard;
    out_voxel = is_voxel ? voxel : vec4(in_bytes(sheet.rgb, off.x + 0.5), sheet.a);
}

#endif
