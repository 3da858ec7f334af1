// Finding names in the final text of a program, and pointing at the author's place of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/shader_pack.h>

namespace orris {

/// One occurrence of a word in a stage.
struct WordPlace {
  const StageText* stage = nullptr;
  size_t offset = 0;  ///< of the word's first character in the stage's text
};

/// Every occurrence of `word` in the stages (or in the computes) of `program`, in text order.
std::vector<WordPlace> findWord(const ProgramSource& program, bool computes, std::string_view word);
std::vector<WordPlace> findWord(const StageText& stage, std::string_view word);

/// Is the word the declared name of a uniform (or of a parameter list after it)?
bool isDeclaration(const WordPlace& place);

/// The occurrences outside of declarations, in those stages (or computes) whose main reaches the
/// uniform `name`.
std::vector<WordPlace> findUses(const ProgramSource& program, bool computes, std::string_view name);

/// The author's place of it.
SourceLocation locationOf(const WordPlace& place);

/// The arguments of the call whose name ends at `nameEnd`, as texts; empty when no call follows.
struct Call {
  std::vector<std::string_view> arguments;
  size_t end = 0;  ///< offset after the closing parenthesis
};
std::optional<Call> callAt(std::string_view text, size_t nameEnd);

/// What a program does with an image.
struct ImageAccess {
  bool loads = false, stores = false;
};
/// From the calls that name the image; one handed to another function may do both.
ImageAccess imageAccess(const ProgramSource& program, bool computes, std::string_view image);

/// A diagnostic at the author's place of `place`, with includes and source line.
Diagnostic diagnosticAt(const ShaderPack& pack, Severity severity, std::string id,
                        const WordPlace& place, std::string message, std::string hint);
/// The same at a place that is known.
Diagnostic diagnosticAt(const ShaderPack& pack, Severity severity, std::string id,
                        const SourceLocation& at, std::string message, std::string hint);

}  // namespace orris
