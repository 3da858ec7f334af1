// Where a piece of assembled source came from: the author's file, line and column, and the chain of
// #includes that led there.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// One inclusion of one file. Site 0 is the entry file (parent -1).
struct IncludeSite {
  std::string file;
  int parent = -1;     ///< index of the including site
  int parentLine = 0;  ///< line of the #include in the parent's file
};

/// Line and column (1-based) in the file of a site. site -1: made by the host.
struct Origin {
  int site = -1;
  int line = 0;
  int column = 0;
};

/// One line of the flattened source, as the author wrote it (options already applied).
struct FlatLine {
  std::string_view text;  ///< of the file's lines, or of FlatSource::owned
  int site = 0;
  int line = 0;
};

/// A file with its includes expanded in place (no preprocessing done). A file that is included a
/// thousand times is not copied: the files' lines must outlive it.
struct FlatSource {
  std::vector<IncludeSite> sites;
  std::vector<FlatLine> lines;
  std::shared_ptr<std::deque<std::string>> owned;  ///< texts that no file holds; shared by copies

  /// Adds a line that no file holds.
  void own(std::string text, int site, int line) {
    if (!owned) owned = std::make_shared<std::deque<std::string>>();
    lines.push_back({owned->emplace_back(std::move(text)), site, line});
  }
};

/// Output text with the origin of every token: `lines[i]` holds, sorted by output column, the
/// segments of output line i+1. Columns are 1-based.
struct MappedText {
  struct Segment {
    int column = 1;  ///< column in the output line where this segment starts
    Origin origin;
    int macro = -1;  ///< index into macroNames of the outermost macro it was expanded from, or -1
    Origin written;  ///< of a token from a macro's body: its place in the definition; site -1: none
  };
  /// A function that nothing calls: `text` has blanks in its place, but for its line breaks.
  struct Unused {
    std::size_t offset = 0;  ///< in `text`
    std::string source;      ///< what would stand there
  };
  std::string text;
  std::vector<std::vector<Segment>> lines;
  std::vector<Unused> unused;  ///< in the order of the text
  std::vector<IncludeSite> sites;
  std::vector<std::string> macroNames;
  std::vector<Origin> macroOrigins;  ///< where each was defined; site -1: by the host

  /// Author's place of an output position; column 0 asks for the line's first segment. A place
  /// inside a token the author wrote as one keeps the token's column.
  SourceLocation locate(int line, int column) const;
  std::vector<SourceLocation> includedFrom(int line, int column) const;
  /// Name of the macro whose expansion covers the position, or "".
  std::string_view macroAt(int line, int column) const;
  int macroIndexAt(int line, int column) const;  ///< index into macroNames, or -1
  /// Where the definition of a macro holds the token at the position; file "" when it is the author's
  /// own text that stands there, or a macro of the host.
  SourceLocation locateInMacro(int line, int column) const;
};

SourceLocation locate(const std::vector<IncludeSite>& sites, const Origin& origin);
std::vector<SourceLocation> includedFrom(const std::vector<IncludeSite>& sites, int site);

}  // namespace orris
