#include <orris/glsl/preprocess/macro_expander.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include <orris/core/limits.h>

namespace orris {
namespace {

// Marks tokens of a macro's body until push() gives them the place of the invocation.
constexpr int kAtInvocation = -2;

class ListSource : public TokenSource {
 public:
  explicit ListSource(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}
  bool next(Token& token) override {
    if (position_ >= tokens_.size()) return false;
    token = std::move(tokens_[position_++]);
    return true;
  }

 private:
  std::vector<Token> tokens_;
  std::size_t position_ = 0;
};

bool is(const Token& token, std::string_view text) {
  return token.kind == TokenKind::Punctuator && token.text == text;
}

// Nested calls double the backslashes each time: what is longer than a token may be is cut here and
// refused by spend().
Token stringify(const std::vector<Token>& tokens) {
  Token result;
  result.kind = TokenKind::Other;
  result.text = "\"";
  for (const Token& token : tokens) {
    const bool space = token.spaceBefore || token.newlinesBefore > 0;
    if (space && result.text.size() > 1) result.text += ' ';
    for (char c : token.text) {
      if (c == '"' || c == '\\') result.text += '\\';
      result.text += c;
    }
    if (result.text.size() > limits::kTokenBytes) break;
  }
  result.text += '"';
  return result;
}

// "a ## b": the two texts are read again as one. Returns their length.
std::size_t paste(std::vector<Token>& out, const Token& right) {
  const Token left = std::move(out.back());
  out.pop_back();
  const std::size_t length = left.text.size() + right.text.size();
  std::vector<Token> joined = tokenize(left.text + right.text);
  for (Token& token : joined) {
    token.origin = left.origin;
    token.macro = left.macro;
  }
  if (!joined.empty()) {
    joined.front().spaceBefore = left.spaceBefore;
    joined.front().newlinesBefore = left.newlinesBefore;
  }
  std::move(joined.begin(), joined.end(), std::back_inserter(out));
  return length;
}

std::size_t textBytes(const std::vector<Token>& tokens) {
  std::size_t bytes = 0;
  for (const Token& token : tokens) bytes += token.text.size();
  return bytes;
}

}  // namespace

MacroExpander::~MacroExpander() {
  while (!contexts_.empty()) pop();
}

void MacroExpander::pop() {
  if (contexts_.back().macro) contexts_.back().macro->disabled = false;
  contexts_.pop_back();
}

bool MacroExpander::fetch(Token& token) {
  while (!contexts_.empty()) {
    Context& top = contexts_.back();
    if (top.position < top.tokens.size()) {
      token = std::move(top.tokens[top.position++]);
      return true;
    }
    pop();
  }
  return source_.next(token);
}

bool MacroExpander::next(Token& token) {
  while (fetch(token)) {
    if (token.kind == TokenKind::Identifier && !token.painted && expand(token)) continue;
    token.spaceBefore = token.spaceBefore || carriedSpace_;
    token.newlinesBefore = std::max(token.newlinesBefore, carriedNewlines_);
    carriedSpace_ = false;
    carriedNewlines_ = 0;
    return true;
  }
  return false;
}

// True when `name` was replaced and the result is next to be read.
bool MacroExpander::expand(Token& name) {
  Macro* macro = state_.macros.find(name.text);
  if (!macro || state_.exhausted) return false;
  if (macro->disabled) {
    name.painted = true;
    return false;
  }
  std::vector<Argument> arguments;
  if (macro->functionLike &&
      (!openParenthesisFollows() || !collectArguments(*macro, name, arguments))) {
    return false;
  }
  Tokens result = substitute(*macro, arguments);
  if (!spend(name, result.size() + 1)) return false;
  push(*macro, name, std::move(result));
  return true;
}

bool MacroExpander::spend(const Token& at, std::size_t tokens) {
  state_.produced += tokens;
  if (state_.produced <= limits::kExpandedTokens && state_.bytes <= limits::kExpandedBytes &&
      contexts_.size() < limits::kMacroContexts) {
    return true;
  }
  if (!state_.exhausted) {
    state_.report(
        at, "macro-expansion-limit",
        fmt::format("macro '{}' expands without bound; nothing is expanded from here on", at.text));
  }
  state_.exhausted = true;
  return false;
}

// Looks past comments for the "("; without it every token is put back.
bool MacroExpander::openParenthesisFollows() {
  Tokens seen;
  Token token;
  bool found = false;
  while (fetch(token)) {
    found = is(token, "(");
    const bool comment = token.kind == TokenKind::Comment;
    if (!found) seen.push_back(std::move(token));
    if (!comment) break;
  }
  if (!found && !seen.empty()) contexts_.push_back({std::move(seen), 0, nullptr});
  return found;
}

// Reads up to the ")" that closes the invocation.
bool MacroExpander::collectArguments(const Macro& macro, const Token& name,
                                     std::vector<Argument>& arguments) {
  arguments.emplace_back();
  int depth = 0;
  Token token;
  while (fetch(token)) {
    if (token.kind == TokenKind::Comment) continue;
    if (depth == 0 && is(token, ")")) return fitArguments(macro, name, arguments);
    const bool last = macro.variadic && arguments.size() == macro.parameters.size();
    if (depth == 0 && is(token, ",") && !last) {
      arguments.emplace_back();
      continue;
    }
    depth += is(token, "(") ? 1 : is(token, ")") ? -1 : 0;
    arguments.back().raw.push_back(std::move(token));
  }
  state_.report(name, "macro-unterminated",
                fmt::format("invocation of macro '{}' is not closed: expected ')'", macro.name));
  return false;
}

bool MacroExpander::fitArguments(const Macro& macro, const Token& name,
                                 std::vector<Argument>& arguments) {
  const std::size_t wanted = macro.parameters.size();
  if (wanted == 0 && arguments.size() == 1 && arguments[0].raw.empty()) arguments.clear();
  if (macro.variadic && arguments.size() + 1 == wanted) arguments.emplace_back();
  if (arguments.size() == wanted) return true;
  state_.report(name, "macro-arguments",
                fmt::format("macro '{}' takes {} argument{}, given {}", macro.name, wanted,
                            wanted == 1 ? "" : "s", arguments.size()));
  return false;
}

const MacroExpander::Tokens& MacroExpander::expandedArgument(Argument& argument) {
  if (argument.isExpanded) return argument.expanded;
  argument.isExpanded = true;
  argument.expanded = expandTokens(argument.raw, state_);
  return argument.expanded;
}

MacroExpander::Tokens MacroExpander::substitute(const Macro& macro,
                                                std::vector<Argument>& arguments) {
  Tokens out;
  bool pasteNext = false;
  bool leftIsEmpty = false;  // the operand left of ## was an empty argument
  for (std::size_t i = 0; i < macro.body.size(); ++i) {
    if (macro.roles[i] == Macro::Paste) {
      pasteNext = true;
      continue;
    }
    const bool beforePaste = i + 1 < macro.body.size() && macro.roles[i + 1] == Macro::Paste;
    Tokens piece;
    const Token& first = macro.body[i];
    const bool stringified = macro.roles[i] == Macro::Stringify;
    if (stringified) {
      piece.push_back(stringify(arguments[static_cast<std::size_t>(macro.roles[++i])].raw));
      piece.front().origin.site = kAtInvocation;
    } else if (macro.roles[i] >= 0) {
      Argument& argument = arguments[static_cast<std::size_t>(macro.roles[i])];
      piece = pasteNext || beforePaste ? argument.raw : expandedArgument(argument);
    } else {
      piece.push_back(first);
      piece.front().written = first.origin;
      piece.front().origin.site = kAtInvocation;
    }
    if (!piece.empty()) piece.front().spaceBefore = first.spaceBefore;
    std::size_t from = 0;
    std::size_t made = stringified ? piece.front().text.size() : 0;
    state_.bytes += textBytes(piece);
    if (pasteNext && !leftIsEmpty && !out.empty() && !piece.empty()) {
      made = paste(out, piece[from++]);
      state_.bytes += made;
    }
    leftIsEmpty = piece.empty() && (!pasteNext || leftIsEmpty);
    pasteNext = false;
    if (made > limits::kTokenBytes || state_.bytes > limits::kExpandedBytes ||
        out.size() + piece.size() > limits::kExpandedTokens) {
      state_.produced = limits::kExpandedTokens;  // what is missing must not go unnoticed
      break;
    }
    std::move(piece.begin() + static_cast<std::ptrdiff_t>(from), piece.end(),
              std::back_inserter(out));
  }
  return out;
}

// A token of the body stands where the invocation stands, a token of an argument stays where the
// author wrote it; both name the outermost macro.
void MacroExpander::push(Macro& macro, const Token& name, Tokens tokens) {
  if (tokens.empty()) {
    carriedSpace_ = true;
    carriedNewlines_ = std::max(carriedNewlines_, name.newlinesBefore);
    return;
  }
  int index = name.macro;
  if (index < 0) {
    if (macro.mapIndex < 0) {
      macro.mapIndex = static_cast<int>(state_.usedNames.size());
      state_.usedNames.push_back(macro.name);
      state_.usedOrigins.push_back(macro.origin);
    }
    index = macro.mapIndex;
  }
  for (Token& token : tokens) {
    if (token.origin.site == kAtInvocation) token.origin = name.origin;
    token.macro = index;
  }
  tokens.front().spaceBefore = name.spaceBefore;
  tokens.front().newlinesBefore = name.newlinesBefore;
  macro.disabled = true;
  contexts_.push_back({std::move(tokens), 0, &macro});
}

std::vector<Token> expandTokens(std::vector<Token> tokens, ExpansionState& state) {
  const bool anyMacro = std::any_of(tokens.begin(), tokens.end(), [&state](const Token& token) {
    return token.kind == TokenKind::Identifier && state.macros.find(token.text);
  });
  if (!anyMacro) return tokens;
  if (state.depth >= limits::kMacroArgumentDepth) {
    if (!state.exhausted) {
      state.report(tokens.front(), "macro-expansion-limit",
                   "macro arguments are nested too deeply; nothing is expanded from here on");
    }
    state.exhausted = true;
    return tokens;
  }
  ++state.depth;
  ListSource source(std::move(tokens));
  std::vector<Token> result;
  {
    MacroExpander expander(source, state);
    Token token;
    while (expander.next(token)) result.push_back(std::move(token));
  }
  --state.depth;
  return result;
}

}  // namespace orris
