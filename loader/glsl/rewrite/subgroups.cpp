#include <orris/glsl/rewrite/subgroups.h>

#include <set>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/rewrite/subgroup_code.h>
#include <orris/glsl/rewrite/text_code.h>
#include <orris/glsl/tokens/text_edits.h>

namespace orris {
namespace {

constexpr std::string_view kSubgroupExtensions[] = {"GL_KHR_shader_subgroup_",
                                                    "GL_EXT_shader_subgroup_extended_types"};

/// The lines that ask for what the driver lacks become blank.
void dropExtensions(const std::string& text, TextEdits& edits) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    for (const std::string_view extension : kSubgroupExtensions) {
      if (line.starts_with("#extension") && line.find(extension) != std::string_view::npos)
        edits.rename(at, end - at, "");
    }
    at = end + 1;
  }
}

/// Functions need the size of the work group: behind the last statement "layout(local_size_...) in;".
std::size_t behindLocalSize(const std::vector<Token>& tokens) {
  std::size_t place = offsetOf(tokens.front());
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!tokens[i].text.starts_with("local_size_")) continue;
    while (i < tokens.size() && !isPunctuator(tokens[i], ";")) ++i;
    if (i < tokens.size()) place = offsetOf(tokens[i]) + 1;
  }
  return place;
}

}  // namespace

std::optional<StageText> emulateSubgroups(const StageText& stage) {
  const bool exchange = stage.stage == Stage::Compute;
  const std::vector<Token> tokens = codeTokens(stage.text.text);
  TextEdits edits;
  std::set<std::string> names;
  bool found = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind != TokenKind::Identifier || precededBy(tokens, i, ".")) continue;
    const std::string_view variable = subgroupVariable(token.text, exchange);
    const bool call = followedBy(tokens, i, "(");
    if (!variable.empty()) edits.rename(offsetOf(token), token.text.size(), std::string(variable));
    if (call && isSubgroupFunction(token.text)) {
      names.insert(token.text);
      edits.rename(offsetOf(token), token.text.size(), "orris_" + token.text);
    } else if (exchange && call && token.text == "barrier") {
      edits.rename(offsetOf(token), token.text.size(), "orris_barrier");
    } else if (exchange && call && token.text == "main") {
      edits.rename(offsetOf(token), token.text.size(), "orris_main");
    }
    found |= !variable.empty();
  }
  if (!found && names.empty()) return std::nullopt;
  dropExtensions(stage.text.text, edits);
  const std::size_t place = exchange ? behindLocalSize(tokens) : offsetOf(tokens.front());
  edits.insert(place, " " + subgroupFunctions(names, exchange));
  if (exchange)
    edits.insert(stage.text.text.size(),
                 " void main() { orris_begin(); orris_main(); orris_barrier(); }");
  return StageText{stage.stage, edits.apply(stage.text)};
}

}  // namespace orris
