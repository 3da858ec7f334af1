// Comments by which an author silences diagnostics, in the pack's own files:
//   // orris: ignore(uniform-unknown) set by a mod      on the line itself, or alone above it
//   # orris: ignore(option-unused, screen-option)       in .properties and .lang files, alone above
//   // orris: ignore-file(texture-missing)              anywhere in the file
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/core/files/file_source.h>

namespace orris {

/// One id of one comment, and the lines it is about.
struct IgnoreMark {
  std::string id;
  SourceLocation at;  ///< of the comment
  std::string sourceLine;
  int first = 0, last = 0;  ///< lines; 0 to INT_MAX for a whole file
  bool used = false;
};

/// The marks of one file, in its order.
std::vector<IgnoreMark> readIgnoreMarks(const std::string& file, std::string_view text);

/// The ignore comments of a pack.
class IgnoreComments {
 public:
  explicit IgnoreComments(const FileSource& files);

  /// Whether a comment silences `diagnostic`; the comment then counts as used.
  bool silences(const Diagnostic& diagnostic);
  /// A note (ignore-unused) for each mark that silenced nothing until now, a warning
  /// (ignore-unknown) for each that names no rule.
  Diagnostics problems() const;

 private:
  std::map<std::string, std::vector<IgnoreMark>> marks_;
};

}  // namespace orris
