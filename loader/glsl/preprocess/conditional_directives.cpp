// The directives of DirectiveRunner that open and close branches: #if and its kin.
#include <fmt/format.h>

#include <orris/glsl/preprocess/condition.h>
#include <orris/glsl/preprocess/directive_runner.h>

namespace orris {

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

}  // namespace orris
