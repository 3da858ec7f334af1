// What the three context sources share; used inside gl/ only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orris/gl/context.h>

namespace orris::gl {

/// Versions asked for, best first: a driver may refuse one it does not have exactly.
struct GlVersion {
  int major, minor;
};
inline constexpr GlVersion kVersions[] = {{4, 5}, {4, 4}, {4, 3}};

std::vector<ContextProfile> profilesToTry(ContextProfile asked);  ///< best first
/// "core context of OpenGL 4.3 or newer", for messages.
std::string describeWanted(ContextProfile asked);

/// LIBGL_ALWAYS_SOFTWARE=1: Mesa's software rasteriser in place of a GPU.
bool softwareIsAsked();

std::unique_ptr<Context> createOsmesaContext(const ContextRequest&, Diagnostics&);
std::unique_ptr<Context> createEglContext(const ContextRequest&, Diagnostics&);
std::unique_ptr<Context> createGlfwContext(const ContextRequest&, Diagnostics&);

/// Handle of the first library of `names` that loads, else nullptr. It is never unloaded: a driver
/// may leave threads and exit handlers behind that still need its code.
void* loadLibrary(const std::vector<std::string>& names);
void* findSymbol(void* library, const char* name);

}  // namespace orris::gl
