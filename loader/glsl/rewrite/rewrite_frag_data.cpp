// The rules for fragment stages that write gl_FragData: beside outputs of their own, and as Iris does.
#include <algorithm>
#include <charconv>
#include <set>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

constexpr int kMaxOutputs = 8;

bool declaresOutput(const std::vector<Token>& tokens) {
  const std::vector<OutlineItem> items = outline(tokens);
  return std::any_of(items.begin(), items.end(), [&tokens](const OutlineItem& item) {
    if (item.kind != OutlineItem::Kind::Declaration) return false;
    return parseDeclaration(tokens, item).qualifier(tokens, "out") != Declaration::npos;
  });
}

/// One gl_FragColor or gl_FragData[literal], tokens [first, last).
struct Use {
  std::size_t first = 0, last = 0;
  int output = 0;
};

/// last == first: the index is no literal that the host knows.
Use useAt(const std::vector<Token>& tokens, std::size_t at) {
  if (isIdentifier(tokens[at], "gl_FragColor")) return {at, at + 1, 0};
  const std::size_t open = nextCode(tokens, at);
  const std::size_t index = nextCode(tokens, open);
  const std::size_t close = nextCode(tokens, index);
  if (close >= tokens.size() || !isPunctuator(tokens[open], "[") ||
      !isPunctuator(tokens[close], "]")) {
    return {at, at, 0};
  }
  const std::string& text = tokens[index].text;
  int output = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), output);
  const bool literal = error == std::errc() && end == text.data() + text.size();
  if (!literal || output < 0 || output >= kMaxOutputs) return {at, at, 0};
  return {at, close + 1, output};
}

std::vector<Use> usesOfFragData(const std::vector<Token>& tokens) {
  std::vector<Use> uses;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (isIdentifier(tokens[i], "gl_FragData") || isIdentifier(tokens[i], "gl_FragColor")) {
      uses.push_back(useAt(tokens, i));
    }
  }
  return uses;
}

/// The uses become outputs of that name and location.
void declareOutputs(RewriteContext& context, std::string_view rule, std::string_view name,
                    const std::vector<Use>& uses) {
  auto& tokens = context.stream.tokens;
  std::set<int> outputs;
  TokenEdits edits;
  for (const Use& use : uses) {
    context.fired(rule, tokens[use.first].origin);
    outputs.insert(use.output);
    tokens[use.first].text = std::string(name) + std::to_string(use.output);
    if (use.first + 1 < use.last) edits.erase(use.first + 1, use.last);
  }
  std::vector<Token> declarations;
  for (const int output : outputs) {
    const std::string number = std::to_string(output);
    const std::vector<Token> one = hostTokens(
        "layout(location = " + number + ") out vec4 " + std::string(name) + number + ";", true);
    declarations.insert(declarations.end(), one.begin(), one.end());
  }
  edits.apply(tokens);
  tokens.front().newlinesBefore = std::max(tokens.front().newlinesBefore, 1);
  tokens.insert(tokens.begin(), declarations.begin(), declarations.end());
}

}  // namespace

// Iris turns gl_FragData into outputs, so packs may mix the two; GLSL does not allow it.
// (Iris: CompatibilityTransformer; contract/README "Profiles and the patcher".)
void ruleFragData(RewriteContext& context) {
  if (context.stage != Stage::Fragment) return;
  auto& tokens = context.stream.tokens;
  const std::vector<Use> uses = usesOfFragData(tokens);
  const bool known =
      std::all_of(uses.begin(), uses.end(), [](auto& u) { return u.first < u.last; });
  if (uses.empty() || !known || !declaresOutput(tokens)) return;
  declareOutputs(context, "frag-data", "orris_FragData", uses);
}

// Iris does it in every fragment stage; an index that is no literal stays, and fails.
void ruleIrisFragData(RewriteContext& context) {
  if (context.stage != Stage::Fragment) return;
  std::vector<Use> uses = usesOfFragData(context.stream.tokens);
  std::erase_if(uses, [](const Use& use) { return use.first == use.last; });
  if (!uses.empty()) declareOutputs(context, "iris-frag-data", "iris_FragData", uses);
}

}  // namespace orris
