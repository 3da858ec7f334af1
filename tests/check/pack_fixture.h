// Whole-pack checks on packs in memory.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/file_source.h"
#include "pack/shader_pack.h"

namespace orris {

using PackFilesByPath = std::map<std::string, std::string>;
using PackCheck = void (*)(std::span<const ShaderPack>, Diagnostics&);

/// A pack of one program, with what `files` adds or replaces.
inline ShaderPack loadFiles(PackFilesByPath files) {
  files.try_emplace("/final.fsh", "#version 120\n#include \"/settings.glsl\"\nvoid main() {}\n");
  files.try_emplace("/final.vsh", "#version 120\nvoid main() {}\n");
  files.try_emplace("/settings.glsl", "");
  Diagnostics diagnostics;
  LoadRequest request{.environment = standardMacros({}), .buildSources = false};
  auto pack = loadShaderPack(std::shared_ptr<const FileSource>(memorySource(std::move(files))),
                             request, diagnostics);
  if (pack) return std::move(*pack);
  ADD_FAILURE() << (diagnostics.empty() ? "not loaded" : formatDiagnostic(diagnostics.front()));
  return {};
}

/// "id /file:line:column: severity: message | hint", in the order of the check.
inline std::vector<std::string> found(PackCheck check, const PackFilesByPath& files) {
  const ShaderPack pack = loadFiles(files);
  Diagnostics diagnostics;
  check(std::span(&pack, 1), diagnostics);
  std::vector<std::string> messages;
  for (const Diagnostic& d : diagnostics) {
    std::string message = d.id + " " + d.at.file + ":" + std::to_string(d.at.line) + ":" +
                          std::to_string(d.at.column) + ": " + severityName(d.severity) + ": " +
                          d.message;
    if (!d.hint.empty()) message += " | " + d.hint;
    messages.push_back(std::move(message));
  }
  return messages;
}

}  // namespace orris
