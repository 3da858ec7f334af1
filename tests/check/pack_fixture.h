// Whole-pack checks on packs in memory.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "support/memory_pack.h"

namespace orris {

using PackCheck = void (*)(std::span<const ShaderPack>, Diagnostics&);

/// A pack of one program, with what `files` adds or replaces.
inline ShaderPack loadPackWith(Files files) {
  files.try_emplace("/final.fsh", "#version 120\n#include \"/settings.glsl\"\nvoid main() {}\n");
  files.try_emplace("/final.vsh", "#version 120\nvoid main() {}\n");
  files.try_emplace("/settings.glsl", "");
  Loaded loaded = loadFiles(std::move(files), {.buildSources = false});
  if (loaded.pack) return std::move(*loaded.pack);
  ADD_FAILURE() << "not loaded: " << loaded.first();
  return {};
}

/// "id /file:line:column: severity: message | hint", in the order of the check.
inline std::vector<std::string> found(PackCheck check, const Files& files) {
  const ShaderPack pack = loadPackWith(files);
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
