#include <orris/glsl/syntax/fragment_outputs.h>

#include <charconv>
#include <optional>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/rewrite/text_code.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

constexpr std::uint32_t kAnyOutput = ~0u;

/// The bit of a literal; any for other tokens.
std::uint32_t outputBit(const std::vector<Token>& tokens, std::size_t i) {
  if (i >= tokens.size()) return kAnyOutput;
  const std::string& text = tokens[i].text;
  unsigned output = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), output);
  const bool literal = error == std::errc() && end == text.data() + text.size();
  return literal && output < 32 ? 1u << output : kAnyOutput;
}

/// gl_FragData[literal] at `i`.
std::uint32_t fragDataBit(const std::vector<Token>& tokens, std::size_t i) {
  if (!followedBy(tokens, i, "[")) return kAnyOutput;
  const std::size_t index = nextCode(tokens, nextCode(tokens, i));
  return index < tokens.size() && followedBy(tokens, index, "]") ? outputBit(tokens, index) : kAnyOutput;
}

std::uint32_t declaredBit(const std::vector<Token>& tokens, const Declaration& declaration) {
  const bool single = !declaration.isBlock && declaration.declarators.size() == 1 &&
                      !followedBy(tokens, declaration.type, "[") &&
                      !followedBy(tokens, declaration.declarators[0].name, "[");
  const std::size_t layout = declaration.qualifier(tokens, "layout");
  if (!single || layout == Declaration::npos) return kAnyOutput;
  for (std::size_t i = layout; i < declaration.type; i = nextCode(tokens, i))
    if (isIdentifier(tokens[i], "location") && followedBy(tokens, i, "="))
      return outputBit(tokens, nextCode(tokens, nextCode(tokens, i)));
  return kAnyOutput;
}

}  // namespace

std::uint32_t outputsOf(const std::string& fragmentText) {
  const std::vector<Token> tokens = codeTokens(fragmentText);
  std::uint32_t outputs = 0;
  for (std::size_t i = 0; i < tokens.size() && outputs != kAnyOutput; ++i) {
    if (isIdentifier(tokens[i], "gl_FragData")) outputs |= fragDataBit(tokens, i);
    if (isIdentifier(tokens[i], "gl_FragColor")) outputs = kAnyOutput;
  }
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Declaration) continue;
    const Declaration declaration = parseDeclaration(tokens, item);
    if (declaration.qualifier(tokens, "out") != Declaration::npos)
      outputs |= declaredBit(tokens, declaration);
  }
  return outputs;
}

}  // namespace orris
