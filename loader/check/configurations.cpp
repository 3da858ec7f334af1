#include "check/configurations.h"

#include <algorithm>
#include <map>
#include <set>

#include "check/covering_array.h"
#include "pack/folder_build.h"
#include "pack/text.h"

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
                                                 const OptionSet& options,
                                                 const OptionValues& base) {
  std::vector<int> levels;
  for (const MatrixAxis& axis : axes) levels.push_back(static_cast<int>(axis.values.size()));
  std::vector<OptionValues> result;
  for (const std::vector<int>& row : pairwiseRows(levels)) {
    OptionValues values = base;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      values = withValue(std::move(values), options, axes[i].option,
                         axes[i].values[static_cast<std::size_t>(row[i])]);
    }
    if (values != base) result.push_back(std::move(values));
  }
  return result;
}

}  // namespace

std::optional<MatrixKind> parseMatrixKind(std::string_view name) {
  if (name == "none") return MatrixKind::None;
  if (name == "each") return MatrixKind::Each;
  if (name == "pairwise") return MatrixKind::Pairwise;
  return std::nullopt;
}

std::vector<MatrixAxis> matrixAxes(std::span<const ShaderPack> folders,
                                   const std::vector<std::string>& only) {
  std::vector<MatrixAxis> axes;
  if (folders.empty()) return axes;
  const ShaderPack& first = folders.front();
  const auto uses = usesOf(folders);
  for (const auto& [name, option] : first.options.all()) {
    if (!only.empty() && std::find(only.begin(), only.end(), name) == only.end()) continue;
    MatrixAxis axis{.option = name};
    const auto use = uses.find(name);
    // Nothing is known of how an option is used that is not in play yet.
    axis.inConditions = use == uses.end() || use->second.inConditions;
    axis.reach = use == uses.end() ? 0 : use->second.programs;
    axis.values.push_back(first.options.value(first.values, name));
    for (const std::string& value : option.values) {
      if (std::find(axis.values.begin(), axis.values.end(), value) == axis.values.end()) {
        axis.values.push_back(value);
      }
    }
    if (axis.values.size() > 1) axes.push_back(std::move(axis));
  }
  return axes;
}

void thinNumbers(std::vector<MatrixAxis>& axes) {
  for (MatrixAxis& axis : axes) {
    constexpr std::size_t kFew = 3;
    if (axis.inConditions || axis.values.size() <= kFew) continue;
    // Numbers written alike, "0.5" or "12", by their value.
    std::map<bool, std::map<float, std::string>> byKind;
    bool numbers = true;
    for (const std::string& value : axis.values) {
      const auto number = parseFloat(value);
      if (!number) numbers = false;
      if (number) byKind[parseInteger(value).has_value()].emplace(*number, value);
    }
    if (!numbers) continue;
    std::vector<std::string> kept{axis.values.front()};
    for (const auto& [integer, values] : byKind) {
      for (const std::string& value : {values.begin()->second, values.rbegin()->second}) {
        if (std::find(kept.begin(), kept.end(), value) == kept.end()) kept.push_back(value);
      }
    }
    axis.values = std::move(kept);
  }
}

std::vector<OptionValues> matrixConfigurations(MatrixKind kind, const std::vector<MatrixAxis>& axes,
                                               const OptionSet& options, const OptionValues& base) {
  if (kind == MatrixKind::None || axes.empty()) return {};
  return kind == MatrixKind::Each ? eachConfiguration(axes, options, base)
                                  : pairwiseConfigurations(axes, options, base);
}

}  // namespace orris
