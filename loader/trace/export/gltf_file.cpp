// The two shapes of a glTF file.
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include <orris/trace/export/gltf_scene.h>

namespace orris {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546c67, kGlbVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

void appendWord(std::string& bytes, std::size_t value) {
  const std::uint32_t word = std::uint32_t(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

/// RFC 4648.
std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t count = std::min(bytes.size() - i, std::size_t(3));
    for (std::size_t j = 0; j < 3; ++j)
      three = three << 8 | (j < count ? std::uint8_t(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text.push_back(j <= count ? kDigits[three >> (18 - 6 * j) & 63] : '=');
  }
  return text;
}

}  // namespace

std::string glbFile(const GltfScene& scene) {
  std::string json = scene.json;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string bytes;
  appendWord(bytes, kGlbMagic);
  appendWord(bytes, kGlbVersion);
  appendWord(bytes, 12 + 8 + json.size() + 8 + scene.binary.size());
  appendWord(bytes, json.size());
  appendWord(bytes, kJsonChunk);
  bytes += json;
  appendWord(bytes, scene.binary.size());
  appendWord(bytes, kBinaryChunk);
  return bytes + scene.binary;
}

std::string gltfFile(const GltfScene& scene) {
  nlohmann::json root = nlohmann::json::parse(scene.json);
  root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(scene.binary);
  return root.dump(1) + "\n";
}

}  // namespace orris
