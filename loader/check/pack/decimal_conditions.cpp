#include <orris/check/pack/decimal_conditions.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <orris/glsl/tokens/token.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Values = std::vector<std::string>;

std::vector<Token> tokensOfLine(std::string_view line) {
  std::vector<Token> tokens = tokenize(line);
  std::erase_if(tokens, [](const Token& token) { return token.kind == TokenKind::Comment; });
  return tokens;
}

/// What names stand for in conditions.
class PossibleValues {
 public:
  explicit PossibleValues(const ShaderPack& pack) : pack_(pack) {
    for (const auto& [file, lines] : pack.files) {
      for (const std::string& line : lines) {
        if (trim(line).starts_with("#define ")) readDefinition(line);
      }
    }
  }

  /// The values of an option, or those that #define lines give a macro; empty when they are not known.
  Values of(const std::string& name, int depth = 0) const {
    constexpr int kDeepestDefine = 4;
    if (const Option* option = pack_.options.find(name)) return option->values;
    const auto found = bodies_.find(name);
    if (found == bodies_.end() || depth == kDeepestDefine) return {};
    Values values;
    for (const std::string& body : found->second) {
      if (parseFloat(body)) {
        values.push_back(body);
        continue;
      }
      const Values inner = of(body, depth + 1);
      if (inner.empty()) return {};
      values.insert(values.end(), inner.begin(), inner.end());
    }
    return values;
  }

 private:
  // "#define NAME BODY"; a longer body is kept as no name.
  void readDefinition(const std::string& line) {
    constexpr std::size_t kName = 2, kBody = 3;
    const std::vector<Token> tokens = tokensOfLine(line);
    if (tokens.size() <= kName) return;
    Values& bodies = bodies_[tokens[kName].text];
    const std::string body = tokens.size() == kBody + 1 ? tokens[kBody].text : "";
    if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) bodies.push_back(body);
  }

  const ShaderPack& pack_;
  std::map<std::string, Values> bodies_;
};

/// `NAME < 1.0`, or the other side first, as a whole operand of a condition.
struct Comparison {
  std::string name, sign;
  float number = 0;
  bool nameFirst = true;

  bool holds(float value, float other) const {
    const float left = nameFirst ? value : other, right = nameFirst ? other : value;
    if (sign == "<") return left < right;
    if (sign == ">") return left > right;
    if (sign == "<=") return left <= right;
    if (sign == ">=") return left >= right;
    return (left == right) == (sign == "==");
  }
  bool differsAt(float value) const {
    return holds(value, number) != holds(std::trunc(value), std::trunc(number));
  }
  std::string asIris(float value) const {
    const float left = nameFirst ? value : number, right = nameFirst ? number : value;
    return fmt::format("{:.0f} {} {:.0f}", std::trunc(left), sign, std::trunc(right));
  }
};

bool isComparison(std::string_view sign) {
  return sign == "<" || sign == ">" || sign == "<=" || sign == ">=" || sign == "==" || sign == "!=";
}

bool endsOperand(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size()) return true;
  const std::string& text = tokens[at].text;
  return text == "(" || text == ")" || text == "&&" || text == "||" || text == "!" ||
         text == "if" || text == "elif";
}

std::optional<Comparison> comparisonAt(const std::vector<Token>& tokens, std::size_t number) {
  const auto value = parseFloat(tokens[number].text);
  if (!value) return std::nullopt;
  const auto made = [&](std::size_t name, std::size_t sign, bool nameFirst,
                        std::size_t before, std::size_t after) -> std::optional<Comparison> {
    if (name >= tokens.size() || tokens[name].kind != TokenKind::Identifier) return std::nullopt;
    if (!isComparison(tokens[sign].text)) return std::nullopt;
    if (!endsOperand(tokens, before) || !endsOperand(tokens, after)) return std::nullopt;
    return Comparison{tokens[name].text, tokens[sign].text, *value, nameFirst};
  };
  if (number >= 3) {
    if (auto found = made(number - 2, number - 1, true, number - 3, number + 1)) return found;
  }
  return made(number + 2, number + 1, false, number - 1, number + 3);
}

class DecimalCheck {
 public:
  DecimalCheck(const ShaderPack& pack, Diagnostics& diagnostics)
      : pack_(pack), diagnostics_(diagnostics) {}

  void checkLine(const std::string& file, std::size_t index, const std::string& line) {
    const std::vector<Token> tokens = tokensOfLine(line);
    for (std::size_t i = 1; i < tokens.size(); ++i) {
      if (tokens[i].kind != TokenKind::Number || tokens[i].text.find('.') == std::string::npos)
        continue;
      Diagnostic d{.severity = Severity::Warning,
                   .id = "condition-decimal",
                   .at = {file, static_cast<int>(index) + 1, tokens[i].origin.column},
                   .sourceLine = line,
                   .hint = "compare an option of whole numbers, or compute with it in the code"};
      describe(tokens, i, d);
      diagnostics_.push_back(std::move(d));
    }
  }

 private:
  void describe(const std::vector<Token>& tokens, std::size_t at, Diagnostic& d) {
    const std::string whole = tokens[at].text.substr(0, tokens[at].text.find('.'));
    d.message = fmt::format("conditions count in whole numbers: Iris takes {} for {}",
                            tokens[at].text, whole.empty() ? "0" : whole);
    const auto comparison = comparisonAt(tokens, at);
    const Values values = comparison ? valuesOf(comparison->name) : Values{};
    if (values.empty()) return;
    for (const std::string& value : values) {
      const auto number = parseFloat(value);
      if (!number) return;
      if (!comparison->differsAt(*number)) continue;
      d.message = fmt::format("conditions count in whole numbers: with {} at {} Iris compares {}",
                              comparison->name, value, comparison->asIris(*number));
      return;
    }
    d.severity = Severity::Note;
  }

  // Few packs compare decimals: the files are read for macros when one does.
  Values valuesOf(const std::string& name) {
    if (!possible_) possible_.emplace(pack_);
    return possible_->of(name);
  }

  const ShaderPack& pack_;
  Diagnostics& diagnostics_;
  std::optional<PossibleValues> possible_;
};

}  // namespace

void checkDecimals(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  DecimalCheck check(folders.front(), diagnostics);
  for (const auto& [file, lines] : folders.front().files) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string_view line = trim(lines[i]);
      if (line.starts_with("#if ") || line.starts_with("#elif ")) check.checkLine(file, i, lines[i]);
    }
  }
}

}  // namespace orris
