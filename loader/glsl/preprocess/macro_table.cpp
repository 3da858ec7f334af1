#include <orris/glsl/preprocess/macro_table.h>

#include <fmt/format.h>

#include <algorithm>

namespace orris {
namespace {

// Reads "(a, b, ...)" from tokens[i], the "(". Returns what is wrong, "" when nothing is.
std::string readParameters(const std::vector<Token>& tokens, std::size_t& i, Macro& macro) {
  const std::string unclosed =
      fmt::format("parameter list of macro '{}' is not closed", macro.name);
  ++i;
  if (i < tokens.size() && isPunctuator(tokens[i], ")")) {
    ++i;
    return "";
  }
  while (i < tokens.size()) {
    if (isPunctuator(tokens[i], "...")) {
      macro.variadic = true;
      macro.parameters.push_back("__VA_ARGS__");
    } else if (tokens[i].kind == TokenKind::Identifier) {
      macro.parameters.push_back(tokens[i].text);
    } else {
      return fmt::format("expected a parameter name of macro '{}', found '{}'", macro.name,
                         tokens[i].text);
    }
    if (++i >= tokens.size()) return unclosed;
    const bool closes = isPunctuator(tokens[i], ")");
    if (!closes && (macro.variadic || !isPunctuator(tokens[i], ","))) {
      return fmt::format("expected ',' or ')' in the parameter list of macro '{}', found '{}'",
                         macro.name, tokens[i].text);
    }
    ++i;
    if (closes) return "";
  }
  return unclosed;
}

int parameterIndex(const Macro& macro, const Token& token) {
  if (token.kind != TokenKind::Identifier) return Macro::Plain;
  const auto& names = macro.parameters;
  const auto found = std::find(names.begin(), names.end(), token.text);
  return found == names.end() ? static_cast<int>(Macro::Plain)
                              : static_cast<int>(found - names.begin());
}

void assignRoles(Macro& macro) {
  macro.roles.resize(macro.body.size());
  for (std::size_t i = 0; i < macro.body.size(); ++i) {
    const Token& token = macro.body[i];
    macro.roles[i] = parameterIndex(macro, token);
    if (i > 0 && i + 1 < macro.body.size() && isPunctuator(token, "##")) {
      macro.roles[i] = Macro::Paste;
    } else if (i + 1 < macro.body.size() && isPunctuator(token, "#") &&
               parameterIndex(macro, macro.body[i + 1]) >= 0) {
      macro.roles[i] = Macro::Stringify;
    }
  }
}

}  // namespace

MacroTable::MacroTable(const MacroDefinitions& environment, NameWatch* watch) : watch_(watch) {
  const std::size_t watched = watch ? watch->names.size() : 0;
  byName_.reserve(environment.size() * 2 + watched);
  for (std::size_t i = 0; i < watched; ++i) {
    byName_[watch->names[i]].watched = static_cast<int>(i);
  }
  for (const auto& [name, body] : environment) {
    Macro& macro = all_.emplace_back();
    macro.name = name;
    if (!body.empty()) macro.body = tokenize(body);
    for (Token& token : macro.body) token.origin = {};
    assignRoles(macro);
    byName_[name].macro = &macro;
  }
}

std::string MacroTable::define(const std::vector<Token>& tokens, const Origin& origin) {
  if (tokens.empty()) return "expected a macro name after #define";
  const Token& name = tokens.front();
  if (name.kind != TokenKind::Identifier || name.text == "defined") {
    return fmt::format("'{}' cannot be the name of a macro", name.text);
  }
  Macro macro;
  macro.name = name.text;
  macro.origin = origin;
  std::size_t i = 1;
  if (i < tokens.size() && isPunctuator(tokens[i], "(") && !tokens[i].spaceBefore) {
    macro.functionLike = true;
    std::string problem = readParameters(tokens, i, macro);
    if (!problem.empty()) return problem;
  }
  macro.body.assign(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end());
  assignRoles(macro);
  Macro& kept = all_.emplace_back(std::move(macro));
  byName_[kept.name].macro = &kept;
  return "";
}

void MacroTable::undefine(std::string_view name) {
  const auto found = byName_.find(name);
  if (found != byName_.end()) found->second.macro = nullptr;
}

Macro* MacroTable::find(std::string_view name) {
  const auto found = byName_.find(name);
  if (found == byName_.end()) return nullptr;
  const Entry& entry = found->second;
  if (entry.watched >= 0) watch_->uses[static_cast<std::size_t>(entry.watched)] |= purpose_;
  return entry.macro;
}

}  // namespace orris
