// The texts of a pack as checks read them again: located entries, and words.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/files/properties_text.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// shaders.properties without preprocessing, as screens, profiles and sliders are read: of each key
/// the last value. Empty without the file.
std::vector<PropertyEntry> originalProperties(const ShaderPack& pack);

/// Lines as the author wrote them: those in ShaderPack::files have option values in place.
class AuthorLines {
 public:
  explicit AuthorLines(const ShaderPack& pack) : pack_(pack) {}
  /// "" when there is no such line.
  const std::string& at(const SourceLocation& place);
  const FileLines& file(const std::string& path);

 private:
  const ShaderPack& pack_;
  std::map<std::string, FileLines> files_;
};

/// The #if branches of a text, by line from 1, whatever they test.
class Branches {
 public:
  explicit Branches(std::string_view text);
  /// Is line `a` in the text whenever line `b` is? False also where that is unknown.
  bool implies(int b, int a) const;

 private:
  int at(int line) const;
  std::vector<int> branches_;  ///< of each line; 0 is the text outside all #if
  std::vector<int> parents_;
};

/// Is it "screen" or "screen.SUB", and not a number of columns?
bool isScreenKey(std::string_view key);

/// Calls `visit` for each run of letters, digits and '_'.
void forEachWord(std::string_view text, const std::function<void(std::string_view)>& visit);

/// The name of `names` that `name` was most likely meant to be: at most two slips away, and one in
/// short names; "" when there is none. Stricter than suggest(), for names that may well be right.
std::string likelyMeant(std::string_view name, const std::vector<std::string>& names);

/// Does `word` stand in the text, not as a part of another?
bool occursAsWord(std::string_view text, std::string_view word);
/// Does the line write to `name`: "name =", "name.xyz *=", "name[0] =", not "=="?
bool assigns(std::string_view line, std::string_view name);
/// Does `name` stand alone between the commas and parentheses of a list?
bool isArgument(std::string_view line, std::string_view name);

}  // namespace orris
