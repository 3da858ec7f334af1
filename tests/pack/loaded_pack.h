// Packs in memory, loaded.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "pack/shader_pack.h"

namespace orris {

using Files = std::map<std::string, std::string>;  ///< by path in the pack

constexpr const char* kVertex =
    "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";
constexpr const char* kFragment = "#version 330 compatibility\nvoid main() {}\n";

struct Loaded {
  std::optional<ShaderPack> pack;
  Diagnostics diagnostics;
  std::string first() const { return diagnostics.empty() ? "" : formatDiagnostic(diagnostics[0]); }
};

/// With the macros of the host.
inline Loaded loadFiles(Files files, LoadRequest request = {}) {
  Loaded loaded;
  request.environment = standardMacros({});
  loaded.pack = loadShaderPack(memorySource(std::move(files)), request, loaded.diagnostics);
  return loaded;
}

}  // namespace orris
