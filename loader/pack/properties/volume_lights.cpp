#include <orris/pack/properties/volume_lights.h>

#include <charconv>
#include <vector>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

template <class Number>
bool parseSetting(const std::string& word, Number& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

std::optional<VolumeLightSettings> parseVolumeLights(const std::string& text) {
  constexpr float kLongest = 16;
  const std::vector<std::string> words = splitBlanks(text);
  VolumeLightSettings settings;
  if (words.empty() || words.size() > 2 || !parseSetting(words[0], settings.count)) return {};
  if (words.size() == 2 && !parseSetting(words[1], settings.range)) return {};
  const bool sane = settings.count >= 0 && settings.count <= kMostVolumeLights &&
                    settings.range > 0 && settings.range <= kLongest;
  return sane ? std::optional(settings) : std::nullopt;
}

}  // namespace orris
