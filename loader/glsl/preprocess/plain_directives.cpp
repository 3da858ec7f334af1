// The directives of DirectiveRunner that only active branches run: macros, version, extensions.
#include <fmt/format.h>

#include <charconv>

#include <orris/glsl/preprocess/directive_runner.h>

namespace orris {

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

}  // namespace orris
