#include <orris/world/resources/block_models.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/blocks/block_data.h>
#include <orris/world/files/located_json.h>

namespace orris {
namespace {

/// With the values of properties that a state may leave out.
BlockProperties allProperties(const BlockState& state) {
  BlockProperties properties = state.properties;
  const std::size_t colon = state.name.find(':');
  const auto& blocks = blockData().blocks;
  const auto found = colon == std::string::npos || !state.name.starts_with("minecraft:")
                         ? blocks.end()
                         : blocks.find(state.name.substr(colon + 1));
  if (found != blocks.end())
    properties.insert(found->second.defaults.begin(), found->second.defaults.end());
  return properties;
}

int turnOf(int degrees) { return (degrees % 360 + 360) % 360; }

}  // namespace

const BlockStateFile* BlockModels::fileOf(const std::string& block) {
  const auto [entry, fresh] = files_.try_emplace(block);
  const auto name = fresh ? parseResourceName(block) : std::nullopt;
  if (name) {
    auto file = resources_.read(*name, kBlockStates, diagnostics_);
    if (file) entry->second = parseBlockStates(std::move(*file), diagnostics_);
  }
  return entry->second ? &*entry->second : nullptr;
}

BlockModel BlockModels::modelOf(const BlockState& state) {
  BlockModel model;
  const BlockStateFile* file = fileOf(state.name);
  if (!file) return model;
  const BlockProperties properties = allProperties(state);
  const ModelUses* variant = file->variantFor(properties);
  if (variant) addPart(*file, *variant, model);
  model.multipart = file->multipart;
  for (const auto& [when, uses] : file->parts) {
    if (when.holds(properties)) addPart(*file, uses, model);
  }
  const bool drawn =
      std::any_of(model.parts.begin(), model.parts.end(), [](const ModelChoice& part) {
        return std::any_of(part.alternatives.begin(), part.alternatives.end(),
                           [](const ModelAlternative& one) { return !one.faces->empty(); });
      });
  if (!drawn) model.parts.clear();
  return model;
}

void BlockModels::addPart(const BlockStateFile& file, const ModelUses& uses, BlockModel& model) {
  ModelChoice choice;
  for (const ModelUse& use : uses) {
    // Without the others some places would show nothing.
    ModelFaces faces = facesOfUse(file, use);
    if (!faces) continue;
    choice.alternatives.push_back({std::move(faces), use.weight});
    choice.totalWeight += use.weight;
  }
  if (!choice.alternatives.empty()) model.parts.push_back(std::move(choice));
}

ModelFaces BlockModels::facesOfUse(const BlockStateFile& file, const ModelUse& use) {
  const ModelTurn turn{turnOf(use.x), turnOf(use.y), use.uvLock};
  const auto [entry, fresh] = faces_.try_emplace({use.model, turn.x, turn.y, turn.uvLock});
  if (!fresh) return entry->second;
  const JsonText source{file.text, file.place, &kResourceJson};
  const ResolvedModel* model = library_.find(use.model, source.error(use.offset, "", "").at);
  if (!model) return nullptr;
  std::vector<ModelFace> faces = facesOf(*model, turn);
  if (faceCount_ + faces.size() > limits::kModelFaces) {
    diagnostics_.push_back(source.error(use.offset, "resource-model",
                                        fmt::format("with this model the blocks of the world have "
                                                    "more than {} faces, each counted once for "
                                                    "every turn; it is left out",
                                                    limits::kModelFaces)));
    faces.clear();
  }
  faceCount_ += faces.size();
  entry->second = std::make_shared<const std::vector<ModelFace>>(std::move(faces));
  return entry->second;
}

void BlockModels::warnOfMissing() {
  if (library_.missing().empty()) return;
  constexpr std::size_t kNamed = 8;
  std::vector<std::string> names;
  for (const auto& [name, uses] : library_.missing()) {
    if (names.size() < kNamed) names.push_back(name);
  }
  const std::size_t count = library_.missing().size();
  if (count > kNamed) names.push_back(fmt::format("and {} more", count - kNamed));
  addWarning(diagnostics_, "resource-missing", {},
             fmt::format("{} that blocks of this world use {} in none of the resource packs: {}",
                         count == 1 ? "a model" : fmt::format("{} models", count),
                         count == 1 ? "is" : "are", fmt::join(names, ", ")),
             "packs build on the game's own models: give the game's .jar as the last --resources");
}

}  // namespace orris
