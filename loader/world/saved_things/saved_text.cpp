#include <orris/core/limits.h>
#include <orris/world/files/located_json.h>
#include <orris/world/saved_things/saved_text.h>

#include <cstdint>

namespace orris {
namespace {

// No text is drawn of more; what follows is not even gathered.
constexpr std::size_t kGathered = 4 * limits::kWorldTextGlyphs;

void gather(const JsonNode& node, std::string& text) {
  if (text.size() >= kGathered) return;
  if (node.kind == JsonNode::Kind::String) text += node.text.substr(0, kGathered);
  for (const JsonNode& item : node.items) gather(item, text);
  for (const char* key : {"text", "extra"}) {
    if (const JsonNode* member = node.find(key)) gather(*member, text);
  }
}

void gather(const NbtTag& tag, std::string& text) {
  if (text.size() >= kGathered) return;
  if (tag.string()) text += tag.string()->substr(0, kGathered);
  if (tag.list()) {
    for (const NbtTag& item : *tag.list()) gather(item, text);
  }
  // "": of a list whose items are not all compounds, each that is none.
  for (const char* key : {"", "text", "extra"}) {
    if (const NbtTag* member = tag.find(key)) gather(*member, text);
  }
}

std::string gathered(const NbtTag& tag) {
  std::string text;
  const std::string* string = tag.string();
  if (string && string->size() <= limits::kWorldJsonBytes &&
      std::string_view("{[\"").find(string->empty() ? ' ' : string->front()) !=
          std::string_view::npos) {
    Diagnostics ignored;
    if (const auto json = parseLocatedJson({*string, ""}, ignored)) {
      gather(*json, text);
      return text;
    }
  }
  gather(tag, text);
  return text;
}

}  // namespace

std::string drawnText(const NbtTag& tag) {
  constexpr unsigned char kLeads = 0xc2, kSection = 0xa7;
  const std::string text = gathered(tag);
  std::string drawn;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = std::uint8_t(text[i]);
    if (byte == kLeads && i + 1 < text.size() && std::uint8_t(text[i + 1]) == kSection) {
      i += 2;  // the sign and the letter of a colour or style
      continue;
    }
    if ((byte & 0xc0) == 0x80) continue;  // a further byte of a character
    drawn += byte > ' ' && byte < 0x7f ? char(byte) : ' ';
  }
  const std::size_t first = drawn.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  drawn = drawn.substr(first, limits::kWorldTextGlyphs);
  return drawn.substr(0, drawn.find_last_not_of(' ') + 1);
}

}  // namespace orris
