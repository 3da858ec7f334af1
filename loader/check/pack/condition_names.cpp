#include <orris/check/pack/condition_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <orris/check/pack/pack_texts.h>
#include <orris/core/characters.h>
#include <orris/glsl/preprocess/line_code.h>
#include <orris/pack/programs/folder_build.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

// A slip stands once, or in an #if and its #elif; what is asked more often was defined elsewhere once.
constexpr int kMostOfSlip = 2;

// Families whose members depend on the driver, the game's version or the mods that are there.
constexpr std::array<std::string_view, 5> kForeign = {"GL_", "MC_GL_", "BIOME_", "CAT_", "__"};

struct Asked {
  SourceLocation at;
  std::string sourceLine;
  int times = 0;
  bool ofIf = false;  ///< by #if or #elif, not only by #ifdef
};

class NameReader {
 public:
  void read(const std::string& file, const FileLines& lines) {
    bool inComment = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      at_ = {file, int(i) + 1, 0};
      line_ = &lines[i];
      noteDefinition(lines[i]);
      const std::string code = codeOfLine(lines[i], inComment);
      std::string_view text = trim(code);
      if (!text.starts_with('#')) continue;
      text = trim(text.substr(1));
      const std::string_view directive = leadingWord(text);
      const std::string_view rest = text.substr(directive.size());
      if (directive == "ifdef" || directive == "ifndef") askDefined(leadingWord(trim(rest)));
      if (directive == "if" || directive == "elif") readCondition(rest);
    }
  }

  const std::map<std::string, Asked>& asked() const { return asked_; }
  /// The pack knows that it may be undefined.
  bool isTested(const std::string& name) const { return tested_.contains(name); }
  const std::set<std::string>& defined() const { return defined_; }

 private:
  // Those in comments too: options that are off, and what other branches or hosts define.
  void noteDefinition(std::string_view line) {
    constexpr std::string_view kDefine = "#define";
    for (std::size_t at = line.find(kDefine); at != line.npos; at = line.find(kDefine, at + 1))
      defined_.emplace(leadingWord(trim(line.substr(at + kDefine.size()))));
  }

  void askDefined(std::string_view name) {
    if (name.empty()) return;
    tested_.emplace(name);
    ask(name, false);
  }

  void readCondition(std::string_view text) {
    bool afterDefined = false;
    for (std::size_t i = 0; i < text.size();) {
      const std::string_view word = leadingWord(text.substr(i));
      if (word.empty()) {
        afterDefined = afterDefined && (text[i] == '(' || text[i] == ' ' || text[i] == '\t');
        ++i;
        continue;
      }
      if (word == "defined") {
        afterDefined = true;
      } else if (afterDefined) {
        askDefined(word);
        afterDefined = false;
      } else if (!isDigit(word.front())) {
        ask(word, true);
      }
      i += word.size();
    }
  }

  void ask(std::string_view name, bool ofIf) {
    Asked& asked = asked_[std::string(name)];
    if (asked.times++ == 0 || (ofIf && !asked.ofIf)) {
      asked.at = at_;
      asked.at.column = int(line_->find(name)) + 1;
      asked.sourceLine = *line_;
    }
    asked.ofIf = asked.ofIf || ofIf;
  }

  std::map<std::string, Asked> asked_;
  std::set<std::string> defined_, tested_;
  SourceLocation at_;
  const std::string* line_ = nullptr;
};

bool isForeign(std::string_view name) {
  return std::ranges::any_of(kForeign, [&](auto prefix) { return name.starts_with(prefix); });
}

std::vector<std::string> knownToAll(const ShaderPack& pack, const NameReader& reader) {
  std::vector<std::string> names(reader.defined().begin(), reader.defined().end());
  for (const auto& [name, option] : pack.options.all()) names.push_back(name);
  for (const auto& [name, body] : pack.propertyMacros) names.push_back(name);
  for (const auto& build : pack.builds) {
    for (const auto& [name, body] : build->properties().shaderMacros) names.push_back(name);
  }
  return names;
}

}  // namespace

void checkConditionNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  NameReader reader;
  for (const auto& [file, lines] : pack.files) reader.read(file, lines);
  const std::vector<std::string> names = knownToAll(pack, reader);
  const std::set<std::string> known(names.begin(), names.end());
  for (const auto& [name, asked] : reader.asked()) {
    if (known.contains(name) || isForeign(name)) continue;
    const std::string meant = asked.times <= kMostOfSlip ? likelyMeant(name, names) : "";
    if (meant.empty() && (!asked.ofIf || reader.isTested(name))) continue;
    diagnostics.push_back(
        {.severity = meant.empty() ? Severity::Note : Severity::Warning,
         .id = "condition-undefined",
         .at = asked.at,
         .message = asked.ofIf
                        ? fmt::format("nothing defines {}, so that it counts as 0 here", name)
                        : fmt::format("nothing defines {}, so that it counts as not defined here", name),
         .sourceLine = asked.sourceLine,
         .hint = meant.empty() ? "" : fmt::format("did you mean {}?", meant)});
  }
}

}  // namespace orris
