// Rules that rename: keywords, functions and variables that newer GLSL calls otherwise.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

// Extensions that core GLSL 4.50 contains, once texture-functions has renamed their functions.
// glslang knows some of them not at all and refuses the line; Mesa wants such lines at the top only.
constexpr std::array<std::string_view, 19> kCoreExtensions = {
    "GL_EXT_gpu_shader4",
    "GL_ARB_shader_texture_lod",
    "GL_EXT_shader_texture_lod",
    "GL_ARB_texture_gather",
    "GL_ARB_explicit_attrib_location",
    "GL_ARB_explicit_uniform_location",
    "GL_ARB_gpu_shader5",
    "GL_ARB_shading_language_420pack",
    "GL_ARB_shading_language_packing",
    "GL_ARB_shader_bit_encoding",
    "GL_ARB_shader_image_load_store",
    "GL_ARB_shader_image_size",
    "GL_ARB_shader_storage_buffer_object",
    "GL_ARB_compute_shader",
    "GL_ARB_texture_query_levels",
    "GL_ARB_texture_query_lod",
    "GL_ARB_uniform_buffer_object",
    "GL_ARB_conservative_depth",
    "GL_ARB_derivative_control",
};

enum class Wrap { None, Vec4 };

struct TextureFunction {
  std::string_view legacy;
  std::string_view modern;
  Wrap wrap = Wrap::None;
  bool iris = false;  ///< Iris renames it, too
};

// contract/README "Calls renamed"; beyond it the other names of GLSL 1.20, EXT_gpu_shader4 and
// ARB_shader_texture_lod that GLSL 4.50 offers under one name.
constexpr TextureFunction kTextureFunctions[] = {
    {"texture1D", "texture"},
    {"texture2D", "texture", Wrap::None, true},
    {"texture3D", "texture", Wrap::None, true},
    {"textureCube", "texture"},
    {"texture2DRect", "texture"},
    {"texture1DArray", "texture"},
    {"texture2DArray", "texture"},
    {"texture1DLod", "textureLod"},
    {"texture2DLod", "textureLod", Wrap::None, true},
    {"texture3DLod", "textureLod", Wrap::None, true},
    {"textureCubeLod", "textureLod"},
    {"texture2DLodEXT", "textureLod"},
    {"texture2DArrayLod", "textureLod"},
    {"texture1DProj", "textureProj"},
    {"texture2DProj", "textureProj", Wrap::None, true},
    {"texture3DProj", "textureProj", Wrap::None, true},
    {"texture1DProjLod", "textureProjLod"},
    {"texture2DProjLod", "textureProjLod"},
    {"texture3DProjLod", "textureProjLod"},
    {"texture1DGrad", "textureGrad"},
    {"texture2DGrad", "textureGrad", Wrap::None, true},
    {"texture3DGrad", "textureGrad", Wrap::None, true},
    {"textureCubeGrad", "textureGrad"},
    {"texture1DGradARB", "textureGrad"},
    {"texture2DGradARB", "textureGrad", Wrap::None, true},
    {"texture3DGradARB", "textureGrad"},
    {"textureCubeGradARB", "textureGrad"},
    {"texture2DGradEXT", "textureGrad"},
    {"texture2DProjGradARB", "textureProjGrad"},
    {"texelFetch1D", "texelFetch"},
    {"texelFetch2D", "texelFetch", Wrap::None, true},
    {"texelFetch3D", "texelFetch", Wrap::None, true},
    {"texelFetch2DArray", "texelFetch"},
    {"texelFetchBuffer", "texelFetch"},
    {"textureSize1D", "textureSize"},
    {"textureSize2D", "textureSize", Wrap::None, true},
    {"textureSize3D", "textureSize"},
    {"textureSizeCube", "textureSize"},
    {"shadow1D", "texture", Wrap::Vec4},
    {"shadow2D", "texture", Wrap::Vec4, true},
    {"shadow2DLod", "textureLod", Wrap::Vec4, true},
    {"shadow2DProj", "textureProj", Wrap::Vec4},
};

const TextureFunction* textureFunction(std::string_view name) {
  static const std::unordered_map<std::string_view, const TextureFunction*> kByName = [] {
    std::unordered_map<std::string_view, const TextureFunction*> map;
    for (const TextureFunction& function : kTextureFunctions)
      map.emplace(function.legacy, &function);
    return map;
  }();
  const auto found = kByName.find(name);
  return found == kByName.end() ? nullptr : found->second;
}

struct ReservedWord {
  std::string_view word;
  int since;  // first GLSL version that reserves it
};

constexpr ReservedWord kReservedWords[] = {
    {"sample", 1000},  {"patch", 400},     {"subroutine", 400},    {"precise", 400},
    {"buffer", 430},   {"shared", 430},    {"coherent", 420},      {"restrict", 420},
    {"readonly", 420}, {"writeonly", 420}, {"resource", 420},      {"atomic_uint", 420},
    {"smooth", 130},   {"flat", 130},      {"noperspective", 130}, {"layout", 140},
    {"case", 130},     {"uint", 130},      {"common", 130},        {"partition", 130},
    {"active", 130},   {"filter", 130},    {"superp", 130},
};

// 0 for a word that is not reserved.
int reservedSince(std::string_view word) {
  static const std::unordered_map<std::string_view, int> kByWord = [] {
    std::unordered_map<std::string_view, int> map;
    for (const ReservedWord& reserved : kReservedWords) map.emplace(reserved.word, reserved.since);
    return map;
  }();
  const auto found = kByWord.find(word);
  return found == kByWord.end() ? 0 : found->second;
}

// "vec4 texture2D(": a type before the name makes it a definition or prototype, not a call.
bool isDeclaredHere(const std::vector<Token>& tokens, std::size_t name) {
  const std::size_t before = previousCode(tokens, name);
  if (before >= tokens.size() || tokens[before].kind != TokenKind::Identifier) return false;
  return tokens[before].text != "return" && tokens[before].text != "else";
}

// "float sample =": a type before the name and the rest of a declarator after it.
bool isNameDeclaredHere(const std::vector<Token>& tokens, std::size_t name) {
  const std::size_t before = previousCode(tokens, name);
  if (!isDeclaredHere(tokens, name) || isQualifier(tokens[before].text)) return false;
  constexpr std::array<std::string_view, 6> kAfterName = {";", ",", "=", ")", "[", "("};
  return std::any_of(kAfterName.begin(), kAfterName.end(), [&tokens, name](std::string_view text) {
    return followedBy(tokens, name, text);
  });
}

void rename(RewriteContext& context, std::string_view rule, Token& token, std::string_view name) {
  context.fired(rule, token.origin);
  token.text = name;
}

// Two samplers that are now both gtexture must not be declared twice.
void keepOneSampler(std::vector<Token>& tokens) {
  TokenEdits edits;
  bool found = false;
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Declaration) continue;
    const Declaration declaration = parseDeclaration(tokens, item);
    if (declaration.declarators.size() != 1) continue;
    if (tokens[declaration.declarators.front().name].text != "gtexture") continue;
    if (found) edits.erase(item.begin, item.end);
    found = true;
  }
  edits.apply(tokens);
}

}  // namespace

void ruleExtensions(RewriteContext& context) {
  std::erase_if(context.stream.extensions, [&context](const TokenStream::Extension& extension) {
    const bool core = std::find(kCoreExtensions.begin(), kCoreExtensions.end(), extension.name) !=
                      kCoreExtensions.end();
    if (core) context.fired("extensions", extension.origin);
    return core;
  });
}

void ruleAttributeVarying(RewriteContext& context) {
  if (context.stage != Stage::Vertex && context.stage != Stage::Fragment) return;
  const std::string_view varying = context.stage == Stage::Vertex ? "out" : "in";
  for (Token& token : context.stream.tokens) {
    if (isIdentifier(token, "attribute")) rename(context, "attribute-varying", token, "in");
    if (isIdentifier(token, "varying")) rename(context, "attribute-varying", token, varying);
  }
}

void ruleTextureFunctions(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  std::unordered_set<std::string> ownNames;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::Identifier && textureFunction(tokens[i].text) &&
        followedBy(tokens, i, "(") && isDeclaredHere(tokens, i)) {
      ownNames.insert(tokens[i].text);
    }
  }
  TokenEdits edits;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::Identifier) continue;
    const TextureFunction* function = textureFunction(tokens[i].text);
    if (!function || ownNames.contains(tokens[i].text) || !followedBy(tokens, i, "(")) continue;
    if (context.iris && !function->iris) continue;
    rename(context, "texture-functions", tokens[i], function->modern);
    const std::size_t close = closingBracket(tokens, nextCode(tokens, i));
    if (function->wrap != Wrap::Vec4 || close >= tokens.size()) continue;
    std::vector<Token> open = hostTokens("vec4(", false);
    for (Token& token : open) token.origin = tokens[i].origin;
    std::swap(open.front().spaceBefore, tokens[i].spaceBefore);
    std::swap(open.front().newlinesBefore, tokens[i].newlinesBefore);
    std::vector<Token> shut = hostTokens(")", false);
    shut.front().origin = tokens[close].origin;
    edits.insertBefore(i, std::move(open));
    edits.insertBefore(close + 1, std::move(shut));
  }
  edits.apply(tokens);
}

// A sampler named `texture` hides the function of that name. As in Iris it becomes gtexture, and so
// does gcolor; any other variable of that name gets one of the host's.
void ruleTextureName(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  std::unordered_set<std::string> samplers;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::Identifier || !tokens[i].text.starts_with("sampler")) continue;
    const std::size_t before = previousCode(tokens, i);
    const std::size_t name = nextCode(tokens, i);
    if (before < tokens.size() && isIdentifier(tokens[before], "uniform") && name < tokens.size()) {
      samplers.insert(tokens[name].text);
    }
  }
  const auto target = [&samplers](const std::string& name) -> std::string_view {
    if (samplers.contains(name)) return "gtexture";
    return name == "texture" ? "orris_texture" : "";
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!isIdentifier(tokens[i], "texture") && !isIdentifier(tokens[i], "gcolor")) continue;
    const std::string_view name = target(tokens[i].text);
    if (!name.empty() && !followedBy(tokens, i, "(")) {
      rename(context, "texture-name", tokens[i], name);
    }
  }
  const auto declares = [&samplers](const char* name) { return samplers.contains(name) ? 1 : 0; };
  if (declares("texture") + declares("gcolor") + declares("gtexture") > 1) keepOneSampler(tokens);
}

/// "float noise2(vec2 p) {": drivers let an author's function stand in place of the old built-in of that
/// name, glslang wants it to return what that did.
bool isOwnNoise(const std::vector<Token>& tokens, std::size_t index) {
  const std::string& name = tokens[index].text;
  if (name.size() != 6 || !name.starts_with("noise") || name.back() < '1' || name.back() > '4')
    return false;
  const std::size_t type = previousCode(tokens, index);
  return type < tokens.size() && tokens[type].kind == TokenKind::Identifier &&
         tokens[type].text != "return" && tokens[type].text != "else" &&
         followedBy(tokens, index, "(");
}

// A word that newer GLSL reserves, used as a name: "float sample = ...". Where it stands before
// another word it is the qualifier and stays. Iris renames `sample` only, and sends the author's
// version, which knows the others as names.
void ruleReservedNames(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::Identifier || names.contains(tokens[i].text)) continue;
    if (context.iris && isOwnNoise(tokens, i)) names.insert(tokens[i].text);
    if (context.iris && tokens[i].text != "sample") continue;
    if (context.packVersion < reservedSince(tokens[i].text) && isNameDeclaredHere(tokens, i)) {
      names.insert(tokens[i].text);
    }
  }
  if (names.empty()) return;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::Identifier || !names.contains(tokens[i].text)) continue;
    const std::size_t next = nextCode(tokens, i);
    if (next < tokens.size() && tokens[next].kind == TokenKind::Identifier) continue;
    rename(context, "reserved-names", tokens[i], "orris_" + tokens[i].text);
  }
}

// Iris always yields core GLSL; a compatibility context lets us keep the fixed-function names.
void ruleVersion(RewriteContext& context) {
  TokenStream& stream = context.stream;
  const bool compute = context.stage == Stage::Compute;
  const int version = compute ? std::max(context.packVersion, 430) : 450;
  const std::string profile = compute ? stream.profile : "compatibility";
  if (version == stream.version && profile == stream.profile) return;
  context.fired("version", stream.versionOrigin);
  stream.version = version;
  stream.profile = profile;
}

}  // namespace orris
