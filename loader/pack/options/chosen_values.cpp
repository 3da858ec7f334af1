#include <orris/pack/options/chosen_values.h>

#include <fmt/format.h>

#include <algorithm>

#include <orris/core/add_diagnostic.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

void applyProfile(const std::string& name, const std::vector<Profile>& profiles,
                  OptionValues& values, Diagnostics& diagnostics) {
  const auto found =
      std::find_if(profiles.begin(), profiles.end(), [&](auto& p) { return p.name == name; });
  if (found != profiles.end()) {
    for (const auto& [option, value] : found->values) values[option] = value;
    return;
  }
  std::vector<std::string> names;
  for (const Profile& profile : profiles) names.push_back(profile.name);
  const std::string hint = suggest(name, names);
  addError(diagnostics, "profile-unknown", {.file = "/shaders.properties"},
           fmt::format("the pack has no profile {}", name),
           !hint.empty()   ? hint
           : names.empty() ? "the pack has no profiles"
                           : "profiles are " + joinNames(names));
}

void applyRequested(const std::string& name, const std::string& value, const OptionSet& options,
                    OptionValues& values, Diagnostics& diagnostics) {
  const Option* option = options.find(name);
  if (!option) {
    std::vector<std::string> names;
    for (const auto& entry : options.all()) names.push_back(entry.first);
    addError(diagnostics, "option-unknown", {}, fmt::format("the pack has no option {}", name),
             suggest(name, names));
  } else if (std::find(option->values.begin(), option->values.end(), value) ==
             option->values.end()) {
    addError(diagnostics, "option-value", option->at.front(),
             fmt::format("{} cannot be {}", name, value),
             "its values are " + joinNames(option->values));
  } else {
    values[name] = value;
  }
}

}  // namespace

OptionValues chooseValues(const LoadRequest& request, const OptionSet& options,
                          const std::vector<Profile>& profiles, Diagnostics& diagnostics) {
  OptionValues values;
  for (const auto& [name, value] : request.fileValues) values[name] = value;
  if (!request.profile.empty()) applyProfile(request.profile, profiles, values, diagnostics);
  for (const auto& [name, value] : request.values) {
    applyRequested(name, value, options, values, diagnostics);
  }
  std::erase_if(values, [&](const auto& entry) {
    const Option* option = options.find(entry.first);
    const bool invalid =
        option && option->isBoolean && entry.second != "true" && entry.second != "false";
    return !option || invalid || option->defaultValue == entry.second;
  });
  return values;
}

const Profile* detectProfile(const std::vector<Profile>& profiles, const OptionSet& options,
                             const OptionValues& values) {
  // Iris: Profile.precedence counts unknown names too.
  const auto precedence = [](const Profile& p) { return p.values.size() + p.unknownNames.size(); };
  const Profile* best = nullptr;
  for (const Profile& profile : profiles) {
    const bool inForce = std::all_of(
        profile.values.begin(), profile.values.end(),
        [&](auto& entry) { return options.value(values, entry.first) == entry.second; });
    if (inForce && (!best || precedence(profile) > precedence(*best))) best = &profile;
  }
  return best;
}

}  // namespace orris
