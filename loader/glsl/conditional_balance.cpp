#include "glsl/conditional_balance.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "glsl/brace_check.h"
#include "glsl/nesting.h"

namespace orris {
namespace {

using Kind = NestingMark::Kind;
constexpr int kEmptyBranch = 3;

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The name of the directive on a line, "" when it is none.
std::string_view directiveOf(std::string_view line) {
  const auto blanks = [&line] {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  };
  blanks();
  if (!line.starts_with('#')) return "";
  line.remove_prefix(1);
  blanks();
  return line.substr(
      0, static_cast<std::size_t>(std::ranges::find_if_not(line, isWordCharacter) - line.begin()));
}

std::optional<Kind> kindOf(std::string_view directive) {
  if (directive == "if" || directive == "ifdef" || directive == "ifndef") return Kind::Open;
  if (directive == "else" || directive == "elif") return Kind::Middle;
  if (directive == "endif") return Kind::Close;
  return std::nullopt;
}

/// Is `word` one letter short of `whole`?
bool lacksOne(std::string_view word, std::string_view whole) {
  if (word.size() + 1 != whole.size()) return false;
  const auto differs = std::ranges::mismatch(word, whole).in1 - word.begin();
  return word.substr(std::size_t(differs)) == whole.substr(std::size_t(differs) + 1);
}

/// The conditional that `word` is a slip of: letters exchanged, one missing or one too many.
std::string_view conditionalMeant(std::string_view word) {
  if (word == "line") return "";
  for (const std::string_view known : {"endif", "else", "elif", "ifdef", "ifndef"}) {
    const bool same = word.size() == known.size() && std::ranges::is_permutation(word, known);
    if (word != known && (same || lacksOne(word, known) || lacksOne(known, word))) return known;
  }
  return "";
}

/// The text of a line without comments; block comments go on in `inComment`.
std::string codeOf(const std::string& line, bool& inComment) {
  std::string code;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string_view two = std::string_view(line).substr(i, 2);
    if (inComment) {
      if (two == "*/") inComment = false, ++i;
    } else if (two == "/*") {
      inComment = true;
      ++i;
    } else if (two == "//") {
      break;
    } else {
      code += line[i];
    }
  }
  return code;
}

/// The conditionals of one file.
class FileConditionals {
 public:
  void read(const FlatLine& line) {
    const std::string code = codeOf(line.text, inComment_);
    const std::string_view directive = directiveOf(code);
    const Origin at{line.site, line.line, int(code.find('#')) + 1};
    if (!directive.empty() && !kindOf(directive)) codeSince_ = true;
    if (const auto kind = kindOf(directive)) {
      marks_.push_back(
          {.kind = *kind, .indent = indentWidth(code), .depth = depth_, .line = line.line});
      marks_.back().whole = marks_.size() == 1 && !sawCode_ && *kind == Kind::Open &&
                            (directive == "ifndef" || code.find("!defined") != std::string::npos ||
                             code.find("! defined") != std::string::npos);
      codeBefore_.push_back(codeSince_);
      codeSince_ = false;
      origins_.push_back(at);
      names_.emplace_back(directive);
    } else if (directive.empty()) {
      for (const char c : code) depth_ += c == '{' ? 1 : c == '}' ? -1 : 0;
      codeSince_ = codeSince_ || code.find_first_not_of(" \t\r") != std::string::npos;
      sawCode_ = sawCode_ || codeSince_;
    } else if (slip_.at.line == 0 && !conditionalMeant(directive).empty()) {
      slip_ = {UnbalancedConditional::Kind::Misspelt, at, std::string(directive),
               std::string(conditionalMeant(directive))};
    }
  }

  std::optional<UnbalancedConditional> unbalanced() const {
    int open = 0;
    for (const NestingMark& mark : marks_) {
      open += mark.kind == Kind::Open ? 1 : mark.kind == Kind::Close ? -1 : 0;
    }
    if (open == 0) return std::nullopt;
    if (slip_.at.line > 0) return slip_;
    const Kind missing = open > 0 ? Kind::Close : Kind::Open;
    std::vector<NestingPlace> places;
    for (std::size_t i = 0; i <= marks_.size(); ++i) {
      const int line = i == 0 ? 0 : marks_[i - 1].line;
      // Nobody writes a branch of nothing.
      const bool empty = i == marks_.size() ? !codeSince_ : !codeBefore_[i];
      places.push_back({.before = i, .line = line, .cost = empty ? kEmptyBranch : 0});
    }
    const auto found = findMissingMark(marks_, places, missing);
    if (!found) return std::nullopt;
    return UnbalancedConditional{
        open > 0 ? UnbalancedConditional::Kind::Unclosed : UnbalancedConditional::Kind::Stray,
        origins_[found->partner], names_[found->partner], ""};
  }

 private:
  std::vector<NestingMark> marks_;
  std::vector<Origin> origins_;
  std::vector<std::string> names_;
  UnbalancedConditional slip_;
  int depth_ = 0;
  std::vector<bool> codeBefore_;  ///< of each mark: is there text since the one before?
  bool inComment_ = false, sawCode_ = false, codeSince_ = false;
};

}  // namespace

std::vector<UnbalancedConditional> findUnbalancedConditionals(const FlatSource& source) {
  std::map<std::string, int> sites;  // the first of each file
  std::map<int, FileConditionals> files;
  for (const FlatLine& line : source.lines) {
    if (line.site < 0 || std::size_t(line.site) >= source.sites.size()) continue;
    const std::string& file = source.sites[std::size_t(line.site)].file;
    if (sites.try_emplace(file, line.site).first->second == line.site) files[line.site].read(line);
  }
  std::vector<UnbalancedConditional> found;
  for (const auto& [site, file] : files) {
    if (const auto unbalanced = file.unbalanced()) found.push_back(*unbalanced);
  }
  return found;
}

}  // namespace orris
