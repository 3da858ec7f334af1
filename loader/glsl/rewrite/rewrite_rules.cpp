#include <orris/glsl/rewrite/rewrite_rules.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace orris {

bool RewriteContext::hasFired(std::string_view rule) const {
  return std::any_of(rules.begin(), rules.end(),
                     [rule](const AppliedRule& applied) { return applied.rule == rule; });
}

void RewriteContext::fired(std::string_view rule, const Origin& origin) {
  const auto known = std::find_if(rules.begin(), rules.end(),
                                  [rule](const AppliedRule& r) { return r.rule == rule; });
  if (known != rules.end()) {
    ++known->count;
  } else {
    rules.push_back({std::string(rule), 1, locate(stream.sites, origin)});
  }
}

bool bracesBalance(const TokenStream& stream) {
  int depth = 0;
  for (const Token& token : stream.tokens) {
    depth += token.text == "{" ? 1 : token.text == "}" ? -1 : 0;
    if (depth < 0) return false;
  }
  return depth == 0;
}

void TokenEdits::insertBefore(std::size_t index, std::vector<Token> tokens) {
  edits_.push_back({index, index, std::move(tokens)});
}

void TokenEdits::erase(std::size_t first, std::size_t last) {
  if (first < last) edits_.push_back({first, last, {}});
}

void TokenEdits::apply(std::vector<Token>& tokens) {
  if (edits_.empty()) return;
  std::stable_sort(edits_.begin(), edits_.end(),
                   [](const Edit& a, const Edit& b) { return a.first < b.first; });
  std::size_t added = 0;
  for (const Edit& edit : edits_) added += edit.tokens.size();
  std::vector<Token> result;
  result.reserve(tokens.size() + added);
  std::size_t position = 0;
  int newlines = 0;
  const auto copyUntil = [&](std::size_t end) {
    for (; position < end; ++position) {
      Token& token = result.emplace_back(std::move(tokens[position]));
      token.newlinesBefore = std::max(token.newlinesBefore, newlines);
      token.spaceBefore = token.spaceBefore || newlines > 0;
      newlines = 0;
    }
  };
  for (Edit& edit : edits_) {
    if (edit.first < position) continue;
    copyUntil(std::min(edit.first, tokens.size()));
    std::move(edit.tokens.begin(), edit.tokens.end(), std::back_inserter(result));
    for (; position < std::min(edit.last, tokens.size()); ++position) {
      newlines = std::max(newlines, tokens[position].newlinesBefore);
    }
  }
  copyUntil(tokens.size());
  tokens = std::move(result);
}

std::size_t nextCode(const std::vector<Token>& tokens, std::size_t index) {
  do ++index;
  while (index < tokens.size() && tokens[index].kind == TokenKind::Comment);
  return std::min(index, tokens.size());
}

std::size_t previousCode(const std::vector<Token>& tokens, std::size_t index) {
  index = std::min(index, tokens.size());
  while (index-- > 0) {
    if (tokens[index].kind != TokenKind::Comment) return index;
  }
  return tokens.size();
}

bool followedBy(const std::vector<Token>& tokens, std::size_t index, std::string_view punctuator) {
  const std::size_t next = nextCode(tokens, index);
  return next < tokens.size() && isPunctuator(tokens[next], punctuator);
}

bool precededBy(const std::vector<Token>& tokens, std::size_t index, std::string_view punctuator) {
  const std::size_t previous = previousCode(tokens, index);
  return previous < tokens.size() && isPunctuator(tokens[previous], punctuator);
}

std::size_t closingBracket(const std::vector<Token>& tokens, std::size_t open) {
  // Only its own kind counts: a ")" too many in a body must not end the function.
  const char opens = tokens[open].text.front(), closes = opens == '(' ? ')' : opens == '[' ? ']' : '}';
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind != TokenKind::Punctuator || token.text.size() != 1) continue;
    if (token.text.front() == opens) ++depth;
    if (token.text.front() == closes && --depth == 0) return i;
  }
  return tokens.size();
}

std::vector<Token> hostTokens(std::string_view text, bool newLine) {
  std::vector<Token> tokens = tokenize(text);
  for (Token& token : tokens) token.origin = {};
  if (newLine && !tokens.empty()) tokens.front().newlinesBefore = 1;
  return tokens;
}

}  // namespace orris
