#include <orris/pack/programs/attribute_types.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

struct Attribute {
  std::string_view name;
  bool terrainOnly;  ///< Iris converts it only where Sodium draws
  bool integers;     ///< int and ivec will do, too
};

constexpr std::array<Attribute, 3> kConverted{{
    {"mc_Entity", true, true},
    {"mc_midTexCoord", true, false},
    {"at_midBlock", false, false},
}};

const Attribute* convertedAttribute(const Token& token, const IrisProgram& program) {
  const auto* found = std::ranges::find_if(
      kConverted, [&](const Attribute& known) { return isIdentifier(token, known.name); });
  const bool converts =
      found != kConverted.end() &&
      (program.patch == IrisPatch::Terrain ||
       (program.patch == IrisPatch::Vanilla && !found->terrainOnly));
  return converts ? found : nullptr;
}

bool isConvertible(std::string_view type, const Attribute& attribute) {
  constexpr std::array<std::string_view, 4> kFloats = {"float", "vec2", "vec3", "vec4"};
  constexpr std::array<std::string_view, 4> kIntegers = {"int", "ivec2", "ivec3", "ivec4"};
  return std::ranges::count(kFloats, type) > 0 ||
         (attribute.integers && std::ranges::count(kIntegers, type) > 0);
}

Diagnostic unconvertible(const TokenStream& stream, const Token& name, const Token& type,
                         const Attribute& attribute) {
  return withEffect({.id = "attribute-type",
                     .at = locate(stream.sites, name.origin),
                     .message = fmt::format("Iris has no {} {}", type.text, attribute.name),
                     .includedFrom = includedFrom(stream.sites, name.origin.site),
                     .hint = attribute.integers ? "declare it as vec2, vec4 or float: x is the id"
                                                : "declare it as vec2, vec3 or vec4"},
                    Effect::RefusesProgram);
}

}  // namespace

void checkAttributeTypes(const TokenStream& stream, const IrisProgram& program,
                         Diagnostics& diagnostics) {
  const auto& tokens = stream.tokens;
  const bool named = std::ranges::any_of(
      tokens, [&](const Token& token) { return convertedAttribute(token, program) != nullptr; });
  if (!named) return;
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Declaration) continue;
    const Declaration declaration = parseDeclaration(tokens, item);
    for (const Declarator& declarator : declaration.declarators) {
      const Token& name = tokens[declarator.name];
      const Attribute* attribute = convertedAttribute(name, program);
      if (!attribute || isConvertible(tokens[declaration.type].text, *attribute)) continue;
      diagnostics.push_back(unconvertible(stream, name, tokens[declaration.type], *attribute));
    }
  }
}

}  // namespace orris
