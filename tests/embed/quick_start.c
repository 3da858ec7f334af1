/* The least that a program needs to draw a world with a pack: a picture as PPM. C99.
 * cc quick_start.c $(pkg-config --cflags --libs orris) && ./a.out PACK WORLD picture.ppm */
#include <orris/orris.h>
#include <stdio.h>
#include <stdlib.h>

static void print(const OrrisDiagnostic* diagnostic, void* user) {
  (void)user;
  fprintf(stderr, "%s\n", diagnostic->text);
}

static int must(OrrisStatus status) {
  if (status == ORRIS_OK) return 1;
  fprintf(stderr, "%s: %s\n", orris_status_name(status), orris_last_error());
  return 0;
}

static int save(const char* path, const unsigned char* rgba, int width, int height) {
  int i;
  FILE* file = fopen(path, "wb");
  if (file == NULL) return 0;
  fprintf(file, "P6 %d %d 255\n", width, height);
  for (i = 0; i < width * height; ++i) fwrite(rgba + 4 * i, 1, 3, file);
  return fclose(file) == 0;
}

int main(int argc, char** argv) {
  enum { WIDTH = 160, HEIGHT = 90, BYTES = WIDTH * HEIGHT * 4 };
  OrrisContext* context = NULL;
  OrrisRenderer* renderer = NULL;
  OrrisRendererRequest request;
  OrrisFrame frame;
  unsigned char* pixels = malloc(BYTES);
  int done;
  if (argc != 4 || pixels == NULL) return 2;
  orris_renderer_request_init(&request, sizeof(request));
  request.width = WIDTH;
  request.height = HEIGHT;
  request.pack = argv[1];
  request.world = argv[2];
  request.on_diagnostic = print;
  done = must(orris_context_create(NULL, &context)) &&
         must(orris_renderer_create(context, &request, &renderer)) &&
         must(orris_renderer_frame_init(renderer, &frame, sizeof(frame)));
  if (done) frame.time = 3000; /* in the morning */
  done = done && must(orris_renderer_draw_frame(renderer, &frame)) &&
         must(orris_renderer_read(renderer, pixels, BYTES)) && save(argv[3], pixels, WIDTH, HEIGHT);
  if (renderer != NULL) must(orris_renderer_destroy(renderer));
  if (context != NULL) must(orris_context_destroy(context));
  free(pixels);
  return done ? 0 : 1;
}
