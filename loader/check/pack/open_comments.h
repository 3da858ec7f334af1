// Block comments that swallow code: "/*" where "//" was meant, or without its "*/".
#pragma once

#include <span>
#include <string>
#include <vector>

#include <orris/check/compile/program_check.h>
#include <orris/pack/options/options.h>

namespace orris {

/// A block comment with another "/*" in it, as gcc's -Wcomment reports, or without an end in its file.
struct OpenComment {
  int line = 0, column = 0;              ///< of its "/*"
  int nestedLine = 0, nestedColumn = 0;  ///< of the first "/*" in it; the end of the file and 0
  std::vector<int> ends;                 ///< lines before which its "*/" may be missing, rising
  bool ofOption = false;                 ///< behind a #define, whose line it does not end on
  bool likelyLost = false;               ///< the first "/*" in it begins a line, as comments do
};

/// Of the lines of one file.
std::vector<OpenComment> findOpenComments(const FileLines& lines);

/// Does a file that the program reads end within a comment? What that swallows need not be looked for
/// in other files.
bool readsOpenEndedFile(const ShaderPack& folder, const ProgramUnit& unit);

/// Of the comments in files of programs that fail: those without which the programs fail less are
/// reported as errors at their "/*", with the edit that closes them. Runs trials in `jobs` processes.
void reportSwallowedCode(const ShaderPack& folder, const Verdicts& verdicts, int jobs,
                         Diagnostics& diagnostics);

/// All other comments within comments: a note where "/*" stands behind other text, else a warning.
void checkNestedComments(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
