// Options found on the #define and const lines of a pack, and how a value edits its line.
// Contract: options.csv.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// One option. Boolean options have values {"true","false"}.
struct Option {
  std::string name;
  bool isBoolean = false;
  std::string defaultValue;
  std::vector<std::string> values;  ///< allowed, in the author's order
  std::string comment;              ///< tooltip text around the value list
  std::vector<SourceLocation> at;   ///< every line that defines it
};

/// A #define that looks like an option and is none.
struct RejectedOption {
  SourceLocation at;   ///< its first line
  std::string reason;  ///< "no line is #ifdef SSAO or #ifndef SSAO"
};

/// Chosen values by option name; what is absent keeps its default.
using OptionValues = std::map<std::string, std::string>;

/// The options of a pack by name.
class OptionSet {
 public:
  const Option* find(std::string_view name) const;
  const std::map<std::string, Option, std::less<>>& all() const { return options_; }
  std::map<std::string, Option, std::less<>>& all() { return options_; }
  /// Why `name`, which some #define has, is no option; nullptr when none has it.
  const RejectedOption* rejected(std::string_view name) const;
  std::map<std::string, RejectedOption, std::less<>>& rejected() { return rejected_; }
  /// The value in force: chosen, else default.
  std::string value(const OptionValues& values, std::string_view name) const;

 private:
  std::map<std::string, Option, std::less<>> options_;
  std::map<std::string, RejectedOption, std::less<>> rejected_;
};

/// What to say about a name that is no option of the pack: where and why its #define is none, or the
/// nearest name; may be empty.
std::string missingOptionHint(const OptionSet& options, std::string_view name);

/// Text of one file, split into lines (no line ends; a NUL byte is dropped).
using FileLines = std::vector<std::string>;

/// Scans all files (path -> lines) for options; ambiguous ones are dropped with a note, or kept with
/// a warning where Iris keeps them.
OptionSet discoverOptions(const std::map<std::string, FileLines>& files, Diagnostics& diagnostics);

/// Files that only programs of other mods read make no options; those that there are stand on their
/// lines, too.
void addModFiles(const std::map<std::string, FileLines>& files, OptionSet& options);

/// The files with the lines of changed options edited.
std::map<std::string, FileLines> applyOptions(const std::map<std::string, FileLines>& files,
                                              const OptionSet& options, const OptionValues& values);
/// Only those files in which a line changes.
std::map<std::string, FileLines> editedFiles(const std::map<std::string, FileLines>& files,
                                             const OptionSet& options, const OptionValues& values);

/// Reads an option file ("NAME=value" lines, Java properties). Unknown names are warned about.
OptionValues parseOptionFile(const std::string& file, const std::string& text,
                             const OptionSet& options, Diagnostics& diagnostics);
/// Only values that differ from the default, sorted.
std::string writeOptionFile(const OptionSet& options, const OptionValues& values);

}  // namespace orris
