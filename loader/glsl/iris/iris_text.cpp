#include <orris/glsl/iris/iris_text.h>

#include <algorithm>
#include <array>

#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

struct IrisRule {
  void (*apply)(RewriteContext&);
  bool readsOutline;  ///< as in rewrite()
  bool common;        ///< Iris does it only where translatesCalls()
};

constexpr std::array<IrisRule, 15> kIrisRules = {{
    {ruleIrisExtensions, false, false},
    {ruleAttributeVarying, false, true},
    {ruleFloatLiterals, false, false},
    {ruleTextureFunctions, false, true},
    {ruleTextureName, false, false},
    {ruleReservedNames, false, false},
    {ruleStraySemicolon, true, false},
    {ruleUnusedFunctions, true, false},
    {ruleIrisConst, true, false},
    {ruleOutColor, true, false},
    {ruleIrisFragData, true, true},
    {ruleIrisEntity, true, false},
    {ruleIrisNames, true, false},
    {ruleHostNames, true, false},
    {ruleIrisVersion, false, false},
}};

// Core fullscreen and terrain programs pass without CommonTransformer. Where an extension raised the
// version here, what the author's version still has must not be lost.
bool translatesCalls(const RewriteContext& context) {
  const IrisPatch patch = context.iris->patch;
  if (patch != IrisPatch::Fullscreen && patch != IrisPatch::Terrain) return true;
  return !isCoreForIris(context.stream, *context.iris) || context.stream.version > context.packVersion;
}

}  // namespace

bool isCoreForIris(const TokenStream& stream, const IrisProgram& program) {
  constexpr int kFirstWithProfiles = 150;
  return program.lines || stream.profile == "core" ||
         (stream.profile.empty() && stream.version >= kFirstWithProfiles);
}

RewriteResult rewriteAsIris(TokenStream& stream, Stage stage, const IrisProgram& program,
                            std::span<const HostName> moreNames) {
  RewriteContext context(stream, stage);
  context.iris = &program;
  context.moreNames = moreNames;
  const bool hasOutline = bracesBalance(stream);
  for (const IrisRule& rule : kIrisRules) {
    if (!hasOutline && rule.readsOutline) continue;
    if (!rule.common || translatesCalls(context)) rule.apply(context);
  }
  return {.rules = std::move(context.rules)};
}

}  // namespace orris
