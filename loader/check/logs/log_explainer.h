// Compiler messages of a game log, put at the pack's own lines.
//
// The line numbers of such a message count in the text that Iris made, which is not ours: Iris parses
// a shader and prints it anew. Where Iris wrote its texts (debug mode, folder patched_shaders), their
// tokens are aligned with ours; else the place is where this host finds the same mistake, or where
// the names stand that the message quotes. Each diagnostic says which.
#pragma once

#include <string>
#include <vector>

#include <orris/check/logs/game_log.h>
#include <orris/check/logs/log_place.h>
#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

struct ExplainInput {
  const ShaderPack& pack;
  std::string logName;  ///< for messages
  std::vector<LogSection> sections;
  std::vector<PatchedShader> patched;
  std::string stage;  ///< what a section without a name is about: "composite.fsh"; may be ""
};

/// One diagnostic (log-message) for each message, log-program for a shader that the pack lacks,
/// log-empty when the log holds no compiler message.
Diagnostics explainLog(const ExplainInput& input);

}  // namespace orris
