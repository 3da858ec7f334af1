// Rules about what stands at file scope: functions, constants, outputs, names the host provides.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <orris/glsl/iris/iris_names.h>
#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

using NameSet = std::unordered_set<std::string_view>;

// Names Iris adds by itself (VanillaCoreTransformer, EntityPatcher); contract: attributes.csv rows of
// the core profile, uniforms.csv group matrix and id.
constexpr HostName kHostNames[] = {
    {"entityId", "uniform int entityId;"},
    {"blockEntityId", "uniform int blockEntityId;"},
    {"currentRenderedItemId", "uniform int currentRenderedItemId;"},
    {"modelViewMatrix", "uniform mat4 modelViewMatrix;"},
    {"modelViewMatrixInverse", "uniform mat4 modelViewMatrixInverse;"},
    {"projectionMatrix", "uniform mat4 projectionMatrix;"},
    {"projectionMatrixInverse", "uniform mat4 projectionMatrixInverse;"},
    {"normalMatrix", "uniform mat3 normalMatrix;"},
    {"textureMatrix", "uniform mat4 textureMatrix;"},
    {"chunkOffset", "uniform vec3 chunkOffset;"},
    {"alphaTestRef", "uniform float alphaTestRef;"},
    {"vaPosition", "in vec3 vaPosition;", Stage::Vertex},
    {"vaColor", "in vec4 vaColor;", Stage::Vertex},
    {"vaUV0", "in vec2 vaUV0;", Stage::Vertex},
    {"vaUV1", "in ivec2 vaUV1;", Stage::Vertex},
    {"vaUV2", "in ivec2 vaUV2;", Stage::Vertex},
    {"vaNormal", "in vec3 vaNormal;", Stage::Vertex},
    {"mc_chunkFade", "in float mc_chunkFade;", Stage::Vertex},
};

// Names a file-scope item makes known to all functions.
void addGlobalNames(const std::vector<Token>& tokens, const OutlineItem& item, NameSet& names) {
  if (item.kind == OutlineItem::Kind::Empty) return;
  if (item.kind != OutlineItem::Kind::Declaration) {
    names.insert(tokens[item.name].text);
    return;
  }
  const Declaration declaration = parseDeclaration(tokens, item);
  for (const Declarator& declarator : declaration.declarators) {
    names.insert(tokens[declarator.name].text);
  }
  if (!declaration.isBlock || !declaration.declarators.empty()) return;
  for (std::size_t member : declaration.members) names.insert(tokens[member].text);
}

// Built-in functions whose result is no constant expression even for constant arguments.
bool isVaryingBuiltin(std::string_view name) {
  constexpr std::array<std::string_view, 9> kPrefixes = {"texture",       "texel", "image",
                                                         "atomic",        "dFd",   "fwidth",
                                                         "interpolateAt", "noise", "ftransform"};
  return std::any_of(kPrefixes.begin(), kPrefixes.end(),
                     [name](std::string_view prefix) { return name.starts_with(prefix); });
}

class ConstantChecker {
 public:
  explicit ConstantChecker(const std::vector<Token>& tokens) : tokens_(tokens) {}

  void addVariable(std::string_view name) { notConstant_.insert(name); }
  const NameSet& notConstant() const { return notConstant_; }
  NameSet& notConstant() { return notConstant_; }

  bool isConstant(const Declarator& declarator) const {
    for (std::size_t i = declarator.initBegin; i < declarator.initEnd; ++i) {
      if (tokens_[i].kind != TokenKind::Identifier || precededBy(tokens_, i, ".")) continue;
      const std::string_view name = tokens_[i].text;
      if (notConstant_.contains(name)) return false;
      const bool call = followedBy(tokens_, i, "(");
      if (call && (isVaryingBuiltin(name) || isUnfoldedBuiltin(name))) return false;
      const bool builtinVariable =
          name.starts_with("gl_") && !name.starts_with("gl_Max") && !name.starts_with("gl_Min");
      if (builtinVariable) return false;
    }
    return true;
  }

 private:
  const std::vector<Token>& tokens_;
  NameSet notConstant_;
};

bool isOutColorName(std::string_view name) {
  return name.size() == 9 && name.starts_with("outColor") && name[8] >= '0' && name[8] <= '7';
}

}  // namespace

bool isUnfoldedBuiltin(std::string_view name) {
  constexpr std::array<std::string_view, 16> kNames = {
      "acosh",   "asinh",   "atanh",     "bitCount",       "cosh",  "determinant",
      "findLSB", "findMSB", "fma",       "inverse",        "ldexp", "matrixCompMult",
      "sinh",    "tanh",    "transpose", "uintBitsToFloat"};
  constexpr std::array<std::string_view, 5> kPrefixes = {"bitfield", "floatBitsTo", "intBitsTo",
                                                         "pack", "unpack"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end() ||
         std::any_of(kPrefixes.begin(), kPrefixes.end(),
                     [name](std::string_view prefix) { return name.starts_with(prefix); });
}

// GLSL 4.50 allows an empty declaration, but glslang does not.
void ruleStraySemicolon(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  TokenEdits edits;
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Empty) continue;
    context.fired("stray-semicolon", tokens[item.begin].origin);
    edits.erase(item.begin, item.end);
  }
  edits.apply(tokens);
}

// Iris: CompatibilityTransformer removes functions whose name occurs once, so packs leave functions
// behind that could not compile.
void ruleUnusedFunctions(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  std::unordered_map<std::string_view, int> mentions;
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::Identifier) ++mentions[token.text];
  }
  TokenEdits edits;
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Function || tokens[item.name].text == "main") continue;
    const std::string& name = tokens[item.name].text;
    if (mentions[name] > 1) continue;
    if (context.iris && isIrisFunction(*context.iris, context.stage, name)) continue;
    context.fired("unused-functions", tokens[item.name].origin);
    if (context.iris) {
      // Iris has parsed it by then, so that it is judged for itself.
      for (std::size_t i = item.begin; i < item.end; ++i) tokens[i].unused = true;
    } else {
      edits.erase(item.begin, item.end);
    }
  }
  edits.apply(tokens);
}

// A global constant needs a constant initialiser; lax drivers accept others, and packs use that.
void ruleGlobalConst(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  const std::vector<OutlineItem> items = outline(tokens);
  ConstantChecker checker(tokens);
  TokenEdits edits;
  for (const OutlineItem& item : items) {
    if (item.kind != OutlineItem::Kind::Declaration) {
      addGlobalNames(tokens, item, checker.notConstant());
      continue;
    }
    const Declaration declaration = parseDeclaration(tokens, item);
    const std::size_t keyword = declaration.qualifier(tokens, "const");
    const bool constant =
        keyword != Declaration::npos &&
        std::all_of(declaration.declarators.begin(), declaration.declarators.end(),
                    [&checker](const Declarator& d) { return checker.isConstant(d); });
    if (constant) continue;
    addGlobalNames(tokens, item, checker.notConstant());
    if (keyword == Declaration::npos) continue;
    context.fired("global-const", tokens[keyword].origin);
    edits.erase(keyword, keyword + 1);
  }
  edits.apply(tokens);
}

// Iris binds outColorN to location N (contract/README "Profiles and the patcher").
void ruleOutColor(RewriteContext& context) {
  if (context.stage != Stage::Fragment) return;
  auto& tokens = context.stream.tokens;
  TokenEdits edits;
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Declaration) continue;
    const Declaration declaration = parseDeclaration(tokens, item);
    if (declaration.declarators.size() != 1) continue;
    const std::string& name = tokens[declaration.declarators.front().name].text;
    const bool wanted = isOutColorName(name) &&
                        declaration.qualifier(tokens, "out") != Declaration::npos &&
                        declaration.qualifier(tokens, "layout") == Declaration::npos;
    if (!wanted) continue;
    context.fired("out-color", tokens[item.begin].origin);
    std::vector<Token> layout = hostTokens("layout(location = " + name.substr(8) + ")", false);
    layout.front().newlinesBefore = tokens[item.begin].newlinesBefore;
    tokens[item.begin].newlinesBefore = 0;
    tokens[item.begin].spaceBefore = true;
    edits.insertBefore(item.begin, std::move(layout));
  }
  edits.apply(tokens);
}

void ruleHostNames(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  std::unordered_map<std::string_view, Origin> used;
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::Identifier) used.emplace(token.text, token.origin);
  }
  std::vector<const HostName*> wanted;
  // What Iris declares depends on the program, so rule iris-names does it.
  const auto always = context.iris ? std::span<const HostName>() : std::span(kHostNames);
  for (const auto names : {always, context.moreNames}) {
    for (const HostName& name : names) {
      const bool possible = !name.stage || *name.stage == context.stage;
      if (possible && used.contains(name.name)) wanted.push_back(&name);
    }
  }
  if (wanted.empty()) return;
  NameSet declared;
  for (const OutlineItem& item : outline(tokens)) addGlobalNames(tokens, item, declared);
  std::vector<Token> added;
  for (const HostName* name : wanted) {
    if (declared.contains(name->name)) continue;
    context.fired("host-names", used.at(name->name));
    const std::vector<Token> declaration = hostTokens(name->declaration, true);
    added.insert(added.end(), declaration.begin(), declaration.end());
  }
  if (added.empty()) return;
  if (!tokens.empty()) tokens.front().newlinesBefore = std::max(tokens.front().newlinesBefore, 1);
  tokens.insert(tokens.begin(), added.begin(), added.end());
}

}  // namespace orris
