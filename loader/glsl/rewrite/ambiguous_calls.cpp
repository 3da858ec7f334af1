#include <orris/glsl/rewrite/ambiguous_calls.h>

#include <fmt/format.h>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/rewrite/text_code.h>
#include <orris/glsl/tokens/text_edits.h>

namespace orris {
namespace {

/// A function whose parameters behind the first are of its type, or all scalars.
struct AmbiguousFunction {
  std::string_view name;
  int parameters;
  bool ofIntegers;  ///< has variants of ints and uints
};
constexpr AmbiguousFunction kAmbiguousFunctions[] = {{"clamp", 3, true}, {"mod", 2, false}};

struct ComponentType {
  std::string_view scalar, vector;
};
constexpr ComponentType kComponentTypes[] = {{"float", "vec"}, {"int", "ivec"}, {"uint", "uvec"}};

std::string variant(const AmbiguousFunction& function, std::string_view type, std::string_view others) {
  std::string parameters, arguments;
  for (int i = 1; i < function.parameters; ++i) {
    parameters += fmt::format(", {} p{}", others, i);
    arguments += fmt::format(", p{}", i);
  }
  return fmt::format("{0} orris_{1}({0} x{2}) {{ return {1}(x{3}); }} ", type, function.name, parameters, arguments);
}

/// One line, for floats first.
std::string variantsOf(const AmbiguousFunction& function) {
  std::string text;
  for (const ComponentType& type : kComponentTypes) {
    text += variant(function, type.scalar, type.scalar);
    for (int size = 2; size <= 4; ++size) {
      const std::string vector = fmt::format("{}{}", type.vector, size);
      text += variant(function, vector, type.scalar) + variant(function, vector, vector);
    }
    if (!function.ofIntegers) break;
  }
  return text;
}

/// NVIDIA words it so: error C1101: ambiguous overloaded function reference "clamp(int, float, float)".
bool isNamed(const AmbiguousFunction& function, const std::string& log) {
  return log.find(fmt::format("ambiguous overloaded function reference \"{}(", function.name)) != std::string::npos;
}

}  // namespace

std::optional<StageText> settleAmbiguousCalls(const StageText& stage, const std::string& log) {
  const std::vector<Token> tokens = codeTokens(stage.text.text);
  TextEdits edits;
  for (const AmbiguousFunction& function : kAmbiguousFunctions) {
    const std::string own = fmt::format("orris_{}", function.name);
    if (!isNamed(function, log) || stage.text.text.find(own) != std::string::npos) continue;
    edits.insert(offsetOf(tokens.front()), variantsOf(function));
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].text == function.name && followedBy(tokens, i, "(") && !precededBy(tokens, i, "."))
        edits.rename(offsetOf(tokens[i]), tokens[i].text.size(), own);
    }
  }
  if (edits.empty()) return std::nullopt;
  return StageText{stage.stage, edits.apply(stage.text)};
}

}  // namespace orris
