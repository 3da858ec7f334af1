#include <orris/pack/properties/shader_properties.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include <orris/core/message_limits.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/directives.h>
#include <orris/pack/properties/latin_text.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/properties/property_limits.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 8> kLegacyBuffers{"gcolor", "gdepth", "gnormal", "composite",
                                                         "gaux1",  "gaux2",  "gaux3",   "gaux4"};

struct PrefixReader {
  std::string_view prefix;
  PropertyReader read;
};
// A longer prefix stands before one that it starts with.
constexpr std::array<PrefixReader, 13> kReaders{{{"program.", readProgramEnabled},
                                                 {"alphaTest.", readAlphaTest},
                                                 {"blend.", readBlend},
                                                 {"flip.", readFlip},
                                                 {"scale.", readScale},
                                                 {"size.buffer.", readBufferSize},
                                                 {"indirect.", readIndirect},
                                                 {"texture.", readTexture},
                                                 {"customTexture.", readCustomTexture},
                                                 {"image.", readImage},
                                                 {"bufferObject.", readBufferObject},
                                                 {"uniform.", readUniform},
                                                 {"variable.", readVariable}}};

/// Keys that are no prefix and whose value is more than one of a few words.
constexpr std::array<PrefixReader, 5> kOwnReaders{{{"weather", readWeather},
                                                   {"shadowvolume.lights", readVolumeLights},
                                                   {"fallbackTex", readFallbackBuffer},
                                                   {"orris.minimum.iris", readMinimum},
                                                   {"orris.minimum.game", readMinimum}}};

/// A key with one word as value. No words: a boolean.
struct Setting {
  std::string_view key;
  std::vector<std::string_view> words;
};
const std::vector<Setting>& settings() {
  static const std::vector<Setting> kSettings = [] {
    std::vector<Setting> all{{"clouds", {"off", "fast", "fancy"}},
                             {"dhClouds", {"off", "on", "fancy"}},
                             {"shadow.culling", {"true", "false", "reversed", "safe_zone"}},
                             {"particles.ordering", {"mixed", "after", "before"}},
                             {"shadowvolume.method", {"auto", "zpass", "zfail"}}};
    for (const std::string_view key : {"shadow.enabled",
                                       "shadowTerrain",
                                       "shadowTranslucent",
                                       "shadowEntities",
                                       "shadowPlayer",
                                       "shadowBlockEntities",
                                       "shadowLightBlockEntities",
                                       "dhShadow.enabled",
                                       "particles.before.deferred",
                                       "separateEntityDraws",
                                       "skipAllRendering",
                                       "voxelizeLightBlocks",
                                       "allowConcurrentCompute",
                                       "prepareBeforeShadow",
                                       "sun",
                                       "moon",
                                       "sky",
                                       "stars",
                                       "underwaterOverlay",
                                       "vignette",
                                       "endFlashShadows",
                                       "oldLighting",
                                       "oldHandLight",
                                       "dynamicHandLight",
                                       "separateAo",
                                       "breaksAnisotropy",
                                       "supportsColorCorrection",
                                       "backFace.solid",
                                       "backFace.cutout",
                                       "backFace.cutoutMipped",
                                       "backFace.translucent",
                                       "frustum.culling",
                                       "occlusion.culling",
                                       "rain.depth",
                                       "beacon.beam.depth"}) {
      all.push_back({key, {}});
    }
    return all;
  }();
  return kSettings;
}

std::vector<std::string> settingNames() {
  std::vector<std::string> names{"sliders",
                                 "screen",
                                 "screen.columns",
                                 "iris.features.required",
                                 "iris.features.optional",
                                 "orris.features.required",
                                 "orris.features.optional"};
  for (const PrefixReader& reader : kOwnReaders) names.emplace_back(reader.prefix);
  for (const Setting& setting : settings()) names.emplace_back(setting.key);
  return names;
}

void readSetting(const PropertyContext& context, const Setting& setting) {
  const auto& [key, value] = std::tie(context.entry.key, context.entry.value);
  if (setting.words.empty()) {
    if (const auto on = parseBoolean(value)) {
      context.out.settings[key] = *on ? "true" : "false";
    } else {
      context.ignore("property-value",
                     fmt::format("{} is \"{}\", expected true or false", key, value));
    }
    return;
  }
  // Iris compares the others letter by letter.
  const std::string word = key == "particles.ordering" ? lowerCase(value) : value;
  if (std::find(setting.words.begin(), setting.words.end(), word) != setting.words.end()) {
    context.out.settings[key] = word;
    return;
  }
  context.ignore("property-value", fmt::format("{} is \"{}\", expected one of {}", key, value,
                                               fmt::join(setting.words, ", ")));
}

/// "texure.composite.x" for "texture.composite.x": a key whose first part is misspelt.
std::string nearestByPrefix(const std::string& key) {
  static const std::vector<std::string> kBeginnings = [] {
    std::vector<std::string> all{"screen.", "profile."};
    for (const PrefixReader& reader : kReaders) all.emplace_back(reader.prefix);
    return all;
  }();
  constexpr size_t kMostSlips = 2;
  for (const std::string& prefix : kBeginnings) {
    const size_t dots = static_cast<size_t>(std::count(prefix.begin(), prefix.end(), '.'));
    size_t end = 0;
    for (size_t i = 0; i < dots && end != std::string::npos; ++i) {
      end = key.find('.', end);
      if (end != std::string::npos) ++end;
    }
    if (end == std::string::npos) continue;
    const std::string head = key.substr(0, end);
    if (head.size() > prefix.size() + kMostSlips) continue;
    if (editDistance(lowerCase(head), lowerCase(prefix)) <= kMostSlips)
      return prefix + key.substr(end);
  }
  return "";
}

/// Keys of other hosts and mods are common, so only what looks misspelt is worth a word.
void reportUnknown(const PropertyContext& context) {
  static const std::vector<std::string> kNames = settingNames();
  const std::string& key = context.entry.key;
  if (key.size() <= 4 || key.starts_with("//")) return;
  const size_t dot = key.find('.');
  const std::string head = key.substr(0, dot);
  const bool setting =
      dot != std::string::npos && std::find(kNames.begin(), kNames.end(), head) != kNames.end();
  std::string nearest = setting ? head : nearestByPrefix(key);
  if (nearest.empty()) nearest = nearestName(key, kNames);
  if (nearest.empty() || nearest == key) return;
  context.warn("property-unknown", fmt::format("unknown key {}", key),
               fmt::format("did you mean {}?", nearest));
  std::string line = context.entry.lines.front();
  const size_t at = line.find(key);
  if (at == std::string::npos) return;
  const SourceLocation& place = context.entry.at;
  context.diagnostics.back().repair =
      LineEdit{place.file, place.line, line.replace(at, key.size(), nearest), true};
}

void readEntry(const PropertyContext& context) {
  const std::string& key = context.entry.key;
  for (const PrefixReader& reader : kOwnReaders) {
    if (key == reader.prefix) return reader.read(context, key);
  }
  for (const Setting& setting : settings()) {
    if (key == setting.key) return readSetting(context, setting);
  }
  for (const PrefixReader& reader : kReaders) {
    if (key.starts_with(reader.prefix)) {
      return reader.read(context, std::string_view(key).substr(reader.prefix.size()));
    }
  }
}

}  // namespace

void PropertyContext::warn(std::string id, std::string message, std::string hint,
                           std::string_view word) const {
  diagnostics.push_back(propertyDiagnostic(Severity::Warning, std::move(id), entry,
                                           std::move(message), std::move(hint), word));
}

void PropertyContext::fail(std::string id, std::string message, std::string hint,
                           std::string_view word) const {
  diagnostics.push_back(propertyDiagnostic(Severity::Error, std::move(id), entry,
                                           std::move(message), std::move(hint), word));
}

void PropertyContext::ignore(std::string id, std::string message, std::string hint,
                             std::string_view word) const {
  diagnostics.push_back(withEffect(propertyDiagnostic(Severity::Warning, std::move(id), entry,
                                                      std::move(message), std::move(hint), word),
                                   Effect::IgnoresLine));
}

void PropertyContext::refuse(std::string id, std::string message, std::string hint,
                             std::string_view word) const {
  diagnostics.push_back(withEffect(propertyDiagnostic(Severity::Error, std::move(id), entry,
                                                      std::move(message), std::move(hint), word),
                                   Effect::RefusesPack));
}

bool ShaderProperties::flag(const std::string& key, bool fallback) const {
  const auto found = settings.find(key);
  return found == settings.end() ? fallback : found->second == "true";
}

bool ShaderProperties::feature(const std::string& name) const {
  const auto lists = [&](const std::vector<std::string>& flags) {
    return std::find(flags.begin(), flags.end(), name) != flags.end();
  };
  return lists(requiredFeatures) || lists(optionalFeatures);
}

std::string canonicalBuffer(std::string_view name) {
  const auto legacy = std::find(kLegacyBuffers.begin(), kLegacyBuffers.end(), name);
  if (legacy == kLegacyBuffers.end()) return std::string(name);
  return fmt::format("colortex{}", legacy - kLegacyBuffers.begin());
}

std::vector<std::string_view> settingKeys() {
  std::vector<std::string_view> keys;
  for (const PrefixReader& reader : kOwnReaders) keys.push_back(reader.prefix);
  for (const Setting& setting : settings()) keys.push_back(setting.key);
  return keys;
}

std::vector<std::string_view> propertyPrefixes() {
  std::vector<std::string_view> prefixes;
  for (const PrefixReader& reader : kReaders) prefixes.push_back(reader.prefix);
  return prefixes;
}

std::string knownBuffer(std::string_view name) {
  constexpr std::string_view kPrefix = "colortex";
  std::string canonical = canonicalBuffer(name);
  if (!canonical.starts_with(kPrefix)) return "";
  const std::string digits = canonical.substr(kPrefix.size());
  const auto index = parseInteger(digits);
  const bool exists = index && *index >= 0 && *index < kColorTargets;
  return exists && std::to_string(*index) == digits ? canonical : "";
}

bool isKnownPropertyKey(std::string_view key) {
  const auto& names = settings();
  return key == "screen" || key.starts_with("screen.") || key.starts_with("profile.") ||
         key.starts_with("auto.") || key.starts_with("warn.") ||
         std::any_of(kOwnReaders.begin(), kOwnReaders.end(),
                     [&](auto& reader) { return reader.prefix == key; }) ||
         std::any_of(names.begin(), names.end(),
                     [&](auto& setting) { return setting.key == key; }) ||
         std::any_of(kReaders.begin(), kReaders.end(),
                     [&](auto& reader) { return key.starts_with(reader.prefix); });
}

ShaderProperties parseShaderProperties(const std::string& file, const std::string& text,
                                       const MacroDefinitions& macros, const OptionSet& options,
                                       Diagnostics& diagnostics, NameWatch* watch) {
  ShaderProperties properties;
  const std::string preprocessed = upToForeignCharacter(
      file, text, preprocessProperties(file, text, macros, diagnostics, watch), diagnostics);
  auto entries = lastValues(parseProperties(file, preprocessed, Continuation::Preprocessed, text));
  limitProperties(entries, diagnostics);
  for (const PropertyEntry& entry : entries) {
    readEntry({properties, entry, options, diagnostics});
  }
  auto original = lastValues(parseProperties(file, text, Continuation::Java));
  limitProperties(original, diagnostics);
  // In inactive branches, too: other options make them active.
  for (const PropertyEntry& entry : original) {
    if (!isKnownPropertyKey(entry.key)) reportUnknown({properties, entry, options, diagnostics});
  }
  readProfiles(original, properties, options, diagnostics);
  const Version iris = irisVersionOf(macros).value_or(HostVersions().iris);
  readScreens(original, properties, options, iris, diagnostics);
  boundMessages(diagnostics);
  return properties;
}

}  // namespace orris
