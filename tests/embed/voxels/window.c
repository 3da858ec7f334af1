#include "window.h"

#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

typedef void* (*CreateContext)(const int*, void*);
typedef unsigned char (*MakeCurrent)(void*, void*, unsigned, int, int);
typedef void (*(*GetProcAddress)(const char*))(void);

EngineGl gl;
static void* library;
static unsigned char pixels[4 * 4 * 4];

/* ISO C knows no cast from an object pointer to a function pointer. */
static void find(const char* name, void* pointer) {
  void* address = dlsym(library, name);
  memcpy(pointer, &address, sizeof(address));
}

void* engine_proc_address(const char* name, void* user) {
  GetProcAddress get = NULL;
  void (*function)(void);
  void* address = NULL;
  (void)user;
  find("OSMesaGetProcAddress", &get);
  function = get(name);
  memcpy(&address, &function, sizeof(address));
  return address;
}

int open_window(void) {
  /* Format RGBA, depth 24, core profile, version 4.5 */
  static const int attributes[] = {0x22, GL_RGBA, 0x30, 24, 0x33, 0x34, 0x36, 4, 0x37, 5, 0};
  CreateContext create = NULL;
  MakeCurrent make_current = NULL;
  void *context, *address;
  library = dlopen("libOSMesa.so.8", RTLD_NOW);
  if (library == NULL) return 0;
  find("OSMesaCreateContextAttribs", &create);
  find("OSMesaMakeCurrent", &make_current);
  if (create == NULL || make_current == NULL) return 0;
  context = create(attributes, NULL);
  if (context == NULL || !make_current(context, pixels, GL_UNSIGNED_BYTE, 4, 4)) return 0;
#define X(name, type)                               \
  address = engine_proc_address("gl" #name, NULL);  \
  memcpy(&gl.name, &address, sizeof(address));
  ENGINE_GL(X)
#undef X
  return 1;
}
