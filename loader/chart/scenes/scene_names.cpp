#include <orris/chart/scenes/scene_names.h>

#include <fmt/format.h>

#include <charconv>

#include <orris/chart/measure/setting.h>
#include <orris/world/random_room.h>

namespace orris {
namespace {

constexpr int kMostRooms = 10000;

std::optional<std::uint32_t> wholeNumber(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "random:SEED:N"
bool addRooms(std::string_view text, std::vector<SceneName>& scenes) {
  text.remove_prefix(kRandomRoom.size());
  const std::size_t colon = text.find(':');
  const auto seed = wholeNumber(text.substr(0, colon));
  const auto count = colon == std::string_view::npos ? std::optional<std::uint32_t>(1)
                                                     : wholeNumber(text.substr(colon + 1));
  if (!seed || !count || *count == 0 || *count > kMostRooms) return false;
  for (std::uint32_t i = 0; i < *count; ++i)
    scenes.push_back({fmt::format("{}{}", kRandomRoom, *seed + 2 * i), ""});
  return true;
}

}  // namespace

std::optional<std::vector<SceneName>> parseScenes(const std::vector<std::string>& list) {
  std::vector<SceneName> scenes;
  for (const std::string& text : list) {
    if (text.starts_with(kRandomRoom)) {
      if (!addRooms(text, scenes)) return std::nullopt;
      continue;
    }
    const std::size_t at = text.rfind('@');
    scenes.push_back({text.substr(0, at), at == std::string::npos ? "" : text.substr(at + 1)});
    if (scenes.back().world.empty()) return std::nullopt;
  }
  return scenes;
}

std::string fileStem(const SceneName& scene) {
  return fileStem(scene.camera.empty() ? scene.world : scene.world + "@" + scene.camera);
}

}  // namespace orris
