// The rule that puts Iris's attributes and uniforms in place of the names of old GLSL.
#include <algorithm>
#include <charconv>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <orris/glsl/iris/iris_names.h>
#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

constexpr std::string_view kRuleIrisNames = "iris-names";
constexpr std::string_view kTextureMatrix = "gl_TextureMatrix";

/// Tokens of names that stand in declarations at file scope, and the names.
struct Declared {
  std::unordered_set<std::size_t> tokens;
  std::unordered_set<std::string_view> names;
};

Declared declaredIn(const std::vector<Token>& tokens) {
  Declared declared;
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind == OutlineItem::Kind::Empty) continue;
    if (item.kind != OutlineItem::Kind::Declaration) {
      declared.tokens.insert(item.name);
      declared.names.insert(tokens[item.name].text);
      continue;
    }
    for (const Declarator& declarator : parseDeclaration(tokens, item).declarators) {
      declared.tokens.insert(declarator.name);
      declared.names.insert(tokens[declarator.name].text);
    }
  }
  return declared;
}

class IrisNaming {
 public:
  explicit IrisNaming(RewriteContext& context) : context_(context), tokens_(context.stream.tokens) {
    const IrisProgram& program = *context.iris;
    const bool core = isCoreForIris(context.stream, program);
    for (const IrisName& name : irisNames(program, context.stage, core))
      known_.emplace(name.name, name);
    lastMatrix_ = lastTextureMatrix(program, core);
  }

  void run() {
    std::vector<std::size_t> uses;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind != TokenKind::Identifier || precededBy(tokens_, i, ".")) continue;
      if (known_.contains(tokens_[i].text)) uses.push_back(i);
      if (lastMatrix_ && tokens_[i].text == kTextureMatrix) replaceMatrix(i);
    }
    if (!uses.empty()) declared_ = declaredIn(tokens_);
    // An attribute of the author's own has another type, perhaps.
    if (declared_.names.contains("mc_midTexCoord")) known_.erase("gl_MultiTexCoord3");
    for (const std::size_t use : uses) replace(use);
    edits_.apply(tokens_);
    if (declarations_.empty()) return;
    tokens_.front().newlinesBefore = std::max(tokens_.front().newlinesBefore, 1);
    tokens_.insert(tokens_.begin(), declarations_.begin(), declarations_.end());
  }

 private:
  void replace(std::size_t use) {
    const auto found = known_.find(tokens_[use].text);
    if (found == known_.end()) return;
    const IrisName& name = found->second;
    if (declared_.tokens.contains(use)) {
      if (name.taken || isKeptMatrix(use)) declare(name.declaration);
      return;
    }
    if (name.replacement.empty() && declared_.names.contains(name.name)) return;
    context_.fired(kRuleIrisNames, tokens_[use].origin);
    declare(name.declaration);
    if (!name.replacement.empty()) tokens_[use].text = name.replacement;
  }

  // Where Sodium draws, Iris takes "uniform mat4 modelViewMatrix;" away for a declaration of its own; one
  // that it shares with other names stays beside that. Iris: SodiumCoreTransformer.
  bool isKeptMatrix(std::size_t use) const {
    const std::string& name = tokens_[use].text;
    if (context_.iris->patch != IrisPatch::Terrain ||
        (name != "modelViewMatrix" && name != "projectionMatrix"))
      return false;
    const std::size_t type = previousCode(tokens_, use);
    const bool alone = type < tokens_.size() && isIdentifier(tokens_[type], "mat4") &&
                       isIdentifier(tokens_[previousCode(tokens_, type)], "uniform") &&
                       followedBy(tokens_, use, ";");
    return !alone;
  }

  // "gl_TextureMatrix[1]"; another index stays, which core GLSL knows as little.
  void replaceMatrix(std::size_t use) {
    const std::size_t open = nextCode(tokens_, use);
    const std::size_t index = nextCode(tokens_, open), close = nextCode(tokens_, index);
    if (close >= tokens_.size() || !isPunctuator(tokens_[open], "[") ||
        !isPunctuator(tokens_[close], "]"))
      return;
    const std::string& text = tokens_[index].text;
    int number = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 0 ||
        number > *lastMatrix_)
      return;
    context_.fired(kRuleIrisNames, tokens_[use].origin);
    tokens_[use].text = "mat4(1.0)";
    edits_.erase(open, close + 1);
  }

  void declare(std::string_view declaration) {
    if (declaration.empty() || !made_.insert(declaration).second) return;
    const std::vector<Token> one = hostTokens(declaration, true);
    declarations_.insert(declarations_.end(), one.begin(), one.end());
  }

  RewriteContext& context_;
  std::vector<Token>& tokens_;
  std::unordered_map<std::string_view, IrisName> known_;
  std::optional<int> lastMatrix_;
  Declared declared_;
  TokenEdits edits_;
  std::set<std::string_view> made_;
  std::vector<Token> declarations_;
};

bool isNumberType(std::string_view type) {
  constexpr std::string_view kTypes[] = {"float", "vec2",  "vec3",  "vec4",
                                         "int",   "ivec2", "ivec3", "ivec4"};
  return std::ranges::find(kTypes, type) != std::end(kTypes);
}

}  // namespace

// Sodium's vertices hold the id as a uint. Iris: SodiumTransformer.replaceMCEntity, which makes all types
// of it that it knows as the author wrote them but int. In compatibility GLSL it does so in each stage:
// a fragment stage gets an integer input without flat, which no driver takes.
void ruleIrisEntity(RewriteContext& context) {
  const bool fragment = context.stage == Stage::Fragment;
  if (context.iris->patch != IrisPatch::Terrain || (context.stage != Stage::Vertex && !fragment))
    return;
  if (fragment && isCoreForIris(context.stream, *context.iris)) return;
  auto& tokens = context.stream.tokens;
  const auto isEntity = [](const Token& token) { return isIdentifier(token, "mc_Entity"); };
  if (std::ranges::none_of(tokens, isEntity)) return;
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Declaration) continue;
    const Declaration found = parseDeclaration(tokens, item);
    if (found.declarators.size() != 1 || found.qualifiers.empty() ||
        !isEntity(tokens[found.declarators[0].name]))
      continue;
    const std::string type = tokens[found.type].text;
    if (fragment ? !isNumberType(type) : type != "int") continue;
    const Origin place = tokens[found.declarators[0].name].origin;
    context.fired("iris-entity", place);
    const int newlines = tokens[item.begin].newlinesBefore;
    if (fragment) {
      for (Token& token : tokens) token.text = isEntity(token) ? "iris_Entity" : token.text;
    }
    std::vector<Token> made = hostTokens(
        fragment ? "in uint mc_Entity; " + type + " iris_Entity = " + type + "(0);"
                 : "uint mc_Entity = int(0);",
        false);
    for (Token& token : made) token.origin = place;
    made.front().newlinesBefore = newlines;
    TokenEdits edits;
    edits.insertBefore(item.begin, std::move(made));
    edits.erase(item.begin, item.end);
    return edits.apply(tokens);
  }
}

void ruleIrisNames(RewriteContext& context) { IrisNaming(context).run(); }

}  // namespace orris
