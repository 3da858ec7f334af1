#include <orris/pack/properties/counter_warning.h>

#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kWarningPrefix = "warn.";
constexpr float kMostTexels = 64;

const CustomImage* findCounter(const ShaderProperties& properties, std::string_view name) {
  const auto found = std::find_if(
      properties.images.begin(), properties.images.end(),
      [&](const CustomImage& image) { return image.name == name && isCounter(image); });
  return found == properties.images.end() ? nullptr : &*found;
}

std::vector<std::string> counterNames(const ShaderProperties& properties) {
  std::vector<std::string> names;
  for (const CustomImage& image : properties.images)
    if (isCounter(image)) names.push_back(image.name);
  return names;
}

}  // namespace

bool isCounter(const CustomImage& image) {
  const bool row = !image.relative && image.size[0] <= kMostTexels && image.size[1] == 1;
  return row && image.dimensions <= 2 && image.pixelFormat == "RED_INTEGER";
}

std::vector<CounterWarning> parseCounterWarnings(const std::string& file, const std::string& text,
                                                 const MacroDefinitions& macros,
                                                 const ShaderProperties& properties,
                                                 Diagnostics& diagnostics) {
  Diagnostics reported;  // by whoever read the file for its other keys
  const std::string active = preprocessProperties(file, text, macros, reported);
  std::vector<CounterWarning> warnings;
  for (const PropertyEntry& entry :
       lastValues(parseProperties(file, active, Continuation::Preprocessed, text))) {
    if (!entry.key.starts_with(kWarningPrefix)) continue;
    const std::string_view rest = std::string_view(entry.key).substr(kWarningPrefix.size());
    const std::size_t dot = std::min(rest.find('.'), rest.size());
    const CustomImage* image = findCounter(properties, rest.substr(0, dot));
    const auto texel = dot < rest.size() ? parseInteger(rest.substr(dot + 1)) : std::nullopt;
    if (image && texel && *texel >= 0 && *texel < int(image->size[0])) {
      warnings.push_back({image->name, int(*texel), entry.value, entry.at});
      continue;
    }
    diagnostics.push_back(propertyDiagnostic(
        Severity::Warning, "counter-warning", entry,
        fmt::format("{}: no such {}", entry.key, image ? "texel" : "counter"),
        image ? fmt::format("{} has {}, from 0", image->name, int(image->size[0]))
              : "counters are " + joinNames(counterNames(properties))));
  }
  return warnings;
}

}  // namespace orris
