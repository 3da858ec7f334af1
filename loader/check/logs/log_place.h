// Finding the author's place of one compiler message.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orris/glsl/compile/compiler_log.h>
#include <orris/glsl/compile/validate.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// A file of Iris's folder patched_shaders: "012_composite.fsh".
struct PatchedShader {
  std::string file, text;
};

/// A line and column of a stage's compiled text, and how it was found.
struct LogPlace {
  const StageText* stage = nullptr;
  int line = 0, column = 0;
  std::string how;  ///< "exact: ...", "by name: ...", "a guess: ..."
};

/// The names that a message is about: those in quotes, else what follows its last colon.
std::vector<std::string> namesInMessage(const std::string& message);

/// Places messages, keeping what it works out about a stage: a log can hold thousands.
class LogPlacer {
 public:
  using Stages = std::vector<const StageText*>;

  /// By the text that Iris compiled, its tokens aligned with the stage's. `patched` must outlive.
  std::optional<LogPlace> byPatchedText(const LogEntry& entry, const PatchedShader& patched,
                                        const StageText& stage);
  /// By the stage's own line numbers, if a quoted name stands on that very line.
  std::optional<LogPlace> byOwnText(const LogEntry& entry, const StageText& stage);
  /// By the problems that this host finds in the stages itself, those about the same name.
  std::optional<LogPlace> byOwnProblem(const LogEntry& entry, const Stages& stages);
  /// By where the names of the message stand.
  std::optional<LogPlace> byName(const LogEntry& entry, const Stages& stages);

 private:
  struct Alignment {
    std::vector<Token> theirs;
    std::vector<int> matched;  ///< of each of theirs: the stage's token, or -1
  };
  struct Occurrence {
    const StageText* stage = nullptr;
    const Token* token = nullptr;
    SourceLocation at;
  };

  const std::vector<Token>& tokensOf(const StageText& stage);
  const Alignment& alignmentOf(const PatchedShader& patched, const StageText& stage);
  const Diagnostics& problemsOf(const StageText& stage);
  std::vector<Occurrence> occurrencesOf(const std::string& name, const Stages& stages);
  static std::string listed(const std::vector<Occurrence>& occurrences);

  std::map<const StageText*, std::vector<Token>> tokens_;
  std::map<const StageText*, Diagnostics> problems_;
  std::map<std::pair<const StageText*, const PatchedShader*>, Alignment> alignments_;
};

}  // namespace orris
