#include <orris/glsl/rewrite/core_text.h>

#include <algorithm>
#include <string>
#include <string_view>

#include <orris/glsl/rewrite/core_names.h>
#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/rewrite/text_code.h>
#include <orris/glsl/tokens/text_edits.h>

namespace orris {
namespace {

constexpr std::string_view kCompatibility = "compatibility";

// The words of GL's comparisons are bits: 1 less, 2 equal, 4 greater; 7 always.
constexpr std::string_view kAlphaTest =
    "uniform int iris_AlphaFunction; uniform float iris_AlphaReference; "
    "bool iris_alphaFails(float a) { "
    "int is = a < iris_AlphaReference ? 1 : a == iris_AlphaReference ? 2 : "
    "a > iris_AlphaReference ? 4 : 0; "
    "return iris_AlphaFunction != 7 && (iris_AlphaFunction & is) == 0; }";
// gl_FragColor goes to all draw buffers.
constexpr std::string_view kSpreadColor =
    "for (int i = 0; i < 8; ++i) iris_FragData[i] = iris_FragColor; ";

class CoreStage {
 public:
  explicit CoreStage(const StageText& text) : text_(text), tokens_(codeTokens(text.text.text)) {}

  void rename() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind != TokenKind::Identifier || precededBy(tokens_, i, ".")) continue;
      const CoreName* name = findCoreName(text_.stage, tokens_[i].text);
      if (name == nullptr) continue;
      for (const std::string_view declaration : name->declarations) declare(declaration);
      edits_.rename(offsetOf(tokens_[i]), tokens_[i].text.size(), std::string(name->replacement));
      spreadsColor_ |= tokens_[i].text == "gl_FragColor";
      writesFragData_ |= tokens_[i].text == "gl_FragData" || tokens_[i].text == "gl_FragColor";
    }
  }

  /// Declares what the next stage reads.
  void feed(const CoreStage& next) {
    for (const std::string_view declaration : next.declared_) declare(outputForInput(declaration));
  }

  StageText finish() {
    setProfile();
    addAlphaTest();
    std::string declarations;
    for (const std::string_view declaration : declared_)
      declarations += std::string(declaration) + " ";
    if (!declarations.empty() && !tokens_.empty()) edits_.insert(offsetOf(tokens_[0]), declarations);
    return {text_.stage, edits_.apply(text_.text)};
  }

 private:
  void declare(std::string_view declaration) {
    const bool known = std::find(declared_.begin(), declared_.end(), declaration) != declared_.end();
    if (!declaration.empty() && !known) declared_.push_back(declaration);
  }

  void setProfile() {
    const std::string& text = text_.text.text;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::size_t at = text.find(kCompatibility);
    if (text.starts_with("#version") && at < end)
      edits_.rename(at, kCompatibility.size(), "core");
  }

  /// A new main around the author's, which may return early.
  void addAlphaTest() {
    if (text_.stage != Stage::Fragment) return;
    // Rule frag-data has named it where the author has outputs of his own besides.
    const bool ownName = std::any_of(tokens_.begin(), tokens_.end(), [](const Token& token) {
      return isIdentifier(token, "orris_FragData0");
    });
    if (!writesFragData_ && !ownName) return;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (isIdentifier(tokens_[i], "main") && followedBy(tokens_, i, "("))
        edits_.rename(offsetOf(tokens_[i]), tokens_[i].text.size(), "iris_main");
    }
    declare(kAlphaTest);
    const std::string output = writesFragData_ ? "iris_FragData[0]" : "orris_FragData0";
    edits_.insert(text_.text.text.size(),
                  " void main() { iris_main(); " +
                      (spreadsColor_ ? std::string(kSpreadColor) : std::string()) +
                      "if (iris_alphaFails(" + output + ".a)) discard; }");
  }

  const StageText& text_;
  std::vector<Token> tokens_;
  TextEdits edits_;
  std::vector<std::string_view> declared_;  ///< in the order of first use
  bool writesFragData_ = false, spreadsColor_ = false;
};

}  // namespace

std::vector<StageText> coreTexts(const std::vector<const StageText*>& texts) {
  std::vector<CoreStage> stages;
  for (const StageText* text : texts) stages.emplace_back(*text);
  for (CoreStage& stage : stages) stage.rename();
  for (std::size_t i = 1; i < stages.size(); ++i) stages[i - 1].feed(stages[i]);
  std::vector<StageText> result;
  for (CoreStage& stage : stages) result.push_back(stage.finish());
  return result;
}

}  // namespace orris
