#include <orris/pack/programs/live_check.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include <orris/pack/options/live_options.h>
#include <orris/pack/options/option_line.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {
namespace {

/// Functions some of whose arguments must be constants.
constexpr std::array<std::string_view, 5> kConstantArguments = {"textureOffset", "texelFetchOffset",
                                                                "textureLodOffset", "textureGather",
                                                                "textureProjOffset"};

/// Functions that a compiler folds with other digits than the program computes: a picture with the value
/// compiled in would be another.
constexpr std::array<std::string_view, 20> kFoldedOtherwise = {
    "pow",  "exp",  "exp2", "log",  "log2",  "sin",   "cos",   "tan",         "asin",      "acos",
    "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "inversesqrt", "normalize", "length"};

bool startsWithAny(std::string_view name, std::span<const std::string_view> starts) {
  return std::ranges::any_of(starts, [&](std::string_view start) { return name.starts_with(start); });
}

/// Walks the tokens of one file and notes what each live name cannot stand in.
class UseScan {
 public:
  UseScan(const std::set<std::string>& candidates, std::map<std::string, std::string>& reasons)
      : candidates_(candidates), reasons_(reasons) {}

  void run(const TokenStream& stream) {
    for (const Token& token : stream.tokens) {
      if (token.kind == TokenKind::Comment) continue;
      if (token.kind == TokenKind::Identifier) {
        take(token, stream);
      } else if (token.kind == TokenKind::Punctuator) {
        follow(token.text);
      }
      before_ = token.kind == TokenKind::Identifier ? token.text : "";
    }
  }

 private:
  struct Open {
    char bracket;
    std::string name;  ///< that stands before it
  };

  void take(const Token& token, const TokenStream& stream) {
    if (token.text == "const" && open("(").empty()) inConst_ = true;
    if (token.text == "case") inCase_ = true;
    if (token.text.find(kLivePrefix) == std::string::npos) return;
    const std::string option = token.text.substr(std::min(token.text.size(), kLivePrefix.size()));
    const std::string place = fmt::format(" ({}:{})", fileOf(token, stream), token.origin.line);
    if (token.text.starts_with(kLivePrefix) && candidates_.contains(option)) {
      if (const std::string reason = reasonHere(); !reason.empty()) note(option, reason + place);
      return;
    }
    for (const std::string& candidate : candidates_)
      if (token.text.find(std::string(kLivePrefix) + candidate) != std::string::npos)
        note(candidate, "it is a part of another name" + place);
  }

  static std::string fileOf(const Token& token, const TokenStream& stream) {
    const auto site = std::size_t(token.origin.site);
    return token.origin.site >= 0 && site < stream.sites.size() ? stream.sites[site].file : "";
  }

  void note(const std::string& option, const std::string& reason) {
    reasons_.emplace(option, reason);
  }

  /// The names before the open brackets of a kind.
  std::vector<std::string_view> open(std::string_view kind) const {
    std::vector<std::string_view> names;
    for (const Open& one : open_)
      if (one.bracket == kind.front()) names.push_back(one.name);
    return names;
  }

  std::string reasonHere() const {
    if (inConst_) return "a constant is made of it";
    if (inCase_) return "it is the label of a case";
    if (open("{").empty()) return "it stands outside of functions";
    if (!open("[").empty()) return "it is a size or an index";
    for (const std::string_view name : open("(")) {
      if (name == "layout") return "it stands in a layout";
      if (startsWithAny(name, kConstantArguments)) return fmt::format("{}() asks for constants", name);
      if (std::ranges::find(kFoldedOtherwise, name) != kFoldedOtherwise.end())
        return fmt::format("{}() of a constant has other digits", name);
    }
    return "";
  }

  void follow(std::string_view text) {
    if (text == "(" || text == "[" || text == "{") open_.push_back({text.front(), before_});
    if ((text == ")" || text == "]" || text == "}") && !open_.empty()) open_.pop_back();
    if (text == ";") inConst_ = false;
    if (text == ":") inCase_ = false;
  }

  const std::set<std::string>& candidates_;
  std::map<std::string, std::string>& reasons_;
  std::vector<Open> open_;
  std::string before_;
  bool inConst_ = false, inCase_ = false;
};

bool isConst(const PackFiles& files, const Option& option) {
  return std::ranges::any_of(option.at, [&](const SourceLocation& at) {
    const auto file = files.graph.files.find(at.file);
    const auto index = std::size_t(at.line) - 1;
    if (file == files.graph.files.end() || index >= file->second.size()) return false;
    const auto line = parseOptionLine(file->second[index]);
    return line && line->isConst;
  });
}

/// What is known without reading code again; "" where the code decides.
std::string reasonBefore(const ShaderPack& pack, const Option& option) {
  const FolderBuild& build = *pack.builds.front();
  if (!liveType(option)) return "its values are not numbers of one kind";
  if (isConst(build.files(), option)) return "it is a const";
  if (std::ranges::binary_search(build.properties().options, option.name))
    return "a properties file asks for it";
  bool used = false;
  for (const ProgramSource& program : pack.programs) {
    if (std::ranges::binary_search(program.conditionOptions, option.name))
      return fmt::format("#if asks for it in {}", program.name);
    used |= std::ranges::binary_search(program.options, option.name);
  }
  return used ? "" : "no program reads it";
}

}  // namespace

std::map<std::string, std::string> liveOptions(const ShaderPack& pack) {
  std::map<std::string, std::string> reasons;
  std::set<std::string> candidates;
  for (const auto& [name, option] : pack.options.all()) {
    std::string reason = reasonBefore(pack, option);
    if (reason.empty()) {
      candidates.insert(name);
    } else {
      reasons[name] = std::move(reason);
    }
  }
  const FolderBuild& host = *pack.builds.front();
  const FolderBuild live(host.sharedFiles(), host.folder(), host.values(), {}, false, &host, candidates);
  const std::vector<std::string> names(candidates.begin(), candidates.end());
  for (const ProgramEntry& entry : live.programs()) {
    const ProgramSource* program = pack.find(entry.name.program);
    if (program == nullptr || !haveCommonName(names, program->options)) continue;
    for (std::size_t i = 0; i < partCount(entry); ++i)
      UseScan(candidates, reasons).run(live.buildPart(entry, i).stream);
  }
  for (const std::string& name : names) reasons.emplace(name, "");
  return reasons;
}

}  // namespace orris
