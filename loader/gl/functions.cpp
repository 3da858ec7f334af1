#include <orris/gl/functions.h>

namespace orris::gl {

#define ORRIS_GL(name) decltype(&::gl##name) name = nullptr;
#include <orris/gl/functions.inc>
#undef ORRIS_GL

namespace {
bool coreProfile = false;
}  // namespace

bool isCoreProfile() { return coreProfile; }

std::vector<std::string> loadFunctions(const std::function<void*(const char*)>& getProcAddress) {
  std::vector<std::string> missing;
#define ORRIS_GL(name)                                                 \
  name = reinterpret_cast<decltype(name)>(getProcAddress("gl" #name)); \
  if (name == nullptr) missing.emplace_back("gl" #name);
#include <orris/gl/functions.inc>
#undef ORRIS_GL
  coreProfile = false;
  if (GetIntegerv != nullptr) {
    GLint mask = 0;
    GetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    coreProfile = (mask & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
  }
  return missing;
}

}  // namespace orris::gl
