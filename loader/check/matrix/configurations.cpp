#include <orris/check/matrix/configurations.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <orris/check/matrix/covering_array.h>
#include <orris/check/options/option_checks.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {
namespace {

struct Use {
  std::size_t programs = 0;
  bool inConditions = false;
};

std::map<std::string, Use> usesOf(std::span<const ShaderPack> folders) {
  std::map<std::string, Use> uses;
  for (const ShaderPack& pack : folders) {
    for (const ProgramSource& program : pack.programs) {
      for (const std::string& option : program.options) ++uses[option].programs;
      for (const std::string& option : program.conditionOptions) uses[option].inConditions = true;
    }
    for (const std::string& option : pack.builds.front()->properties().options) {
      uses[option].inConditions = true;
    }
  }
  return uses;
}

OptionValues withValue(OptionValues values, const OptionSet& options, const std::string& option,
                       const std::string& value) {
  if (value == options.find(option)->defaultValue) {
    values.erase(option);
  } else {
    values[option] = value;
  }
  return values;
}

// First every option's first other value, those that decide most before the rest, and so on: when
// time runs out, no option was left untouched for the tenth value of another.
std::vector<OptionValues> eachConfiguration(std::vector<MatrixAxis> axes, const OptionSet& options,
                                            const OptionValues& base) {
  std::stable_sort(axes.begin(), axes.end(), [](const MatrixAxis& a, const MatrixAxis& b) {
    return std::pair(a.inConditions, a.reach) > std::pair(b.inConditions, b.reach);
  });
  std::vector<OptionValues> result;
  bool any = true;
  for (std::size_t round = 1; any; ++round) {
    any = false;
    for (const MatrixAxis& axis : axes) {
      if (round >= axis.values.size()) continue;
      any = true;
      result.push_back(withValue(base, options, axis.option, axis.values[round]));
    }
  }
  return result;
}

std::vector<OptionValues> pairwiseConfigurations(const std::vector<MatrixAxis>& axes,
                                                 const OptionSet& options, const OptionValues& base,
                                                 const std::function<bool()>& stop) {
  std::vector<int> levels;
  for (const MatrixAxis& axis : axes) levels.push_back(static_cast<int>(axis.values.size()));
  std::vector<OptionValues> result;
  for (const std::vector<int>& row : pairwiseRows(levels, stop)) {
    OptionValues values = base;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      values = withValue(std::move(values), options, axes[i].option,
                         axes[i].values[static_cast<std::size_t>(row[i])]);
    }
    if (values != base) result.push_back(std::move(values));
  }
  return result;
}

bool areNumbers(const std::vector<std::string>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](const std::string& value) { return parseFloat(value).has_value(); });
}

std::vector<std::string> thinned(const MatrixAxis& axis) {
  std::map<bool, std::map<float, std::string>> byKind;
  for (const std::string& value : axis.values) {
    byKind[parseInteger(value).has_value()].emplace(*parseFloat(value), value);
  }
  const std::string& current = axis.values.front();
  std::vector<std::string> kept{current};
  const auto keep = [&kept](const std::string& value) {
    if (std::find(kept.begin(), kept.end(), value) == kept.end()) kept.push_back(value);
  };
  for (const auto& [integer, values] : byKind) {
    keep(values.begin()->second);
    keep(values.rbegin()->second);
    if (!axis.inConditions) continue;
    const auto at = values.lower_bound(*parseFloat(current));
    if (at != values.begin()) keep(std::prev(at)->second);
    const auto above = values.upper_bound(*parseFloat(current));
    if (above != values.end()) keep(above->second);
    for (const float threshold : {0.0F, 1.0F}) {
      if (const auto known = values.find(threshold); known != values.end()) keep(known->second);
    }
  }
  return kept;
}

// "#ifndef NAME" above "#define NAME": without it a file is included twice.
bool isIncludeGuard(const ShaderPack& pack, const std::string& name, const Option& option) {
  return std::any_of(option.at.begin(), option.at.end(), [&](const SourceLocation& at) {
    const std::string above = pack.sourceLine(at.file, at.line - 1);
    const std::string_view line = trim(above);
    return line.starts_with("#ifndef") && trim(line.substr(7)) == name;
  });
}

bool isSetByProfile(const ShaderPack& pack, const std::string& name) {
  const auto& profiles = pack.properties.profiles;
  return std::any_of(profiles.begin(), profiles.end(),
                     [&](const Profile& profile) { return profile.values.contains(name); });
}

constexpr std::array<std::string_view, 3> kKindNames = {"none", "each", "pairwise"};

}  // namespace

std::optional<MatrixKind> parseMatrixKind(std::string_view name) {
  const auto found = std::ranges::find(kKindNames, name);
  if (found == kKindNames.end()) return std::nullopt;
  return static_cast<MatrixKind>(found - kKindNames.begin());
}

std::string_view matrixKindName(MatrixKind kind) { return kKindNames.at(std::size_t(kind)); }

std::vector<MatrixAxis> matrixAxes(std::span<const ShaderPack> folders,
                                   const std::vector<std::string>& only) {
  std::vector<MatrixAxis> axes;
  if (folders.empty()) return axes;
  const ShaderPack& first = folders.front();
  const auto uses = usesOf(folders);
  const ShownOptions shown(first);
  for (const auto& [name, option] : first.options.all()) {
    const bool named = std::find(only.begin(), only.end(), name) != only.end();
    const bool chosen = only.empty() && (shown.contains(name) || isSetByProfile(first, name)) &&
                        !isIncludeGuard(first, name, option);
    if (!named && !chosen) continue;
    MatrixAxis axis{.option = name};
    const auto use = uses.find(name);
    // Nothing is known of how an option is used that is not in play yet.
    axis.inConditions = use == uses.end() || use->second.inConditions;
    axis.reach = use == uses.end() ? 0 : use->second.programs;
    axis.values.push_back(first.options.value(first.values, name));
    for (const std::string& value : option.values) {
      // An empty value is two blanks in the list, and reported as such.
      if (!value.empty() &&
          std::find(axis.values.begin(), axis.values.end(), value) == axis.values.end()) {
        axis.values.push_back(value);
      }
    }
    if (axis.values.size() > 1) axes.push_back(std::move(axis));
  }
  return axes;
}

void thinNumbers(std::vector<MatrixAxis>& axes) {
  constexpr std::size_t kFew = 3;
  for (MatrixAxis& axis : axes) {
    if (axis.values.size() > kFew && areNumbers(axis.values)) axis.values = thinned(axis);
  }
}

std::vector<OptionValues> matrixConfigurations(MatrixKind kind, const std::vector<MatrixAxis>& axes,
                                               const OptionSet& options, const OptionValues& base,
                                               const std::function<bool()>& stop) {
  if (kind == MatrixKind::None || axes.empty()) return {};
  return kind == MatrixKind::Each ? eachConfiguration(axes, options, base)
                                  : pairwiseConfigurations(axes, options, base, stop);
}

}  // namespace orris
