#include <orris/glsl/preprocess/directive_runner.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include <orris/core/limits.h>
#include <orris/core/message_limits.h>
#include <orris/glsl/syntax/directive_slip.h>

namespace orris {
namespace {

// A broken source can be wrong on every line; more than this says nothing new.
constexpr std::size_t kMaxReports = 100;

std::size_t firstCode(const std::vector<Token>& tokens) {
  std::size_t i = 0;
  while (i < tokens.size() && tokens[i].kind == TokenKind::Comment) ++i;
  return i;
}

}  // namespace

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
  diagnostics_.push_back({.severity = severity,
                          .id = std::move(id),
                          .at = locate(sites_, at),
                          .message = std::move(message),
                          .includedFrom = includedFrom(sites_, at.site),
                          .sourceLine = quotedLine(reader_.textOf(at), at.column),
                          .hint = std::move(hint)});
}

void DirectiveRunner::refuse(Effect effect, std::string id, const Origin& at, std::string message, std::string hint) {
  const std::size_t before = diagnostics_.size();
  report(Severity::Error, std::move(id), at, std::move(message), std::move(hint));
  if (diagnostics_.size() > before) diagnostics_.back() = withEffect(std::move(diagnostics_.back()), effect);
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
         name.starts_with("if") && (isPunctuator(tokens[from], "||") || isPunctuator(tokens[from], "&&"))
             ? fmt::format("#{} takes one name: write #if with defined(), {} between", name, tokens[from].text)
             : "some hosts refuse this; put it into a comment");
}

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
