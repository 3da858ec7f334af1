#include <orris/glsl/rewrite/rewrite.h>

#include <algorithm>
#include <array>

#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

struct StageNames {
  Stage stage;
  const char* extension;
  const char* name;
};

constexpr std::array<StageNames, 6> kStages = {{
    {Stage::Vertex, "vsh", "vertex"},
    {Stage::TessControl, "tcs", "tessellation control"},
    {Stage::TessEvaluation, "tes", "tessellation evaluation"},
    {Stage::Geometry, "gsh", "geometry"},
    {Stage::Fragment, "fsh", "fragment"},
    {Stage::Compute, "csh", "compute"},
}};

struct Rule {
  void (*apply)(RewriteContext&);
  bool readsOutline;  ///< it would take what follows a missing brace for something else
};

// In this order: names are settled before the rules that read declarations, and the version is set
// last because the others ask for the pack's.
constexpr std::array<Rule, 17> kRules = {{
    {ruleExtensions, false},
    {ruleAttributeVarying, false},
    {ruleFloatLiterals, false},
    {ruleTextureFunctions, false},
    {ruleTextureName, false},
    {ruleReservedNames, false},
    {ruleStraySemicolon, true},
    {ruleUnusedFunctions, true},
    {ruleGlobalConst, true},
    {ruleMixBool, true},
    {ruleZeroInit, true},
    {ruleEntityId, false},
    {ruleSharedBounds, true},
    {ruleOutColor, true},
    {ruleFragData, true},
    {ruleHostNames, true},
    {ruleVersion, false},
}};

bool writesFragData(const TokenStream& stream, Stage stage) {
  if (stage != Stage::Fragment) return false;
  return std::any_of(stream.tokens.begin(), stream.tokens.end(), [](const Token& token) {
    return isIdentifier(token, "gl_FragData") || isIdentifier(token, "gl_FragColor");
  });
}

}  // namespace

const char* stageExtension(Stage stage) {
  return kStages[static_cast<std::size_t>(stage)].extension;
}

const char* stageName(Stage stage) { return kStages[static_cast<std::size_t>(stage)].name; }

RewriteResult rewrite(TokenStream& stream, Stage stage, std::span<const HostName> moreNames) {
  RewriteContext context(stream, stage);
  context.moreNames = moreNames;
  const bool hasOutline = bracesBalance(stream);
  for (const Rule& rule : kRules) {
    if (hasOutline || !rule.readsOutline) rule.apply(context);
  }
  RewriteResult result;
  result.writesFragData = writesFragData(stream, stage) || context.hasFired("frag-data");
  result.rules = std::move(context.rules);
  return result;
}

}  // namespace orris
