#include <orris/pack/mods/voxy.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace orris {
namespace {

constexpr std::string_view kParameters = R"(
struct VoxyFragmentParameters {
  vec4 sampledColour; vec2 tile; vec2 uv; uint face; uint modelId; vec2 lightMap; vec4 tinting;
  uint customId;
};
void voxy_emitFragment(VoxyFragmentParameters parameters);
)";
constexpr std::string_view kMain = R"(
void main() {
  voxy_emitFragment(VoxyFragmentParameters(vec4(1.0), vec2(0.0), vec2(0.0), 0u, 0u, vec2(1.0),
                                           vec4(1.0), 0u));
}
)";

using TextPairs = std::vector<std::pair<std::string, std::string>>;

/// Reads `"key": [ ... ]` and `"key": { ... }` out of tokens.
class ListReader {
 public:
  explicit ListReader(const TokenStream& json) : json_(json), tokens_(json.tokens) {}

  /// The texts of the list of that key.
  std::vector<std::string> texts(std::string_view key) {
    std::vector<std::string> found;
    if (!enter(key)) return found;
    int depth = 1;
    for (++at_; at_ < tokens_.size() && depth > 0; ++at_) {
      const std::string& text = tokens_[at_].text;
      if (text == "[" || text == "{") ++depth;
      if (text == "]" || text == "}") --depth;
      if (text == "\"") found.push_back(quoted());
    }
    return found;
  }
  /// The keys, with or without quotes, and texts of the object of that key.
  TextPairs pairs(std::string_view key) {
    TextPairs found;
    if (!enter(key) || tokens_[at_].text != "{") return found;
    std::string name;
    bool named = false;
    for (++at_; at_ < tokens_.size() && tokens_[at_].text != "}"; ++at_) {
      const std::string& text = tokens_[at_].text;
      if (text == "\"" && named) {
        found.emplace_back(name, quoted());
      } else if (text == "\"") {
        name = quoted();
      } else if (text == ":") {
        named = true;
      } else if (text == ",") {
        name.clear();
        named = false;
      } else if (!named) {
        name += text;
      }
    }
    return found;
  }
  bool isArray(std::string_view key) { return enter(key) && tokens_[at_].text == "["; }

 private:
  /// Stands at the bracket that opens the list.
  bool enter(std::string_view key) {
    for (size_t i = 0; i + 4 < tokens_.size(); ++i) {
      const bool here = tokens_[i].text == "\"" && tokens_[i + 1].text == key &&
                        tokens_[i + 2].text == "\"" && tokens_[i + 3].text == ":";
      if (!here || (tokens_[i + 4].text != "[" && tokens_[i + 4].text != "{")) continue;
      at_ = i + 4;
      return true;
    }
    return false;
  }

  /// Stands at the opening quote, then at the closing one. Macros do not expand between quotes (Iris:
  /// JCPP takes them as one token), so the name of the macro stands for what it became.
  std::string quoted() {
    std::string text;
    int macro = -1;
    for (++at_; at_ < tokens_.size() && tokens_[at_].text != "\""; ++at_) {
      const Token& token = tokens_[at_];
      const bool more = token.macro >= 0 && token.macro == std::exchange(macro, token.macro);
      if (more) continue;
      if (!text.empty()) text += ' ';
      text += token.macro >= 0 ? json_.macroNames[static_cast<size_t>(token.macro)] : token.text;
    }
    return text;
  }

  const TokenStream& json_;
  const std::vector<Token>& tokens_;
  size_t at_ = 0;
};

std::vector<Token> hostTokens(std::string_view text) {
  std::vector<Token> tokens = tokenize(text);
  for (Token& token : tokens) token.origin = {};
  return tokens;
}

}  // namespace

bool isVoxyFile(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  return name == kVoxyInterfaceFile ||
         std::any_of(std::begin(kVoxyPrograms), std::end(kVoxyPrograms),
                     [&](auto program) { return name == std::string(program) + ".glsl"; });
}

VoxyInterface readVoxyInterface(const TokenStream& json) {
  ListReader reader(json);
  VoxyInterface interface;
  interface.uniforms = reader.texts("uniforms");
  if (reader.isArray("samplers")) {
    for (const std::string& name : reader.texts("samplers"))
      interface.samplers.emplace_back(name, "sampler2D");
  } else {
    interface.samplers = reader.pairs("samplers");
  }
  interface.buffers = reader.pairs("ssbos");
  std::erase_if(interface.buffers, [](const auto& buffer) { return buffer.second.empty(); });
  return interface;
}

std::optional<std::string> voxyPrelude(
    const VoxyInterface& interface, const std::function<std::string(const std::string&)>& typeOf) {
  std::string text;
  for (const std::string& name : interface.uniforms) {
    const std::string type = typeOf(name);
    if (type.empty()) return std::nullopt;
    text += fmt::format("uniform {} {};\n", type, name);
  }
  for (const auto& [name, type] : interface.samplers)
    text += fmt::format("uniform {} {};\n", type, name);
  for (const auto& [binding, members] : interface.buffers) {
    text += fmt::format("layout(std430, binding = {0}) buffer OrrisVoxyBuffer{0} {1};\n", binding,
                        members);
  }
  return text + std::string(kParameters);
}

TokenStream voxyFragment(TokenStream patch, const std::string& prelude) {
  std::vector<Token> tokens = hostTokens(prelude);
  if (!patch.tokens.empty()) patch.tokens.front().newlinesBefore = 1;
  std::move(patch.tokens.begin(), patch.tokens.end(), std::back_inserter(tokens));
  const std::vector<Token> after = hostTokens(kMain);
  tokens.insert(tokens.end(), after.begin(), after.end());
  patch.tokens = std::move(tokens);
  keepVoxyVersion(patch);
  return patch;
}

TokenStream voxyVertex() {
  TokenStream stream;
  stream.tokens = hostTokens("void main() { gl_Position = vec4(0.0); }");
  keepVoxyVersion(stream);
  return stream;
}

void keepVoxyVersion(TokenStream& stream) {
  stream.version = kVoxyVersion;
  stream.profile = "core";
}

}  // namespace orris
