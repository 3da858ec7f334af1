#include <orris/chart/measure/setting.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include <orris/chart/study/digest.h>
#include <orris/core/add_diagnostic.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::size_t kLongestStem = 80;

std::vector<std::string> profileNames(const ShaderPack& pack) {
  std::vector<std::string> names;
  for (const Profile& profile : pack.properties.profiles) names.push_back(profile.name);
  return names;
}

/// All values of an axis; nullopt and a diagnostic when the pack has no such axis.
std::optional<std::vector<std::string>> valuesOf(const std::string& name, const ShaderPack& pack,
                                                 Diagnostics& diagnostics) {
  if (name == kProfileAxis) return profileNames(pack);
  if (name == kSizeAxis) return std::vector<std::string>();
  if (const Option* option = pack.options.find(name)) return option->values;
  std::vector<std::string> names = {kProfileAxis, kSizeAxis};
  for (const auto& entry : pack.options.all()) names.push_back(entry.first);
  const std::string hint = missingOptionHint(pack.options, name);
  addError(diagnostics, "axis-unknown", {},
           fmt::format("\"{}\" is no option of the pack, nor profile or size", name),
           hint.empty() ? suggest(name, names) : hint);
  return std::nullopt;
}

bool checkValue(const std::string& name, const std::string& value,
                const std::vector<std::string>& all, Diagnostics& diagnostics) {
  if (name == kSizeAxis) {
    if (parseImageSize(value)) return true;
    addError(diagnostics, "axis-value", {}, fmt::format("size cannot be \"{}\"", value),
             "write it as 320x180");
    return false;
  }
  if (std::find(all.begin(), all.end(), value) != all.end()) return true;
  const std::string nearest = suggest(value, all);
  addError(diagnostics, "axis-value", {}, fmt::format("{} cannot be \"{}\"", name, value),
           all.empty()        ? fmt::format("the pack has no {}", name)
           : !nearest.empty() ? nearest
                              : fmt::format("its values are {}", joinNames(all)));
  return false;
}

bool resolveAxis(Axis& axis, const ShaderPack& pack, Diagnostics& diagnostics) {
  const auto all = valuesOf(axis.name, pack, diagnostics);
  if (!all) return false;
  if (axis.values.empty()) {
    axis.values = *all;
    if (!axis.values.empty()) return true;
    addError(diagnostics, "axis-empty", {}, fmt::format("the axis {} has no values", axis.name),
             axis.name == kSizeAxis ? "write them behind it: size=160x90,320x180"
                                    : "name other axes: --axis NAME");
    return false;
  }
  bool good = true;
  std::vector<std::string> once;
  for (const std::string& value : axis.values) {
    if (std::find(once.begin(), once.end(), value) != once.end()) continue;
    once.push_back(value);
    good &= checkValue(axis.name, value, *all, diagnostics);
  }
  axis.values = std::move(once);
  return good;
}

void assign(Setting& setting, const std::string& name, const std::string& value) {
  if (name == kProfileAxis)
    setting.profile = value;
  else if (name == kSizeAxis)
    setting.size = parseImageSize(value).value_or(setting.size);
  else
    setting.values[name] = value;
  setting.label += fmt::format("{}{}={}", setting.label.empty() ? "" : " ", name, value);
}

}  // namespace

Axis parseAxis(const std::string& text) {
  const std::size_t equals = text.find('=');
  Axis axis{text.substr(0, equals), {}};
  if (equals == std::string::npos) return axis;
  for (const std::string_view value : splitAt(std::string_view(text).substr(equals + 1), ','))
    axis.values.emplace_back(value);
  return axis;
}

bool resolveAxes(std::vector<Axis>& axes, const ShaderPack& pack, Diagnostics& diagnostics) {
  bool good = true;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const bool repeated =
        std::any_of(axes.begin(), axes.begin() + std::ptrdiff_t(i),
                    [&](const Axis& earlier) { return earlier.name == axes[i].name; });
    if (repeated) {
      addError(diagnostics, "axis-repeated", {},
               fmt::format("the axis {} is given twice", axes[i].name),
               "give all its values at once: NAME=A,B,C");
      good = false;
    }
    good &= resolveAxis(axes[i], pack, diagnostics);
  }
  return good;
}

std::optional<std::vector<Setting>> combine(const std::vector<Axis>& axes, ImageSize size,
                                            Diagnostics& diagnostics) {
  std::vector<Setting> settings = {
      Setting{.profile = {}, .values = {}, .size = size, .series = {}, .label = {}}};
  for (const Axis& axis : axes) {
    if (settings.size() * axis.values.size() > kMaxSettings) {
      addError(diagnostics, "axis-too-many", {},
               fmt::format("the axes make more than {} settings", kMaxSettings),
               "give fewer axes, or fewer values: --axis NAME=A,B");
      return std::nullopt;
    }
    std::vector<Setting> next;
    for (const Setting& setting : settings) {
      for (const std::string& value : axis.values) {
        next.push_back(setting);
        assign(next.back(), axis.name, value);
        if (&axis == &axes.front()) next.back().series = next.back().label;
      }
    }
    settings = std::move(next);
  }
  if (axes.empty()) settings.front().label = "as it is";
  return settings;
}

std::optional<Setting> parseSetting(const std::string& text, const ShaderPack& pack, ImageSize size,
                                    Diagnostics& diagnostics) {
  Setting setting;
  setting.size = size;
  bool good = true;
  for (const std::string_view part : splitAt(text, ',')) {
    Axis axis = parseAxis(std::string(part));
    if (axis.values.size() != 1) {
      addError(diagnostics, "setting-syntax", {},
               fmt::format("expected NAME=VALUE, got \"{}\"", part),
               "separate several with commas");
      good = false;
    } else if (resolveAxis(axis, pack, diagnostics)) {
      assign(setting, axis.name, axis.values.front());
    } else {
      good = false;
    }
  }
  return good ? std::optional(std::move(setting)) : std::nullopt;
}

bool includes(const Setting& setting, const Setting& part) {
  if (!part.profile.empty() && part.profile != setting.profile) return false;
  if (part.size.width > 0 && part.size != setting.size) return false;
  return std::all_of(part.values.begin(), part.values.end(), [&](const auto& entry) {
    const auto found = setting.values.find(entry.first);
    return found != setting.values.end() && found->second == entry.second;
  });
}

LoadRequest withSetting(LoadRequest request, const Setting& setting) {
  if (!setting.profile.empty()) request.profile = setting.profile;
  for (const auto& [name, value] : setting.values) request.values[name] = value;
  return request;
}

std::string fileStem(const std::string& label) {
  std::string stem;
  for (const char c : label.substr(0, kLongestStem)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
                       c == '-' || c == '=';
    stem += plain ? c : '_';
  }
  return fmt::format("{}-{:08x}", stem, Digest().add(label).value() & 0xffffffffu);
}

}  // namespace orris
