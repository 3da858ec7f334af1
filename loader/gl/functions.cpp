#include "gl/functions.h"

namespace orris::gl {

#define ORRIS_GL(name) decltype(&::gl##name) name = nullptr;
#include "gl/functions.inc"
#undef ORRIS_GL

std::vector<std::string> loadFunctions(const std::function<void*(const char*)>& getProcAddress) {
  std::vector<std::string> missing;
#define ORRIS_GL(name)                                                 \
  name = reinterpret_cast<decltype(name)>(getProcAddress("gl" #name)); \
  if (name == nullptr) missing.emplace_back("gl" #name);
#include "gl/functions.inc"
#undef ORRIS_GL
  return missing;
}

}  // namespace orris::gl
