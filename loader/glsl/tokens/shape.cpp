#include <orris/glsl/tokens/shape.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include <orris/core/characters.h>
#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

/// Marks the numbers of a stage that count by kind only.
class NumberMarker {
 public:
  explicit NumberMarker(const std::vector<Token>& tokens)
      : tokens_(tokens), byKind_(tokens.size(), false) {}

  std::vector<bool> run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind == TokenKind::Comment) continue;
      if (tokens_[i].kind == TokenKind::Number) {
        number(i);
      } else if (tokens_[i].kind == TokenKind::Punctuator) {
        punctuator(i);
      } else if (tokens_[i].kind == TokenKind::Identifier) {
        isConst_ = isConst_ || tokens_[i].text == "const";
        isCase_ = isCase_ || tokens_[i].text == "case";
      }
      previous_ = i;
    }
    return std::move(byKind_);
  }

 private:
  void number(std::size_t i) {
    if (isConst_ || isCase_ || keeping_ > 0 || !numberKind(tokens_[i].text)) return;
    byKind_[i] = true;
    statement_.push_back(i);
  }

  void punctuator(std::size_t i) {
    const std::string& text = tokens_[i].text;
    if (text == "(" || text == "[") {
      open(text == "[" || (previous_ < i && wantsConstants(tokens_[previous_])));
    } else if (text == ")" || text == "]") {
      close();
    } else if (text == "{" && (lists_ > 0 || (previous_ < i && tokens_[previous_].text == "="))) {
      ++lists_;
    } else if (text == "}" && lists_ > 0) {
      --lists_;
    } else if (text == ";" || text == "{" || text == "}") {
      endStatement();
    } else if (text == ":") {
      isCase_ = false;
    } else if (text == "?") {
      // A constant condition is folded away, and with it what the expression is.
      for (const std::size_t number : statement_) byKind_[number] = false;
      statement_.clear();
    }
  }

  void open(bool keeps) {
    brackets_.push_back(keeps);
    keeping_ += keeps ? 1 : 0;
  }

  void close() {
    if (brackets_.empty()) return;
    keeping_ -= brackets_.back() ? 1 : 0;
    brackets_.pop_back();
  }

  // In parentheses only that of a `for` ends a statement; its parts may as well count apart.
  void endStatement() {
    isConst_ = isCase_ = false;
    statement_.clear();
  }

  // Components, offsets, streams and clusters must be constants within limits.
  static bool wantsConstants(const Token& name) {
    constexpr std::array<std::string_view, 4> kParts = {"Gather", "Offset", "Stream", "subgroup"};
    if (name.kind != TokenKind::Identifier) return false;
    return name.text == "layout" || std::any_of(kParts.begin(), kParts.end(), [&](auto part) {
             return name.text.find(part) != std::string::npos;
           });
  }

  const std::vector<Token>& tokens_;
  std::vector<bool> byKind_;
  std::vector<std::size_t> statement_;  ///< numbers marked since it began
  std::vector<bool> brackets_;          ///< open ones; do they keep numbers as they are?
  std::size_t previous_ = 0;
  int keeping_ = 0, lists_ = 0;
  bool isConst_ = false, isCase_ = false;
};

bool runsTogether(const Token& left, const Token& right) {
  return !right.spaceBefore && right.newlinesBefore == 0 && left.kind != TokenKind::Comment &&
         right.kind != TokenKind::Comment && wouldGlue(left, right);
}

}  // namespace

std::optional<char> numberKind(std::string_view text) {
  constexpr std::size_t kMostDigits = 9;  // of any kind of number, whatever the value
  const auto isNot = [](char c) { return !isDigit(c); };
  const auto end = std::find_if(text.begin(), text.end(), isNot);
  const auto digits = static_cast<std::size_t>(end - text.begin());
  std::string_view rest = text.substr(digits);
  if (digits > kMostDigits) return std::nullopt;
  if (rest.empty() || rest == "u" || rest == "U") {
    if (digits == 0 || (digits > 1 && text[0] == '0')) return std::nullopt;
    const bool zero = text[0] == '0';
    return rest.empty() ? (zero ? 'z' : 'i') : (zero ? 'Z' : 'u');
  }
  if (rest[0] != '.') return std::nullopt;
  rest.remove_prefix(1);
  const auto fraction = std::find_if(rest.begin(), rest.end(), isNot);
  const auto places = static_cast<std::size_t>(fraction - rest.begin());
  if (digits + places == 0 || places > kMostDigits) return std::nullopt;
  rest.remove_prefix(places);
  if (rest.empty()) return 'f';
  return rest == "f" || rest == "F" ? std::optional('F') : std::nullopt;
}

std::uint64_t shapeOf(const TokenStream& stream, Stage stage) {
  const std::vector<Token>& tokens = stream.tokens;
  const std::vector<bool> marked = NumberMarker(tokens).run();
  std::string shape = std::string(stageName(stage)) + '\n' + std::to_string(stream.version) + ' ' +
                      stream.profile + '\n';
  for (const auto& extension : stream.extensions) {
    shape += extension.name + ':' + extension.behaviour + '\n';
  }
  bool together = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool nextTogether = i + 1 < tokens.size() && runsTogether(tokens[i], tokens[i + 1]);
    if (marked[i] && !together && !nextTogether) {
      shape += {'\1', *numberKind(tokens[i].text)};
    } else {
      shape += tokens[i].text;
    }
    shape += nextTogether ? '\2' : '\n';
    together = nextTogether;
  }
  return std::hash<std::string>()(shape);
}

}  // namespace orris
