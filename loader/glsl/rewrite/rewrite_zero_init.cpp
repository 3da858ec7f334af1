// Variables the pack declares without a value and then adds to. Game drivers start them at zero;
// Mesa calls them undefined, and one undefined term makes the whole picture black.
#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

struct ZeroValue {
  std::string_view type;
  std::string_view text;
};

constexpr std::array<ZeroValue, 28> kZeroValues = {{
    {"float", "0.0"},        {"int", "0"},
    {"uint", "0u"},          {"bool", "false"},
    {"vec2", "vec2(0)"},     {"vec3", "vec3(0)"},
    {"vec4", "vec4(0)"},     {"ivec2", "ivec2(0)"},
    {"ivec3", "ivec3(0)"},   {"ivec4", "ivec4(0)"},
    {"uvec2", "uvec2(0)"},   {"uvec3", "uvec3(0)"},
    {"uvec4", "uvec4(0)"},   {"bvec2", "bvec2(0)"},
    {"bvec3", "bvec3(0)"},   {"bvec4", "bvec4(0)"},
    {"mat2", "mat2(0)"},     {"mat3", "mat3(0)"},
    {"mat4", "mat4(0)"},     {"mat2x2", "mat2(0)"},
    {"mat2x3", "mat2x3(0)"}, {"mat2x4", "mat2x4(0)"},
    {"mat3x2", "mat3x2(0)"}, {"mat3x3", "mat3(0)"},
    {"mat3x4", "mat3x4(0)"}, {"mat4x2", "mat4x2(0)"},
    {"mat4x3", "mat4x3(0)"}, {"mat4x4", "mat4(0)"},
}};

// Larger arrays are tables the pack fills itself; clearing them would cost each pixel.
constexpr int kMaxArraySize = 16;
// Structs in structs in arrays multiply; no honest initialiser comes near this many characters.
constexpr std::size_t kMaxText = 1000;
// Of all initialisers of a stage: a hostile pack must not turn few characters into gigabytes.
constexpr std::size_t kMaxAdded = 1'000'000;

bool isPrecision(const Token& token) {
  return isIdentifier(token, "highp") || isIdentifier(token, "mediump") ||
         isIdentifier(token, "lowp");
}

// "float[3](0.0, 0.0, 0.0)"
std::string zeroArray(const std::string& type, const std::string& zero, int size) {
  std::string text = type + "[" + std::to_string(size) + "](";
  for (int i = 0; i < size; ++i) text += (i > 0 ? ", " : "") + zero;
  return text + ")";
}

class ZeroInit {
 public:
  explicit ZeroInit(RewriteContext& context) : context_(context), tokens_(context.stream.tokens) {
    for (const ZeroValue& value : kZeroValues) zeros_.emplace(value.type, value.text);
  }

  void run() {
    for (const OutlineItem& item : outline(tokens_)) {
      if (item.kind == OutlineItem::Kind::Declaration) global(item);
      if (item.kind == OutlineItem::Kind::Function) body(item);
    }
    edits_.apply(tokens_);
  }

 private:
  // A variable or member: the token its declarator ends with, and its value ("" when not known).
  struct Zero {
    std::size_t last;
    std::string text;
  };

  void global(const OutlineItem& item) {
    const std::size_t type = afterPrecision(item.begin);
    if (type >= item.end) return;
    if (isIdentifier(tokens_[type], "struct")) {
      addStruct(type, item.end);
    } else if (isKnownType(type)) {
      declaration(type, item.end);
    }
  }

  // Only the start of a statement can be a declaration; what stands in parentheses (parameters, the
  // header of a for) and in the braces of a struct is passed over.
  void body(const OutlineItem& item) {
    bool atStart = false;
    for (std::size_t i = item.name; i < item.end; i = nextCode(tokens_, i)) {
      const Token& token = tokens_[i];
      if (isPunctuator(token, "(") || isPunctuator(token, "[")) {
        atStart = isPunctuator(token, "(");
        i = closingBracket(tokens_, i);
      } else if (isIdentifier(token, "struct")) {
        i = localStruct(i, item.end);
        atStart = false;
      } else if (atStart && isKnownType(i)) {
        i = declaration(i, item.end);
        atStart = false;
      } else {
        atStart = startsStatement(token) || (atStart && isPrecision(token));
      }
    }
  }

  static bool startsStatement(const Token& before) {
    constexpr std::array<std::string_view, 6> kBefore = {"{", "}", ";", ":", "else", "do"};
    return std::find(kBefore.begin(), kBefore.end(), before.text) != kBefore.end();
  }

  std::size_t afterPrecision(std::size_t i) const {
    while (i < tokens_.size() && isPrecision(tokens_[i])) i = nextCode(tokens_, i);
    return i;
  }

  bool isKnownType(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == TokenKind::Identifier &&
           zeros_.contains(tokens_[i].text);
  }

  // It may hide one of file scope, so that name is no longer known. Returns its closing brace.
  std::size_t localStruct(std::size_t i, std::size_t end) {
    for (; i < end && !isPunctuator(tokens_[i], "{"); i = nextCode(tokens_, i)) {
      zeros_.erase(tokens_[i].text);
    }
    return i < end ? closingBracket(tokens_, i) : i;
  }

  // Notes the zero of a struct when all its members have one.
  void addStruct(std::size_t keyword, std::size_t end) {
    const std::size_t name = nextCode(tokens_, keyword);
    if (name >= end || !followedBy(tokens_, name, "{")) return;
    const std::size_t open = nextCode(tokens_, name);
    const std::size_t close = std::min(closingBracket(tokens_, open), end);
    std::string text;
    for (std::size_t i = nextCode(tokens_, open); i < close;) {
      const std::size_t type = afterPrecision(i);
      if (type >= close || !isKnownType(type)) return;
      i = afterBrackets(nextCode(tokens_, type));
      for (bool more = true; more; i = nextCode(tokens_, i)) {
        const Zero zero = i < close ? zeroOf(type, i) : Zero{};
        if (zero.text.empty() || text.size() > kMaxText) return;
        text += (text.empty() ? "" : ", ") + zero.text;
        i = nextCode(tokens_, zero.last);
        more = isPunctuator(tokens_[i], ",");
      }
    }
    if (!text.empty()) zeros_[tokens_[name].text] = tokens_[name].text + "(" + text + ")";
  }

  std::size_t afterBrackets(std::size_t i) const {
    while (i < tokens_.size() && isPunctuator(tokens_[i], "[")) {
      i = nextCode(tokens_, closingBracket(tokens_, i));
    }
    return i;
  }

  // The declaration that starts with the type at `type`; returns its last token read.
  std::size_t declaration(std::size_t type, std::size_t end) {
    OutlineItem item;
    item.begin = type;
    item.end = end;
    std::size_t last = type;
    for (const Declarator& declarator : parseDeclaration(tokens_, item).declarators) {
      const Zero zero = zeroOf(type, declarator.name);
      if (!zero.text.empty()) initialise(declarator.name, zero);
      last = declarator.initEnd > declarator.name ? declarator.initEnd - 1 : declarator.name;
    }
    return last;
  }

  // Built-in variables may be redeclared, but not given a value.
  Zero zeroOf(std::size_t type, std::size_t name) const {
    const std::string& typeName = tokens_[type].text;
    const std::string& variable = tokens_[name].text;
    if (variable.starts_with("gl_") || variable == typeName) return {};
    Zero zero{name, zeros_.at(typeName)};
    const bool arrayType = followedBy(tokens_, type, "[");
    const bool arrayName = followedBy(tokens_, name, "[");
    if (arrayType && arrayName) return {};
    if (arrayType || arrayName) {
      const std::size_t open = nextCode(tokens_, arrayType ? type : name);
      const std::size_t close = closingBracket(tokens_, open);
      const int size = arraySize(open);
      if (size == 0 || followedBy(tokens_, close, "[")) return {};
      if (zero.text.size() * static_cast<std::size_t>(size) > kMaxText) return {};
      if (arrayName) zero.last = close;
      zero.text = zeroArray(typeName, zero.text, size);
    }
    const bool ends = followedBy(tokens_, zero.last, ",") || followedBy(tokens_, zero.last, ";");
    return ends && zero.text.size() <= kMaxText ? zero : Zero{};
  }

  // N of "[N]" when it is a number small enough, else 0.
  int arraySize(std::size_t open) const {
    const std::size_t number = nextCode(tokens_, open);
    if (number >= tokens_.size() || !followedBy(tokens_, number, "]")) return 0;
    const std::string& text = tokens_[number].text;
    int size = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    const bool whole = error == std::errc() && rest == text.data() + text.size();
    return whole && size > 0 && size <= kMaxArraySize ? size : 0;
  }

  void initialise(std::size_t name, const Zero& zero) {
    added_ += zero.text.size();
    if (added_ > kMaxAdded) return;
    std::vector<Token> added = hostTokens(" = " + zero.text, false);
    for (Token& token : added) {
      token.origin = tokens_[name].origin;
      token.macro = tokens_[name].macro;
    }
    context_.fired("zero-init", tokens_[name].origin);
    edits_.insertBefore(zero.last + 1, std::move(added));
  }

  RewriteContext& context_;
  std::vector<Token>& tokens_;
  std::unordered_map<std::string, std::string> zeros_;  // by type name
  std::size_t added_ = 0;                               // characters
  TokenEdits edits_;
};

}  // namespace

void ruleZeroInit(RewriteContext& context) { ZeroInit(context).run(); }

}  // namespace orris
