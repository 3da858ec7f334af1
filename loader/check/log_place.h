// Finding the author's place of one compiler message.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "glsl/compiler_log.h"
#include "glsl/validate.h"

namespace orris {

/// A line and column of a stage's compiled text, and how it was found.
struct LogPlace {
  const StageText* stage = nullptr;
  int line = 0, column = 0;
  std::string how;  ///< "exact: ...", "by name: ...", "a guess: ..."
};

/// The names that a message is about: those in quotes, else what follows its last colon.
std::vector<std::string> namesInMessage(const std::string& message);

/// By the text that Iris compiled, its tokens aligned with the stage's.
std::optional<LogPlace> placeByPatchedText(const LogEntry& entry, const std::string& patched,
                                           const std::string& file, const StageText& stage);

/// By the stage's own line numbers, if a quoted name stands on that very line.
std::optional<LogPlace> placeByOwnText(const LogEntry& entry, const StageText& stage);

/// By the problems that this host finds in the program itself, those about the same name.
std::optional<LogPlace> placeByOwnProblem(const LogEntry& entry,
                                          const std::vector<const StageText*>& stages);

/// By where the names of the message stand.
std::optional<LogPlace> placeByName(const LogEntry& entry,
                                    const std::vector<const StageText*>& stages);

}  // namespace orris
