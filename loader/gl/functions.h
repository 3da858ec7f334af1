// GL entry points, resolved through the context's getProcAddress. One list, functions.inc.
#pragma once

#include <functional>
#include <string>
#include <vector>

#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>

namespace orris::gl {

#define ORRIS_GL(name) extern decltype(&::gl##name) name;
#include <orris/gl/functions.inc>
#undef ORRIS_GL

/// Has the context that the functions are of a core profile? It knows none of the old fixed functions.
bool isCoreProfile();

/// Resolves the whole list, replacing what an earlier context resolved; returns the names (with the
/// gl prefix) that the driver does not know.
std::vector<std::string> loadFunctions(const std::function<void*(const char*)>& getProcAddress);

}  // namespace orris::gl
