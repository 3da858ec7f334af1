#include <orris/render/inspect/counters.h>

#include <fmt/format.h>

#include <orris/pack/files/pack_files.h>
#include <orris/pack/programs/folder_build.h>
#include <orris/pack/properties/counter_warning.h>

namespace orris {
namespace {

std::vector<CounterWarning> warningsOf(const ShaderPack& pack) {
  const PackFiles& files = pack.builds.front()->files();
  if (!files.properties) return {};
  Diagnostics reported;  // when the pack was loaded
  return parseCounterWarnings(kPropertiesFile, *files.properties, pack.propertyMacros,
                              pack.properties, reported);
}

}  // namespace

std::map<std::string, std::vector<long long>> readCounters(const FrameRenderer& renderer) {
  std::map<std::string, std::vector<long long>> counters;
  for (const CustomImage& image : renderer.pack().properties.images) {
    if (!isCounter(image)) continue;
    if (const std::optional<ImageF> values = renderer.dump(image.name))
      for (const float value : values->pixels)
        counters[image.name].push_back(static_cast<long long>(value));
  }
  return counters;
}

Diagnostics counterWarnings(const FrameRenderer& renderer) {
  Diagnostics diagnostics;
  const std::vector<CounterWarning> warnings = warningsOf(renderer.pack());
  if (warnings.empty()) return diagnostics;
  const auto counters = readCounters(renderer);
  for (const CounterWarning& warning : warnings) {
    const auto found = counters.find(warning.image);
    if (found == counters.end() || warning.texel >= int(found->second.size())) continue;
    const long long count = found->second[std::size_t(warning.texel)];
    if (count == 0) continue;
    diagnostics.push_back({.severity = Severity::Warning,
                           .id = "pack-counter",
                           .at = warning.at,
                           .message = fmt::format("{} {}", count, warning.text)});
  }
  return diagnostics;
}

}  // namespace orris
