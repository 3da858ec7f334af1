// GL entry points, resolved through the context's getProcAddress. One list, functions.inc.
#pragma once

#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>

namespace orris::gl {

#define ORRIS_GL(name) extern decltype(&::gl##name) name;
#include "gl/functions.inc"
#undef ORRIS_GL

}  // namespace orris::gl
