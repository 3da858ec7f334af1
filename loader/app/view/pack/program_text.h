// The final text of a stage of a program, as the driver gets it, with the author's place of every line.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>

namespace orris {

struct ProgramLine {
  std::string text;
  SourceLocation author;  ///< file "" for a line that the host made
};

struct ProgramText {
  std::string name;  ///< "composite.fsh", of a compute shader "composite_a.csh"
  std::vector<ProgramLine> lines;
  std::vector<AppliedRule> rules;     ///< of the whole program
  std::vector<std::string> options;   ///< with their values, "TINT=1": those that the program depends on
  std::vector<std::string> includes;  ///< files of the pack that are read for it, the first first

  /// Final lines, from 1, with something of the author's line.
  std::vector<int> linesFrom(const std::string& file, int line) const;
  /// The next final line after `from` with these words in its text or in the author's place; 0: none.
  int find(const std::string& words, int from) const;
};

/// Names of all texts of a pack, in frame order.
std::vector<std::string> programTextNames(const ShaderPack& pack);
/// nullopt where the pack has no such text.
std::optional<ProgramText> programText(const ShaderPack& pack, const std::string& name);

/// The author's place as people write it: "/lib/tint.glsl:5"; "(host)" for a line of the host.
std::string authorText(const ProgramLine& line);

}  // namespace orris
