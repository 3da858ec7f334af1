// The directives of DirectiveRunner that only active branches run: macros, version, extensions.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <orris/glsl/preprocess/directive_runner.h>

namespace orris {

// Iris loads no pack with another one, as its parser (glsl-transformer) knows no more.
constexpr std::array<std::string_view, 17> kVersions = {"110", "120", "130", "140", "150", "330", "400", "410", "420",
                                                        "430", "440", "450", "460", "100", "300", "310", "320"};
constexpr std::array<std::string_view, 3> kProfiles = {"core", "compatibility", "es"};

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
  const Origin& at = tokens.front().origin;
  const std::string number = tokens.size() > 1 ? tokens[1].text : "";
  if (stream_.versionOrigin.line > 0) {
    refuse(Effect::RefusesPack, "version-repeated", at, "a second active #version; exactly one is allowed");
    return;
  }
  stream_.versionOrigin = at;
  if (std::ranges::find(kVersions, number) == kVersions.end()) {
    refuse(Effect::RefusesPack, "version-malformed", at,
           number.empty() ? "expected a version of GLSL after #version" : fmt::format("GLSL has no version {}", number),
           fmt::format("write '#version 330 compatibility', or one of {}", fmt::join(kVersions, ", ")));
    return;
  }
  std::from_chars(number.data(), number.data() + number.size(), stream_.version);
  if (tokens.size() == 2) return;
  if (std::ranges::find(kProfiles, tokens[2].text) == kProfiles.end()) {
    refuse(Effect::RefusesPack, "version-malformed", tokens[2].origin,
           fmt::format("expected 'core' or 'compatibility' after #version {}, found '{}'", number, tokens[2].text));
    return;
  }
  stream_.profile = tokens[2].text;
  if (tokens.size() == 3) return;
  refuse(Effect::RefusesPack, "version-malformed", tokens[3].origin,
         fmt::format("expected the end of the line after '#version {} {}', found '{}'", number, stream_.profile, tokens[3].text));
}

void DirectiveRunner::onExtension(const std::vector<Token>& tokens) {
  const bool wellFormed = tokens.size() >= 4 && tokens[1].kind == TokenKind::Identifier &&
                          isPunctuator(tokens[2], ":") && tokens[3].kind == TokenKind::Identifier;
  if (!wellFormed) {
    // Iris's grammar has this form; the driver that gets it does not.
    const bool parsed = tokens.size() == 2 && tokens[1].kind == TokenKind::Identifier;
    refuse(parsed ? Effect::RefusesProgram : Effect::RefusesPack, "directive-malformed", tokens.front().origin,
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
