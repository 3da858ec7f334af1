
#include "core/limits.h"
#include "core/message_limits.h"
#include "glsl/preprocess/condition.h"
#include "glsl/preprocess/directive_runner.h"
#include "glsl/syntax/directive_slip.h"
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace orris {
namespace {

// A broken source can be wrong on every line; more than this says nothing new.
constexpr std::size_t kMaxReports = 100;

// Iris: JcppProcessor logs what its preprocessor complains about and goes on.
constexpr const char* kTolerated = "Iris goes on after this, other hosts refuse the program";

std::size_t firstCode(const std::vector<Token>& tokens) {
  std::size_t i = 0;
  while (i < tokens.size() && tokens[i].kind == TokenKind::Comment) ++i;
  return i;
}

// A comment counts as one blank.
void removeComments(std::vector<Token>& tokens) {
  bool space = false;
  std::size_t kept = 0;
  for (Token& token : tokens) {
    if (token.kind == TokenKind::Comment) {
      space = true;
      continue;
    }
    token.spaceBefore = token.spaceBefore || space;
    space = false;
    if (&tokens[kept] != &token) tokens[kept] = std::move(token);
    ++kept;
  }
  tokens.resize(kept);
}

}  // namespace

std::string joinTokens(const std::vector<Token>& tokens, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < tokens.size(); ++i) {
    if (i > from && tokens[i].spaceBefore) text += ' ';
    text += tokens[i].text;
  }
  return text;
}

struct DirectiveRunner::Directive {
  std::string_view name;
  void (DirectiveRunner::*run)(const std::vector<Token>&);
  bool conditional;  // runs in inactive branches too
};

const DirectiveRunner::Directive* DirectiveRunner::find(std::string_view name) {
  static constexpr Directive kDirectives[] = {
      {"if", &DirectiveRunner::onIf, true},
      {"ifdef", &DirectiveRunner::onIfdef, true},
      {"ifndef", &DirectiveRunner::onIfdef, true},
      {"elif", &DirectiveRunner::onElif, true},
      {"else", &DirectiveRunner::onElse, true},
      {"endif", &DirectiveRunner::onEndif, true},
      {"define", &DirectiveRunner::onDefine, false},
      {"undef", &DirectiveRunner::onUndef, false},
      {"version", &DirectiveRunner::onVersion, false},
      {"extension", &DirectiveRunner::onExtension, false},
      {"error", &DirectiveRunner::onError, false},
      {"warning", &DirectiveRunner::onError, false},
      {"pragma", &DirectiveRunner::onIgnored, false},
      {"line", &DirectiveRunner::onIgnored, false},
  };
  for (const Directive& directive : kDirectives) {
    if (directive.name == name) return &directive;
  }
  return nullptr;
}

DirectiveRunner::DirectiveRunner(const FlatSource& source, const MacroDefinitions& environment,
                                 TokenStream& stream, Diagnostics& diagnostics, NameWatch* watch)
    : source_(source),
      reader_(source),
      sites_(source.sites),
      stream_(stream),
      diagnostics_(diagnostics),
      macros_(environment, watch),
      expansion_{macros_, stream.macroNames, stream.macroOrigins,
                 [this](const Token& at, std::string id, std::string message) {
                   report(Severity::Error, std::move(id), at.origin, std::move(message));
                 }} {}

void DirectiveRunner::report(Severity severity, std::string id, const Origin& at,
                             std::string message, std::string hint) {
  if (++reported_ > kMaxReports) return;
  Diagnostic d;
  d.severity = severity;
  d.id = std::move(id);
  d.at = locate(sites_, at);
  d.message = std::move(message);
  d.includedFrom = includedFrom(sites_, at.site);
  d.sourceLine = quotedLine(reader_.textOf(at), at.column);
  d.hint = std::move(hint);
  diagnostics_.push_back(std::move(d));
}

bool DirectiveRunner::next(Token& token) {
  while (position_ >= line_.size()) {
    if (!readLine()) return false;
  }
  token = std::move(line_[position_++]);
  return true;
}

// Leaves the next text of an active branch in line_; it may be empty.
bool DirectiveRunner::readLine() {
  line_.clear();
  position_ = 0;
  if (!conditionals_.active()) reader_.skipPlainLines();
  if (reader_.atEnd()) return false;
  reader_.read(line_);
  ++pendingNewlines_;
  const bool wasActive = conditionals_.active();
  takeDirective();
  if (!wasActive) line_.clear();
  if (!line_.empty()) {
    line_.front().newlinesBefore += std::min(pendingNewlines_, 2);
    pendingNewlines_ = 0;
  }
  return true;
}

// Runs the directive of line_, if it is one, and leaves the comments before it.
bool DirectiveRunner::takeDirective() {
  const std::size_t hash = firstCode(line_);
  if (hash >= line_.size() || !isPunctuator(line_[hash], "#")) return false;
  const Origin at = line_[hash].origin;
  const auto begin = line_.begin() + static_cast<std::ptrdiff_t>(hash) + 1;
  std::vector<Token> tokens(std::make_move_iterator(begin), std::make_move_iterator(line_.end()));
  line_.resize(hash);
  removeComments(tokens);
  run(std::move(tokens), at);
  return true;
}

void DirectiveRunner::run(std::vector<Token> tokens, const Origin& hash) {
  if (tokens.empty()) return;
  const Directive* directive = find(tokens.front().text);
  if (directive && (directive->conditional || conditionals_.active())) {
    tokens.front().origin = {tokens.front().origin.site, hash.line, hash.column};
    (this->*directive->run)(tokens);
  } else if (!directive && conditionals_.active() && tokens.front().kind != TokenKind::Number) {
    reportUnknown(tokens.front().text, std::string(directiveMeant(tokens.front().text)), hash);
  }
}

void DirectiveRunner::reportUnknown(const std::string& name, const std::string& meant,
                                    const Origin& hash) {
  const std::size_t before = diagnostics_.size();
  report(Severity::Warning, "directive-unknown", hash,
         fmt::format("unknown preprocessor directive '#{}'", name),
         meant.empty() ? kTolerated : fmt::format("did you mean #{}?", meant));
  std::string line(reader_.textOf(hash));
  const std::size_t at = line.find(name, std::size_t(hash.column));
  if (meant.empty() || diagnostics_.size() == before || at == line.npos) return;
  diagnostics_.back().repair = LineEdit{locate(sites_, hash).file, hash.line,
                                        line.replace(at, name.size(), meant), true};
}

void DirectiveRunner::warnTrailing(const std::vector<Token>& tokens, std::size_t from,
                                   const std::string& name) {
  if (from >= tokens.size()) return;
  report(Severity::Warning, "directive-trailing-text", tokens[from].origin,
         fmt::format("text after the end of #{} is ignored: '{}'", name, joinTokens(tokens, from)),
         "some hosts refuse this; put it into a comment");
}

// Replaces "defined X" and "defined(X)" by 1 or 0.
bool DirectiveRunner::replaceDefined(const std::vector<Token>& tokens, std::vector<Token>& out) {
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::Identifier || tokens[i].text != "defined") {
      out.push_back(tokens[i]);
      continue;
    }
    const Token& operatorToken = tokens[i];
    const bool parenthesis = i + 1 < tokens.size() && isPunctuator(tokens[i + 1], "(");
    i += parenthesis ? 2 : 1;
    const bool named = i < tokens.size() && tokens[i].kind == TokenKind::Identifier;
    const bool closed = !parenthesis || (i + 1 < tokens.size() && isPunctuator(tokens[i + 1], ")"));
    if (!named || !closed) {
      report(Severity::Warning, "directive-malformed", operatorToken.origin,
             "expected 'defined NAME' or 'defined(NAME)'", kTolerated);
      return false;
    }
    Token value = operatorToken;
    value.kind = TokenKind::Number;
    value.text.assign(1, macros_.find(tokens[i].text) ? '1' : '0');
    value.painted = true;
    out.push_back(std::move(value));
    i += parenthesis;
  }
  return true;
}

bool DirectiveRunner::isTrue(const std::vector<Token>& tokens) {
  const unsigned char purpose = macros_.setPurpose(NameWatch::kCondition);
  const bool result = tokens.front().text.ends_with("def") ? macroNamed(tokens) : evaluate(tokens);
  macros_.setPurpose(purpose);
  return result;
}

// The condition of #if or #elif; a malformed one is false.
bool DirectiveRunner::evaluate(const std::vector<Token>& tokens) {
  const std::string& name = tokens.front().text;
  std::vector<Token> expression;
  if (!replaceDefined(tokens, expression)) return false;
  if (expression.empty()) {
    report(Severity::Warning, "condition-empty", tokens.front().origin,
           fmt::format("#{} without a condition counts as false", name), kTolerated);
    return false;
  }
  expression = expandTokens(std::move(expression), expansion_);
  removeComments(expression);
  if (expression.empty()) {
    report(Severity::Warning, "condition-empty", tokens[1].origin,
           fmt::format("the condition '{}' expands to nothing and counts as false",
                       joinTokens(tokens, 1)),
           "use #ifdef to ask whether a macro without a value is defined");
    return false;
  }
  const ConditionResult result = evaluateCondition(expression);
  if (!result.problem.empty()) {
    const Token& at =
        result.problemAt < expression.size() ? expression[result.problemAt] : expression.back();
    report(Severity::Warning, "condition-malformed", at.origin,
           fmt::format("condition of #{}: {}", name, result.problem), kTolerated);
    return result.value != 0;
  }
  warnTrailing(expression, result.used, name);
  return result.value != 0;
}

// Is the macro named by #ifdef or #ifndef defined?
bool DirectiveRunner::macroNamed(const std::vector<Token>& tokens) {
  const std::string& name = tokens.front().text;
  if (tokens.size() < 2 || tokens[1].kind != TokenKind::Identifier) {
    report(Severity::Warning, "directive-malformed", tokens.front().origin,
           fmt::format("expected a macro name after #{}", name), kTolerated);
    return false;
  }
  warnTrailing(tokens, 2, name);
  return macros_.find(tokens[1].text) != nullptr;
}

void DirectiveRunner::reportUnbalanced(const Origin& at, std::string problem) {
  report(Severity::Warning, "conditional-unbalanced", at, std::move(problem), kTolerated);
}

void DirectiveRunner::reportUnbalanced(const UnbalancedConditional& found) {
  Diagnostic d = describeUnbalanced(found, sites_[std::size_t(found.at.site)].file);
  d.includedFrom = includedFrom(sites_, found.at.site);
  d.sourceLine = reader_.textOf({found.at.site, d.at.line, d.at.column});
  d.hint = kTolerated;
  diagnostics_.push_back(std::move(d));
}

bool DirectiveRunner::reportInFiles() {
  if (unbalanced_) return !unbalanced_->empty();
  unbalanced_ = findUnbalancedConditionals(source_);
  for (const UnbalancedConditional& found : *unbalanced_) {
    if (found.kind == UnbalancedConditional::Kind::Misspelt) {
      reportUnknown(found.directive, found.meant, found.at);
    } else {
      reportUnbalanced(found);
    }
  }
  return !unbalanced_->empty();
}

void DirectiveRunner::onIf(const std::vector<Token>& tokens) {
  const bool condition = conditionals_.active() && isTrue(tokens);
  conditionals_.open(tokens.front().origin, tokens.front().text, condition);
}

void DirectiveRunner::onIfdef(const std::vector<Token>& tokens) {
  bool condition = false;
  if (conditionals_.active()) condition = isTrue(tokens) == (tokens.front().text == "ifdef");
  conditionals_.open(tokens.front().origin, tokens.front().text, condition);
}

void DirectiveRunner::onElif(const std::vector<Token>& tokens) {
  const bool condition = conditionals_.wantsElif() && isTrue(tokens);
  const std::string problem = conditionals_.elif (condition);
  if (problem.empty()) return;
  reportUnbalanced(tokens.front().origin, problem);
}

void DirectiveRunner::onElse(const std::vector<Token>& tokens) {
  const std::string problem = conditionals_.otherwise();
  if (problem.empty()) return;
  reportUnbalanced(tokens.front().origin, problem);
}

void DirectiveRunner::onEndif(const std::vector<Token>& tokens) {
  const std::string problem = conditionals_.close(tokens.front().origin);
  if (problem.empty() || reportInFiles()) return;
  reportUnbalanced(conditionals_.strayClose(tokens.front().origin), problem);
}

void DirectiveRunner::onDefine(const std::vector<Token>& tokens) {
  const std::vector<Token> definition(tokens.begin() + 1, tokens.end());
  const std::string problem = macros_.define(definition, tokens.front().origin);
  if (problem.empty()) return;
  report(Severity::Warning, "directive-malformed", tokens.front().origin, problem, kTolerated);
}

void DirectiveRunner::onUndef(const std::vector<Token>& tokens) {
  if (tokens.size() < 2 || tokens[1].kind != TokenKind::Identifier) {
    report(Severity::Warning, "directive-malformed", tokens.front().origin,
           "expected a macro name after #undef", kTolerated);
    return;
  }
  warnTrailing(tokens, 2, "undef");
  macros_.undefine(tokens[1].text);
}

void DirectiveRunner::onVersion(const std::vector<Token>& tokens) {
  int version = 0;
  if (tokens.size() > 1 && tokens[1].kind == TokenKind::Number) {
    const std::string& text = tokens[1].text;
    std::from_chars(text.data(), text.data() + text.size(), version);
  }
  if (version <= 0 || version > 999) {
    report(Severity::Error, "version-malformed", tokens.front().origin,
           "expected a number after #version, such as '#version 330 compatibility'");
    return;
  }
  if (stream_.version > 0) {
    report(Severity::Error, "version-repeated", tokens.front().origin,
           "a second active #version; exactly one is allowed");
    return;
  }
  stream_.version = version;
  stream_.profile = tokens.size() > 2 ? tokens[2].text : "";
  stream_.versionOrigin = tokens.front().origin;
}

void DirectiveRunner::onExtension(const std::vector<Token>& tokens) {
  const bool wellFormed = tokens.size() >= 4 && tokens[1].kind == TokenKind::Identifier &&
                          isPunctuator(tokens[2], ":") && tokens[3].kind == TokenKind::Identifier;
  if (!wellFormed) {
    report(Severity::Error, "directive-malformed", tokens.front().origin,
           "expected '#extension NAME : enable', 'require', 'warn' or 'disable'");
    return;
  }
  stream_.extensions.push_back({tokens[1].text, tokens[3].text, tokens.front().origin});
}

void DirectiveRunner::onError(const std::vector<Token>& tokens) {
  const std::string& name = tokens.front().text;
  report(name == "error" ? Severity::Error : Severity::Warning, fmt::format("directive-{}", name),
         tokens.front().origin, fmt::format("#{} {}", name, joinTokens(tokens, 1)));
}

void DirectiveRunner::onIgnored(const std::vector<Token>&) {}

// A comment of one line ends with it; one whose text begins below goes on to a blank line or directive.
void DirectiveRunner::reportUnclosedComment(const Origin& at) {
  report(Severity::Error, "comment-unclosed", at,
         "block comment is not closed: expected */ before the end");
  const std::string_view first = reader_.textOf(at);
  const bool oneLine = first.find_first_not_of("/* \t\r", std::size_t(at.column)) != first.npos;
  int end = at.line + 1;
  for (const FlatLine& line : source_.lines) {
    if (oneLine || line.site != at.site || line.line <= at.line) continue;
    const std::size_t text = line.text.find_first_not_of(" \t\r");
    if (text == std::string::npos || line.text[text] == '#') break;
    end = line.line + 1;
  }
  if (!diagnostics_.empty())
    diagnostics_.back().repair = LineEdit{locate(sites_, at).file, end, "*/"};
}

void DirectiveRunner::finish() {
  if (reader_.cutOff().site >= 0) {
    report(Severity::Error, "source-too-large", reader_.cutOff(),
           fmt::format("the stage has more than {} tokens or {} bytes outside of inactive "
                       "branches; what follows is left out",
                       limits::kStageTokens, limits::kStageReadBytes));
    return;
  }
  for (const Conditionals::Open& open : conditionals_.unclosed()) {
    if (reportInFiles()) continue;
    reportUnbalanced(
        open.at, fmt::format("#{} is not closed: expected #endif before the end", open.directive));
  }
  if (reader_.unclosedComment().site >= 0) {
    reportUnclosedComment(reader_.unclosedComment());
  }
}

}  // namespace orris
