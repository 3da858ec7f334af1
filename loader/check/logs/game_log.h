// The compiler messages inside a log of the game, or a driver's log by itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// What the log says of one shader.
struct LogSection {
  std::string name;  ///< as the game names it, "terrain_solid.fsh"; "" for a bare driver log
  int line = 0;      ///< of the log, from 1
  std::string text;  ///< the driver's own log
};

/// Finds "Shader compilation log for NAME: ...", "Program link log for NAME: ...", the texts of
/// ShaderCompileException, pasted "NAME: NAME: ..." and bare driver messages; a text that the log
/// repeats (as a warning, then as an exception) comes once. Iris: GlShader, ProgramCreator,
/// ShaderCompileException.
std::vector<LogSection> parseGameLog(std::string_view text);

/// A shader name of a game log, taken apart.
struct LoggedShader {
  std::string program;  ///< of the pack, before fallbacks: "gbuffers_terrain_solid", "composite3"
  std::string stage;    ///< "fsh", or "" when the name does not say
};

/// Iris names geometry shaders after what they draw: "terrain_solid" is gbuffers_terrain_solid,
/// "text_bg" gbuffers_entities_translucent. Iris: ShaderKey, SodiumPrograms.
LoggedShader shaderOfLogName(std::string_view name);

}  // namespace orris
