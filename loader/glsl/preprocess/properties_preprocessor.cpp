#include <algorithm>
#include <array>
#include <string_view>

#include <orris/glsl/preprocess/directive_runner.h>
#include <orris/glsl/preprocess/preprocessor.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 8> kDirectives = {"if",   "ifdef", "ifndef", "elif",
                                                         "else", "endif", "define", "undef"};

std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\f\v";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// The rules of Iris's PropertiesPreprocessor: a directive follows '#' without a blank and may even
// stand between continued lines; a backslash does not join lines for the preprocessor.
class PropertiesPreprocessor {
 public:
  PropertiesPreprocessor(const std::string& file, const MacroDefinitions& environment,
                         Diagnostics& diagnostics, NameWatch* watch)
      : source_{{{file, -1, 0}}, {}, nullptr}, runner_(source_, environment, stream_, diagnostics, watch) {}

  std::string run(std::string_view text) {
    std::string out;
    std::size_t start = 0;
    while (start < text.size()) {
      const std::size_t end = std::min(text.find('\n', start), text.size());
      source_.own(std::string(text.substr(start, end - start)), 0, ++line_);
      out += convert(source_.lines.back().text);
      out += '\n';
      start = end + 1;
    }
    runner_.finish();
    return out;
  }

 private:
  std::vector<Token> tokensOf(std::string_view text, std::size_t column) const {
    std::vector<Token> tokens = tokenize(text);
    for (Token& token : tokens) {
      token.origin = {0, line_, token.origin.column + static_cast<int>(column)};
    }
    return tokens;
  }

  std::string convert(std::string_view line) {
    const std::string_view text = withoutBlanks(line);
    if (text.empty() || text.front() == '!') return "";
    const auto column = static_cast<std::size_t>(text.data() - line.data());
    if (text.front() == '#') {
      directive(text, column);
      return "";
    }
    if (!continued_) isMenu_ = startsMenuKey(text);
    continued_ = text.back() == '\\';
    if (!runner_.active()) return "";
    MacroTable& macros = runner_.expansion().macros;
    const unsigned char purpose = macros.setPurpose(isMenu_ ? 0 : NameWatch::kText);
    std::string expanded = expand(text, column);
    macros.setPurpose(purpose);
    return expanded;
  }

  // These keys are read from the unpreprocessed file, so that the names in them decide nothing.
  static bool startsMenuKey(std::string_view text) {
    return text.starts_with("screen") || text.starts_with("profile.") ||
           text.starts_with("sliders");
  }

  void directive(std::string_view text, std::size_t column) {
    std::vector<Token> tokens = tokensOf(text.substr(1), column + 1);
    std::erase_if(tokens, [](const Token& token) { return token.kind == TokenKind::Comment; });
    if (tokens.empty() || tokens.front().spaceBefore) return;
    const auto known = std::find(kDirectives.begin(), kDirectives.end(), tokens.front().text);
    if (known == kDirectives.end()) return;
    runner_.run(std::move(tokens), {0, line_, static_cast<int>(column) + 1});
  }

  // Lines without a macro stay as they are, down to their blanks.
  std::string expand(std::string_view text, std::size_t column) {
    std::string kept(text);
    std::erase(kept, '#');
    std::vector<Token> tokens = tokensOf(kept, column);
    MacroTable& macros = runner_.expansion().macros;
    const bool anyMacro = std::any_of(tokens.begin(), tokens.end(), [&macros](const Token& token) {
      return token.kind == TokenKind::Identifier && macros.find(token.text);
    });
    return anyMacro ? joinTokens(expandTokens(std::move(tokens), runner_.expansion()), 0) : kept;
  }

  FlatSource source_;
  TokenStream stream_;
  DirectiveRunner runner_;
  int line_ = 0;
  bool continued_ = false;  ///< the line before ended in a backslash
  bool isMenu_ = false;     ///< this line belongs to a key of screens, profiles or sliders
};

}  // namespace

std::string preprocessProperties(const std::string& file, const std::string& text,
                                 const MacroDefinitions& environment, Diagnostics& diagnostics,
                                 NameWatch* watch) {
  if (text.empty()) return "";  // most files that may be there are not: they need no table of macros
  return PropertiesPreprocessor(file, environment, diagnostics, watch).run(text);
}

}  // namespace orris
