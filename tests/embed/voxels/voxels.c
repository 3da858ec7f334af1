/* A small voxel engine that draws its own world with a shader pack: voxels PACK OUT.ppm [FRAMES [TIME]]
 * Context, blocks, meshes, textures and the buffer of the window are its own; of Orris it has <orris/orris.h>. */
#include <math.h>
#include <orris/orris.h>
#include <stdio.h>
#include <stdlib.h>

#include "mesh.h"
#include "terrain.h"
#include "window.h"

enum { WIDTH = 320, HEIGHT_PIXELS = 180 };

typedef struct Engine {
  OrrisContext* context;
  OrrisRenderer* renderer;
  Chunk chunks[CHUNKS * CHUNKS];
  MeshStyle style;
  uint32_t generation;
  unsigned textures;
  unsigned cube_array, cube_buffer;
  unsigned window; /* framebuffer */
  int32_t pig;     /* id of the entity */
  double pig_at[3];
  int batches, camera_calls, shadow_calls;
} Engine;

static int must(OrrisStatus status) {
  if (status != ORRIS_OK) fprintf(stderr, "voxels: %s: %s\n", orris_status_name(status), orris_last_error());
  return status == ORRIS_OK;
}

static void print(const OrrisDiagnostic* diagnostic, void* user) {
  (void)user;
  if (diagnostic->severity == ORRIS_ERROR) fprintf(stderr, "%s\n", diagnostic->text);
}

/* The pack may have given other numbers to blocks, or wants other colours. */
static int follow_pack(Engine* engine) {
  OrrisPackFacts facts;
  int i;
  facts.struct_size = sizeof(facts);
  if (!must(orris_renderer_pack_facts(engine->renderer, &facts))) return 0;
  if (facts.generation == engine->generation) return 1;
  engine->generation = facts.generation;
  engine->style.separate_ao = facts.separate_ao;
  for (i = 0; i < BLOCK_COUNT; ++i)
    if (!must(orris_renderer_block_id(engine->renderer, block_states[i], &engine->style.ids[i]))) return 0;
  for (i = 0; i < CHUNKS * CHUNKS; ++i)
    if (!mesh_chunk(&engine->chunks[i], &engine->style)) return 0;
  return must(orris_renderer_entity_id(engine->renderer, "minecraft:pig", &engine->pig));
}

static int submit_chunks(Engine* engine) {
  int i, layer;
  for (i = 0; i < CHUNKS * CHUNKS; ++i)
    for (layer = 0; layer < LAYERS; ++layer) {
      const Chunk* chunk = &engine->chunks[i];
      OrrisBatch batch;
      if (chunk->layers[layer].vertices == 0) continue;
      orris_batch_init(&batch, sizeof(batch));
      batch.kind = layer_kinds[layer];
      batch.origin[0] = chunk->x;
      batch.origin[2] = chunk->z;
      batch.textures.albedo = engine->textures;
      batch.vertex_buffer = chunk->layers[layer].buffer;
      batch.count = chunk->layers[layer].vertices;
      if (!must(orris_renderer_submit(engine->renderer, &batch))) return 0;
      ++engine->batches;
    }
  return 1;
}

/* The pig is drawn with GL calls of the engine, in each pass of its kind. */
static void draw_pig(OrrisDraw* draw, void* user) {
  Engine* engine = user;
  OrrisDrawFacts facts;
  OrrisBatch values;
  int i;
  facts.struct_size = sizeof(facts);
  if (!must(orris_draw_facts(draw, &facts))) return;
  ++*(facts.shadow ? &engine->shadow_calls : &engine->camera_calls);
  orris_batch_init(&values, sizeof(values));
  values.entity = engine->pig;
  values.textures.albedo = engine->textures;
  for (i = 0; i < 3; ++i) values.origin[i] = engine->pig_at[i];
  gl.BindVertexArray(engine->cube_array);
  gl.BindBuffer(GL_ARRAY_BUFFER, engine->cube_buffer);
  if (!must(orris_draw_set(draw, &values))) return;
  if (!must(orris_draw_bind_vertices(draw, sizeof(OrrisVertex), 0))) return;
  for (i = 0; i < 6; ++i) gl.DrawArrays(facts.patches ? GL_PATCHES : GL_TRIANGLE_FAN, 4 * i, 4);
}

static void make_pig(Engine* engine) {
  static const unsigned char pink[3] = {240, 130, 160};
  OrrisVertex vertices[24];
  fill_cube(vertices, pink);
  gl.GenVertexArrays(1, &engine->cube_array);
  gl.GenBuffers(1, &engine->cube_buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, engine->cube_buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(vertices), vertices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

static void make_window_buffer(Engine* engine) {
  unsigned texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, WIDTH, HEIGHT_PIXELS, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.GenFramebuffers(1, &engine->window);
  gl.BindFramebuffer(GL_FRAMEBUFFER, engine->window);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
}

static int start(Engine* engine, const char* pack) {
  OrrisRendererRequest request;
  int i;
  make_terrain();
  for (i = 0; i < CHUNKS * CHUNKS; ++i) {
    engine->chunks[i].x = CHUNK * (i % CHUNKS);
    engine->chunks[i].z = CHUNK * (i / CHUNKS);
  }
  engine->textures = make_textures();
  make_pig(engine);
  make_window_buffer(engine);
  orris_renderer_request_init(&request, sizeof(request));
  request.width = WIDTH;
  request.height = HEIGHT_PIXELS;
  request.pack = pack;
  request.on_diagnostic = print;
  return must(orris_context_adopt(engine_proc_address, NULL, &engine->context)) &&
         must(orris_renderer_create(engine->context, &request, &engine->renderer)) &&
         must(orris_renderer_set_draw_callback(engine->renderer, ORRIS_KIND_BIT(ORRIS_KIND_ENTITY), draw_pig,
                                               engine));
}

static int draw(Engine* engine, int number, int time) {
  OrrisFrame frame;
  if (!follow_pack(engine) || !submit_chunks(engine)) return 0;
  if (!must(orris_renderer_frame_init(engine->renderer, &frame, sizeof(frame)))) return 0;
  frame.camera.mode = ORRIS_CAMERA_DIRECTION;
  frame.camera.position[0] = 26;
  frame.camera.position[1] = 30;
  frame.camera.position[2] = 78;
  frame.camera.direction[0] = 0.25f;
  frame.camera.direction[1] = -0.22f;
  frame.camera.direction[2] = -1;
  frame.camera.fov = 70;
  frame.time = time;
  engine->pig_at[0] = 28 + 0.02 * number; /* walks */
  engine->pig_at[1] = ground_at(28, 70) + 1.5;
  engine->pig_at[2] = 70.5;
  return must(orris_renderer_draw_frame(engine->renderer, &frame)) &&
         must(orris_renderer_output(engine->renderer, engine->window, 0, 0, WIDTH, HEIGHT_PIXELS));
}

static int save(const char* path) {
  static unsigned char pixels[HEIGHT_PIXELS][WIDTH][3];
  FILE* file = fopen(path, "wb");
  int y;
  if (file == NULL) return 0;
  gl.ReadPixels(0, 0, WIDTH, HEIGHT_PIXELS, GL_RGB, GL_UNSIGNED_BYTE, pixels);
  fprintf(file, "P6 %d %d 255\n", (int)WIDTH, (int)HEIGHT_PIXELS);
  for (y = HEIGHT_PIXELS - 1; y >= 0; --y) fwrite(pixels[y], 1, sizeof(pixels[y]), file);
  return fclose(file) == 0;
}

int main(int argc, char** argv) {
  static Engine engine;
  const int frames = argc > 3 ? atoi(argv[3]) : 1, time = argc > 4 ? atoi(argv[4]) : 3000;
  int i, done;
  if (argc < 3) {
    fprintf(stderr, "usage: voxels PACK OUT.ppm [FRAMES [TIME]]\n");
    return 2;
  }
  if (!open_window()) {
    fprintf(stderr, "voxels: OSMesa gives no context\n");
    return 77;
  }
  done = start(&engine, argv[1]);
  for (i = 0; done && i < frames; ++i) done = draw(&engine, i, time);
  done = done && save(argv[2]) && gl.GetError() == GL_NO_ERROR;
  printf("%d batches, pig drawn %d times from the camera and %d from the light\n", engine.batches,
         engine.camera_calls, engine.shadow_calls);
  if (engine.renderer != NULL) done = must(orris_renderer_destroy(engine.renderer)) && done;
  if (engine.context != NULL) done = must(orris_context_destroy(engine.context)) && done;
  return done ? 0 : 1;
}
