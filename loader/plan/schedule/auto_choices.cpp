#include <orris/plan/schedule/auto_choices.h>

#include <algorithm>

#include <orris/pack/options/auto_properties.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {
namespace {

/// What an option's candidates name and `known` lacks.
std::set<std::string> unknownQuantities(const std::vector<AutoCandidate>& candidates,
                                        const std::string& option, const Quantities& known) {
  std::set<std::string> names;
  for (const AutoCandidate& candidate : candidates) {
    if (candidate.option != option) continue;
    for (const std::string& name : candidate.quantities())
      if (!known.contains(name)) names.insert(name);
  }
  return names;
}

}  // namespace

std::vector<AutoCandidate> autoCandidates(const ShaderPack& pack) {
  const PackFiles& files = pack.builds.front()->files();
  if (!files.properties || !asksForAuto(pack.properties)) return {};
  Diagnostics reported;  // when the pack was loaded
  return parseAutoOptions(kPropertiesFile, *files.properties, pack.propertyMacros, pack.options,
                          reported);
}

std::vector<std::string> optionsAtAuto(const ShaderPack& pack) {
  std::vector<std::string> names;
  const std::vector<AutoCandidate> candidates = autoCandidates(pack);
  for (const AutoCandidate& candidate : candidates) {
    const bool known = std::find(names.begin(), names.end(), candidate.option) != names.end();
    if (!known && pack.options.value(pack.values, candidate.option) == kAutoValue)
      names.push_back(candidate.option);
  }
  return names;
}

std::string AutoChoices::present(const std::string& option) const {
  for (const AutoChoice& choice : choices_)
    if (choice.option == option) return choice.value;
  return "";
}

void AutoChoices::choose(const ShaderPack& asked, const LoadRequest& request,
                         const SceneMeter& meter) {
  const std::vector<std::string> options = optionsAtAuto(asked);
  std::vector<AutoChoice> choices;
  quantities_.clear();
  LoadRequest chosen = request;
  chosen.buildSources = false;
  for (const std::string& option : options) {
    // The pack's costs of one option may depend on what was chosen for another.
    Diagnostics reported;
    const auto outline =
        choices.empty() ? std::nullopt : rebuildShaderPack(asked, chosen, reported);
    const ShaderPack& pack = outline ? *outline : asked;
    const std::vector<AutoCandidate> candidates = autoCandidates(pack);
    // Some take longer to measure than a frame to draw: volumes of all that casts a shadow.
    const auto unknown = unknownQuantities(candidates, option, quantities_);
    if (!unknown.empty()) quantities_.merge(meter(unknown));
    AutoChoice choice = chooseAuto(candidates, option, quantities_, present(option));
    if (choice.value.empty()) choice.value = kAutoValue;
    chosen.values[option] = choice.value;
    choices.push_back(std::move(choice));
  }
  choices_ = std::move(choices);
}

LoadRequest AutoChoices::applied(LoadRequest request) const {
  for (const AutoChoice& choice : choices_) request.values[choice.option] = choice.value;
  return request;
}

std::string AutoChoices::text() const {
  std::string text;
  for (const AutoChoice& choice : choices_)
    text += (text.empty() ? "" : " ") + choice.option + "=" + choice.value;
  return text;
}

}  // namespace orris
