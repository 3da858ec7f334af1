#include <orris/world/items/item_looks.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/resources/block_models.h>
#include <orris/world/items/flat_item.h>
#include <orris/world/items/item_definition.h>
#include <orris/world/resources/model_library.h>

namespace orris {
namespace {

class ItemReader {
 public:
  ItemReader(const ResourceStack& resources, LookTextures& textures, Diagnostics& diagnostics)
      : resources_(resources),
        textures_(textures),
        diagnostics_(diagnostics),
        library_(resources, diagnostics),
        blocks_(resources, diagnostics) {}

  /// By its model; without one by the block's, or by the texture of its name.
  std::optional<ItemLook> read(const std::string& item, const BlockFacts& facts) {
    const auto name = parseResourceName(item);
    if (!name || facts.air) return std::nullopt;
    if (auto look = ofModel(modelOf(*name), !facts.boxes.empty())) return look;
    if (auto look = ofLayers({{name->space, "item/" + name->path}})) return look;
    if (facts.boxes.empty()) return std::nullopt;
    return ofBlock(item);
  }

  void warnOfMissing() {
    if (incomplete_.empty()) return;
    constexpr std::size_t kNamed = 8;
    const std::size_t count = incomplete_.size(), named = std::min(kNamed, count);
    addWarning(diagnostics_, "resource-missing", {},
               fmt::format("{} of items {} textures that are in none of the resource packs, and the "
                           "items keep the look of Orris: {}{}",
                           count == 1 ? "a model" : fmt::format("{} models", count),
                           count == 1 ? "has" : "have",
                           fmt::join(incomplete_.begin(),
                                     incomplete_.begin() + std::ptrdiff_t(named), ", "),
                           named < count ? ", ..." : ""),
               "give the game's .jar as the last --resources");
  }

 private:
  std::string modelOf(const ResourceName& item) {
    if (const auto file = resources_.read(item, kItems, diagnostics_))
      return parseItemDefinition(*file, diagnostics_).value_or("");
    return item.space + ":item/" + item.path;
  }

  std::optional<ItemLook> ofModel(const std::string& name, bool block) {
    const auto parsed = parseResourceName(name);
    if (!parsed || !resources_.contains(*parsed, kModels)) return std::nullopt;
    const ResolvedModel* model = library_.find(name, {});
    if (!model) return std::nullopt;
    if (!model->elements.empty()) return ofElements(name, facesOf(*model, {}), block);
    std::vector<ResourceName> layers;
    for (const std::string& layer : model->layers) layers.push_back(*parseResourceName(layer));
    return ofLayers(layers);
  }

  /// Textures of blocks that no pack has may be drawn as ours; those of other items are not.
  std::optional<ItemLook> ofElements(const std::string& name, std::vector<ModelFace> faces,
                                     bool block) {
    const bool complete = std::all_of(faces.begin(), faces.end(), [&](const ModelFace& face) {
      const auto texture = parseResourceName(face.texture);
      return texture && resources_.contains(*texture, kTextures);
    });
    if (complete || block) return ofFaces(std::move(faces));
    incomplete_.push_back(name);
    return std::nullopt;
  }

  /// Each texture that the packs have; a layer lies in front of the one before it.
  std::optional<ItemLook> ofLayers(const std::vector<ResourceName>& layers) {
    ItemLook look{.flat = true};
    std::vector<ModelFace> faces;
    for (const ResourceName& layer : layers) {
      const std::string name = layer.text();
      if (!resources_.contains(layer, kTextures) || !textures_.addStill(name, layer)) continue;
      for (ModelFace& face : flatItemFaces(name, *textures_.colours(name))) {
        moveOut(face, int(&layer - layers.data()));
        faces.push_back(std::move(face));
      }
    }
    if (faces.empty()) return std::nullopt;
    look.faces = std::make_shared<const std::vector<ModelFace>>(std::move(faces));
    return look;
  }

  /// Layers at one place would flicker.
  static void moveOut(ModelFace& face, int layer) {
    constexpr float kApart = 1.0f / 1024;
    for (glm::vec3& corner : face.corners) corner += face.normal * (kApart * float(layer));
  }

  std::optional<ItemLook> ofBlock(const std::string& block) {
    const BlockModel model = blocks_.modelOf({block, {}});
    std::vector<ModelFace> faces;
    for (const ModelChoice& part : model.parts) {
      const std::vector<ModelFace>& more = *part.alternatives.front().faces;
      faces.insert(faces.end(), more.begin(), more.end());
    }
    if (faces.empty()) return std::nullopt;
    return ofFaces(std::move(faces));
  }

  ItemLook ofFaces(std::vector<ModelFace> faces) {
    for (const ModelFace& face : faces) textures_.addOfModel(face.texture);
    return {std::make_shared<const std::vector<ModelFace>>(std::move(faces)), false};
  }

  std::vector<std::string> incomplete_;  // models
  const ResourceStack& resources_;
  LookTextures& textures_;
  Diagnostics& diagnostics_;
  ModelLibrary library_;
  BlockModels blocks_;
};

}  // namespace

std::map<std::string, ItemLook> makeItemLooks(const ResourceStack& resources,
                                              const std::map<std::string, ItemUse>& items,
                                              LookTextures& textures, Diagnostics& diagnostics) {
  ItemReader reader(resources, textures, diagnostics);
  std::map<std::string, ItemLook> looks;
  std::size_t sum = 0;
  for (const auto& [item, use] : items) {
    auto look = reader.read(item, *use.facts);
    if (!look) continue;
    const std::size_t faces = look->faces->size() * std::size_t(std::max(1, use.times));
    if (sum + faces > limits::kItemFaces) {
      addWarning(diagnostics, "resource-model", {},
                 fmt::format("the item {} has {} faces where it is seen: expected at most {} of all "
                             "items; it keeps its own look",
                             item, faces, limits::kItemFaces));
      continue;
    }
    sum += faces;
    looks.emplace(item, *std::move(look));
  }
  reader.warnOfMissing();
  return looks;
}

}  // namespace orris
