#include "mesh.h"

#include <stdlib.h>
#include <string.h>

#include "window.h"

/* A face: its normal, and the directions in which u and v grow. */
typedef struct Face {
  int normal[3], right[3], up[3];
} Face;
static const Face faces[6] = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},  {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                              {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},  {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                              {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},   {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}};
/* Bottom left, bottom right, top right, top left: counter-clockwise from outside. */
static const int corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

const OrrisKind layer_kinds[LAYERS] = {ORRIS_KIND_SOLID, ORRIS_KIND_CUTOUT, ORRIS_KIND_TRANSLUCENT};
const char* const block_states[BLOCK_COUNT] = {
    "minecraft:air",     "minecraft:stone",      "minecraft:grass_block", "minecraft:sand",
    "minecraft:oak_log", "minecraft:oak_leaves", "minecraft:water",       "minecraft:sea_lantern"};

static int layer_of(Block block) { return block == LEAVES ? 1 : block == WATER ? 2 : 0; }
static int is_opaque(Block block) { return block != AIR && block != LEAVES && block != WATER; }
static int is_shown(Block block, Block beside) { return !is_opaque(beside) && beside != block; }

/* Open to the sky, or as deep below what covers it. */
static int sky_light(int x, int y, int z) {
  int light = 15, above;
  for (above = y; above < HEIGHT; ++above) {
    const Block block = block_at(x, above, z);
    if (is_opaque(block)) light -= 3;
    if (block == LEAVES || block == WATER) light -= 1;
  }
  return light < 0 ? 0 : light;
}

static int lamp_light(int x, int y, int z) {
  int best = 0, dx, dy, dz;
  for (dx = -8; dx <= 8; ++dx)
    for (dy = -4; dy <= 4; ++dy)
      for (dz = -8; dz <= 8; ++dz)
        if (block_at(x + dx, y + dy, z + dz) == LAMP) {
          const int light = 15 - abs(dx) - abs(dy) - abs(dz);
          if (light > best) best = light;
        }
  return best;
}

/* How much of a corner is free: 3 all of it, 0 none. */
static int free_at(const int place[3], const Face* face, const int corner[2]) {
  int side[2][3], both[3], i, hidden = 0, sides = 0;
  for (i = 0; i < 3; ++i) {
    side[0][i] = place[i] + corner[0] * face->right[i];
    side[1][i] = place[i] + corner[1] * face->up[i];
    both[i] = place[i] + corner[0] * face->right[i] + corner[1] * face->up[i];
  }
  for (i = 0; i < 2; ++i) sides += is_opaque(block_at(side[i][0], side[i][1], side[i][2]));
  hidden = sides + (sides == 2 || is_opaque(block_at(both[0], both[1], both[2])));
  return 3 - hidden;
}

static void add_corner(OrrisVertex* out, const int at[3], const Face* face, int c, Block block) {
  int i;
  memset(out, 0, sizeof(*out));
  for (i = 0; i < 3; ++i) {
    const int half = face->normal[i] + corners[c][0] * face->right[i] + corners[c][1] * face->up[i];
    out->position[i] = (float)at[i] + 0.5f + 0.5f * (float)half;
    out->normal[i] = (int8_t)(127 * face->normal[i]);
    out->tangent[i] = (int8_t)(127 * face->right[i]);
    out->mid_block[i] = (int8_t)(-32 * half);
  }
  out->tangent[3] = -127;
  out->uv[0] = ((float)block + 0.5f + 0.499f * (float)corners[c][0]) / BLOCK_COUNT;
  out->uv[1] = 0.5f - 0.499f * (float)corners[c][1];
  out->mid_uv[0] = ((float)block + 0.5f) / BLOCK_COUNT;
  out->mid_uv[1] = 0.5f;
  out->mid_block[3] = block == LAMP ? 15 : 0;
}

static void add_face(OrrisVertex out[4], const Chunk* chunk, const int at[3], const Face* face, Block block,
                     const MeshStyle* style) {
  int beside[3], c, i, sky, lamp;
  for (i = 0; i < 3; ++i) beside[i] = at[i] + face->normal[i] + (i == 0 ? chunk->x : i == 2 ? chunk->z : 0);
  sky = sky_light(beside[0], beside[1], beside[2]);
  lamp = lamp_light(beside[0], beside[1], beside[2]);
  for (c = 0; c < 4; ++c) {
    const unsigned char shade = (unsigned char)(255 - 40 * (3 - free_at(beside, face, corners[c])));
    add_corner(&out[c], at, face, c, block);
    memset(out[c].color, style->separate_ao ? 255 : shade, 3);
    out[c].color[3] = style->separate_ao ? shade : 255;
    out[c].light[0] = (int16_t)(16 * (block == LAMP ? 15 : lamp));
    out[c].light[1] = (int16_t)(16 * sky);
    out[c].entity[0] = style->ids[block];
    out[c].entity[1] = block == WATER ? 1 : -1;
  }
}

/* Writes the faces of a layer, or counts them where there is nowhere to write. */
static unsigned walk(const Chunk* chunk, int layer, const MeshStyle* style, OrrisVertex* out) {
  unsigned count = 0;
  int at[3], f;
  for (at[0] = 0; at[0] < CHUNK; ++at[0])
    for (at[1] = 0; at[1] < HEIGHT; ++at[1])
      for (at[2] = 0; at[2] < CHUNK; ++at[2]) {
        const Block block = block_at(chunk->x + at[0], at[1], chunk->z + at[2]);
        if (block == AIR || layer_of(block) != layer) continue;
        for (f = 0; f < 6; ++f) {
          const int* n = faces[f].normal;
          if (!is_shown(block, block_at(chunk->x + at[0] + n[0], at[1] + n[1], chunk->z + at[2] + n[2])))
            continue;
          if (out != NULL) add_face(out + count, chunk, at, &faces[f], block, style);
          count += 4;
        }
      }
  return count;
}

int mesh_chunk(Chunk* chunk, const MeshStyle* style) {
  int i;
  for (i = 0; i < LAYERS; ++i) {
    Layer* layer = &chunk->layers[i];
    const unsigned count = walk(chunk, i, style, NULL);
    OrrisVertex* vertices = malloc((count + 1) * sizeof(*vertices));
    if (vertices == NULL) return 0;
    layer->vertices = walk(chunk, i, style, vertices);
    if (layer->buffer == 0) gl.GenBuffers(1, &layer->buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, layer->buffer);
    gl.BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof(*vertices)), vertices, GL_STATIC_DRAW);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    free(vertices);
  }
  return 1;
}

void fill_cube(OrrisVertex vertices[24], const unsigned char color[3]) {
  static const int middle[3] = {0, 0, 0};
  int f, c, i;
  for (f = 0; f < 6; ++f)
    for (c = 0; c < 4; ++c) {
      OrrisVertex* vertex = &vertices[4 * f + c];
      add_corner(vertex, middle, &faces[f], c, AIR);
      for (i = 0; i < 3; ++i) vertex->position[i] -= 0.5f;
      memcpy(vertex->color, color, 3);
      vertex->color[3] = 255;
      vertex->light[1] = 240;
      vertex->entity[0] = vertex->entity[1] = -1;
    }
}

unsigned make_textures(void) {
  enum { TILE = 16, WIDTH = TILE * BLOCK_COUNT, LEVELS = 4 };
  static const unsigned char base[BLOCK_COUNT][3] = {{255, 255, 255}, {125, 125, 125}, {92, 150, 60},
                                                     {219, 207, 160}, {110, 85, 50},   {60, 110, 40},
                                                     {50, 90, 200},   {235, 245, 240}};
  static unsigned char texels[TILE][WIDTH][4];
  unsigned name = 0, noise = 12345;
  int x, y, c;
  for (y = 0; y < TILE; ++y)
    for (x = 0; x < WIDTH; ++x) {
      const int block = x / TILE;
      int shade;
      noise = noise * 1664525u + 1013904223u;
      shade = block == AIR ? 256 : 216 + (int)(noise >> 26);
      for (c = 0; c < 3; ++c) {
        const int value = base[block][c] * shade / 256;
        texels[y][x][c] = (unsigned char)(value > 255 ? 255 : value);
      }
      texels[y][x][3] = block == WATER ? 160 : block == LEAVES && noise >> 30 == 0 ? 0 : 255;
    }
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, WIDTH, TILE, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, LEVELS);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return name;
}
