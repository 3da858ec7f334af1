// Keys with a value of their own kind.
#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/files/text.h>
#include <orris/pack/programs/directives.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/properties/volume_lights.h>

namespace orris {
namespace {

std::optional<HostVersions> minimumOf(const ShaderProperties& properties, std::string& error) {
  const auto textOf = [&](const char* key) {
    const auto found = properties.settings.find(key);
    return found == properties.settings.end() ? std::string() : found->second;
  };
  const std::string iris = textOf("orris.minimum.iris"), game = textOf("orris.minimum.game");
  if (iris.empty() && game.empty()) return std::nullopt;
  return chooseVersions(iris, game, SeriesEnd::First, error);
}

}  // namespace

void readWeather(const PropertyContext& context, std::string_view) {
  auto words = splitSingleBlanks(context.entry.value);
  words.resize(std::min<size_t>(words.size(), 2));
  std::string taken;
  for (const std::string& word : words) {
    if (word != "true" && word != "false") {
      context.warn("property-value",
                   fmt::format("weather has \"{}\", which Iris takes for false", word),
                   "write one or two of true and false, with one blank between them");
    }
    taken += (taken.empty() ? "" : " ") + std::string(word == "true" ? "true" : "false");
  }
  context.out.settings["weather"] = taken;
}

void readVolumeLights(const PropertyContext& context, std::string_view) {
  if (parseVolumeLights(context.entry.value)) {
    context.out.settings["shadowvolume.lights"] = context.entry.value;
  } else {
    context.warn("property-value",
                 fmt::format("shadowvolume.lights is \"{}\", expected a number of lamps from 0 to "
                             "{} and, if wanted, blocks of range a light level",
                             context.entry.value, kMostVolumeLights));
  }
}

// The buffer that programs without one of the pack draw to.
void readFallbackBuffer(const PropertyContext& context, std::string_view) {
  const auto index = parseInteger(context.entry.value);
  if (index && *index >= 0 && *index < kColorTargets) {
    context.out.settings["fallbackTex"] = context.entry.value;
  } else {
    context.warn("property-value", fmt::format("fallbackTex is \"{}\", expected 0 to {}",
                                               context.entry.value, kColorTargets - 1));
  }
}

// Together with what is read so far.
void readMinimum(const PropertyContext& context, std::string_view) {
  std::string& setting = context.out.settings[context.entry.key];
  setting = context.entry.value;
  std::string error;
  if (minimumOf(context.out, error)) return;
  context.warn("property-value", fmt::format("{}: {}", context.entry.key, error));
  context.out.settings.erase(context.entry.key);
}

std::optional<HostVersions> statedMinimum(const ShaderProperties& properties) {
  std::string error;
  return minimumOf(properties, error);
}

}  // namespace orris
