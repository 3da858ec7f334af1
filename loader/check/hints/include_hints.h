// Compiler errors of a stage that an #include would mend: the name is defined in a file of the pack that
// the stage does not read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/check/hints/definition_index.h>
#include <orris/check/hints/missing_include.h>

namespace orris {

class IncludeHints {
 public:
  /// All must outlive this; errors of `found` get hints.
  IncludeHints(DefinitionIndex& index, const StageText& stage, Diagnostics& found);

  /// The files that the stage reads, its own first.
  const std::vector<std::string>& files() const { return files_; }
  /// Is the problem one of this stage?
  bool covers(const Diagnostic& diagnostic) const;
  /// Of error `index`, which does not know `name`. false: no other file defines it.
  bool explainName(std::size_t index, const std::string& name);
  void explainSyntax(std::size_t index);
  void explainEntry(std::size_t index);  ///< of a stage without main()
  /// Adds where #include lines seem to be missing that would make known what was explained.
  void locate(const IncludeTrial& trial);

 private:
  /// Is the name defined, and only in other files than these?
  std::optional<SourceLocation> definedElsewhere(const std::string& name,
                                                 const std::vector<std::string>& files);
  bool isShared(const std::string& file);
  bool isInShared(const std::string& name);
  /// Is the file for several programs, or has it the name of the stage's program, but for its number?
  bool isOfProgram(const std::string& target);
  void addMissing(const MissingInclude& missing);
  std::string_view textBefore(std::size_t line) const;

  DefinitionIndex& index_;
  const StageText& stage_;
  Diagnostics& found_;
  std::vector<std::string> files_;
  std::vector<UnknownName> unknown_;
  std::size_t firstUse_ = 0;  ///< the line of the text that uses the first of these, 0: not known
};

/// The author's line at a place; "" where there is none.
std::string sourceLineOf(DefinitionIndex& index, const SourceLocation& at);

/// Adds a problem unless one of the same id is at its place.
void addNewPlace(Diagnostic diagnostic, Diagnostics& found);

}  // namespace orris
