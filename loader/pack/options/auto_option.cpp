#include <orris/pack/options/auto_option.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace orris {
namespace {

constexpr std::array<SceneQuantity, 11> kQuantities{{
    {"pixels", "of the picture"},
    {"faces", "quads of blocks within the shadow distance of the eye"},
    {"extent", "longest side of the box about the eye and all that is drawn, in blocks"},
    {"casters", "quads that cast shadow volumes"},
    {"volumes", "triangles of the shadow volumes, the light where it stands"},
    {"casters_near", "casters within eight blocks of the eye"},
    {"lamps", "blocks that give light within the shadow distance of the eye"},
    {"lamps_reaching", "of them, how many reach a point that is seen, in the mean"},
    {"glass", "quads of translucent blocks but fluids within the shadow distance of the eye"},
    {"sun", "share of what is seen, 0 to 1, that the light of the sky comes near"},
    {"texel_pixels",
     "width of a texel of the shadow map in pixels, at the nearest tenth of what is "
     "seen"},
}};

double valueOf(const Quantities& scene, const std::string& name) {
  const auto found = scene.find(name);
  return found == scene.end() ? 0 : found->second;
}

}  // namespace

std::span<const SceneQuantity> sceneQuantities() { return kQuantities; }

double AutoCandidate::cost(const Quantities& scene) const {
  double sum = 0;
  for (const CostTerm& term : terms) {
    double product = term.factor;
    for (const std::string& name : term.quantities) product *= valueOf(scene, name);
    sum += product;
  }
  return sum;
}

bool AutoCandidate::allowed(const Quantities& scene) const {
  return std::all_of(conditions.begin(), conditions.end(), [&](const CostCondition& condition) {
    return (valueOf(scene, condition.quantity) < condition.bound) == condition.below;
  });
}

std::vector<std::string> AutoCandidate::quantities() const {
  std::vector<std::string> names;
  for (const CostTerm& term : terms)
    names.insert(names.end(), term.quantities.begin(), term.quantities.end());
  for (const CostCondition& condition : conditions) names.push_back(condition.quantity);
  return names;
}

std::string AutoCandidate::formula() const {
  std::string text;
  for (const CostTerm& term : terms)
    text += fmt::format("{}{:g}{}{}", text.empty() ? "" : " + ", term.factor,
                        term.quantities.empty() ? "" : " ", fmt::join(term.quantities, " "));
  for (const CostCondition& condition : conditions)
    text += fmt::format(" {} {} {} {:g}", &condition == &conditions.front() ? "if" : "and",
                        condition.quantity, condition.below ? "<" : ">=", condition.bound);
  return text;
}

AutoChoice chooseAuto(std::span<const AutoCandidate> candidates, const std::string& option,
                      const Quantities& scene, const std::string& present) {
  AutoChoice choice{option, "", {}};
  const AutoEstimate* best = nullptr;
  choice.candidates.reserve(candidates.size());  // `best` points into it
  for (const AutoCandidate& candidate : candidates) {
    if (candidate.option != option) continue;
    const AutoEstimate& estimate = choice.candidates.emplace_back(
        AutoEstimate{candidate.value, candidate.cost(scene), candidate.allowed(scene)});
    // Dearer in comparison than it is: what is not there must win clearly.
    const auto weight = [&](const AutoEstimate& e) {
      return e.milliseconds * (e.value == present ? kAutoChange : 1.0);
    };
    if (estimate.allowed && (!best || weight(estimate) < weight(*best))) best = &estimate;
  }
  if (best) choice.value = best->value;
  return choice;
}

}  // namespace orris
