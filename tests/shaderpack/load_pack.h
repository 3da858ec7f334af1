// Our own pack through the library, as every test of it starts.
#pragma once

#include <gmock/gmock.h>

#include <optional>

#include <orris/core/files/file_source.h>
#include <orris/pack/shader_pack.h>

namespace orris::test {

/// Loads shaderpack/; any diagnostic is a failure.
inline std::optional<ShaderPack> loadReferencePack(LoadRequest request) {
  Diagnostics diagnostics;
  const std::shared_ptr<const FileSource> source =
      openPack(ORRIS_SOURCE_DIR "/shaderpack", diagnostics);
  if (!source) return std::nullopt;
  request.environment = standardMacros({});
  std::optional<ShaderPack> pack = loadShaderPack(source, request, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics) ADD_FAILURE() << formatDiagnostic(diagnostic);
  return pack;
}

}  // namespace orris::test
