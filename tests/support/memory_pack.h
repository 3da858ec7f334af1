// Packs in memory, loaded.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <orris/core/files/file_source.h>
#include <orris/pack/shader_pack.h>

namespace orris {

using Files = std::map<std::string, std::string>;  ///< by path in the pack

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

/// A pack that is loaded without a word: a diagnostic fails the test.
inline ShaderPack loadClean(Files files, LoadRequest request = {}) {
  Loaded loaded = loadFiles(std::move(files), std::move(request));
  for (const Diagnostic& d : loaded.diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return std::move(loaded.pack).value();
}

}  // namespace orris
