/* Loads and unloads Orris again and again in one context of an engine: cycles PACK COUNT [LIMIT]
 * Fails when its peak in the second half is more than LIMIT KiB above that in the first. */
#include <orris/orris.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "mesh.h"
#include "window.h"

static long resident_kib(void) {
  long pages = 0, resident = 0;
  FILE* file = fopen("/proc/self/statm", "r");
  if (file == NULL) return 0;
  if (fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
  fclose(file);
  return resident * 4;
}

static int must(OrrisStatus status) {
  if (status != ORRIS_OK) fprintf(stderr, "cycles: %s: %s\n", orris_status_name(status), orris_last_error());
  return status == ORRIS_OK;
}

static int submit(OrrisRenderer* renderer, unsigned buffer) {
  OrrisBatch batch;
  orris_batch_init(&batch, sizeof(batch));
  batch.vertex_buffer = buffer;
  batch.count = 24;
  return must(orris_renderer_submit(renderer, &batch));
}

static int cycle(const char* pack, const OrrisVertex* cube) {
  OrrisContext* context = NULL;
  OrrisRenderer* renderer = NULL;
  OrrisRendererRequest request;
  uint32_t buffer = 0;
  int done;
  orris_renderer_request_init(&request, sizeof(request));
  request.width = request.height = 64;
  request.pack = pack;
  done = must(orris_context_adopt(engine_proc_address, NULL, &context)) &&
         must(orris_renderer_create(context, &request, &renderer)) &&
         must(orris_buffer_create(context, cube, 24 * sizeof(*cube), &buffer)) &&
         submit(renderer, buffer) && must(orris_renderer_draw_frame(renderer, NULL)) &&
         must(orris_renderer_resize(renderer, 96, 32)) && must(orris_renderer_reload(renderer)) &&
         must(orris_renderer_draw_frame(renderer, NULL));
  if (buffer != 0) done = must(orris_buffer_destroy(context, buffer)) && done;
  if (renderer != NULL) done = must(orris_renderer_destroy(renderer)) && done;
  if (context != NULL) done = must(orris_context_destroy(context)) && done;
  return done;
}

int main(int argc, char** argv) {
  const int count = argc > 2 ? atoi(argv[2]) : 0, limit = argc > 3 ? atoi(argv[3]) : 0;
  static const unsigned char white[3] = {255, 255, 255};
  OrrisVertex cube[24];
  long early = 0, late = 0, now;
  int i;
  if (count < 10) return 2;
  if (!open_window()) return 77;
  fill_cube(cube, white);
  for (i = 0; i < count; ++i) {
    if (!cycle(argv[1], cube)) return 1;
    /* The driver keeps and gives back megabytes from cycle to cycle: peaks compare, single values do not. */
    now = resident_kib();
    if (i < count / 2 && now > early) early = now;
    if (i >= count / 2 && now > late) late = now;
  }
  printf("%d cycles: at most %ld KiB in the first half, %ld KiB in the second\n", count, early, late);
  if (limit > 0 && late - early > limit) {
    fprintf(stderr, "cycles: grown by %ld KiB, more than %d\n", late - early, limit);
    return 1;
  }
  return 0;
}
