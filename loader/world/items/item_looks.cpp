#include <orris/world/items/item_looks.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/resources/block_models.h>
#include <orris/world/items/flat_item.h>
#include <orris/world/items/item_definition.h>
#include <orris/world/items/item_tints.h>
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
    const auto definition = definitionOf(*name);
    auto look = uncolored(*name, definition, facts);
    if (!look) return std::nullopt;
    for (const ModelFace& face : *look->faces) {
      if (face.tintIndex < 0) continue;
      look->tints[face.tintIndex] = definition ? tintOf(*definition, face.tintIndex)
                                               : itemTintByName(item, facts, face.tintIndex);
    }
    return look;
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
  /// nullopt: packs of games before 1.21.4 have none. One that says nothing has no model.
  std::optional<ItemDefinition> definitionOf(const ResourceName& item) {
    const auto file = resources_.read(item, kItems, diagnostics_);
    if (!file) return std::nullopt;
    return parseItemDefinition(*file, diagnostics_).value_or(ItemDefinition{});
  }

  static ItemTint tintOf(const ItemDefinition& definition, int index) {
    return std::size_t(index) < definition.tints.size() ? definition.tints[std::size_t(index)]
                                                        : ItemTint{};
  }

  std::optional<ItemLook> uncolored(const ResourceName& name,
                                    const std::optional<ItemDefinition>& definition,
                                    const BlockFacts& facts) {
    const std::string model = definition ? definition->model : name.space + ":item/" + name.path;
    if (auto look = ofModel(model, !facts.boxes.empty())) return look;
    if (auto look = ofLayers({{name.space, "item/" + name.path}}, posesOf("item/generated")))
      return look;
    if (facts.boxes.empty()) return std::nullopt;
    return ofBlock(name.text());
  }

  std::optional<ItemLook> ofModel(const std::string& name, bool block) {
    const auto parsed = parseResourceName(name);
    if (!parsed || !resources_.contains(*parsed, kModels)) return std::nullopt;
    const ResolvedModel* model = library_.find(name, {});
    if (!model) return std::nullopt;
    if (!model->elements.empty()) return ofElements(name, *model, block);
    std::vector<ResourceName> layers;
    for (const std::string& layer : model->layers) layers.push_back(*parseResourceName(layer));
    return ofLayers(layers, model->display);
  }

  /// Textures of blocks that no pack has may be drawn as ours; those of other items are not.
  std::optional<ItemLook> ofElements(const std::string& name, const ResolvedModel& model,
                                     bool block) {
    std::vector<ModelFace> faces = facesOf(model, {});
    const bool complete = std::all_of(faces.begin(), faces.end(), [&](const ModelFace& face) {
      const auto texture = parseResourceName(face.texture);
      return texture && resources_.contains(*texture, kTextures);
    });
    if (complete || block) return ofFaces(std::move(faces), model.display);
    incomplete_.push_back(name);
    return std::nullopt;
  }

  /// Each texture that the packs have; a layer lies in front of the one before it.
  std::optional<ItemLook> ofLayers(const std::vector<ResourceName>& layers,
                                   const DisplayPoses& poses) {
    std::vector<ModelFace> faces;
    for (const ResourceName& layer : layers) {
      const std::string name = layer.text();
      if (!resources_.contains(layer, kTextures) || !textures_.addOf(name, layer)) continue;
      for (ModelFace& face : flatItemFaces(name, textures_.framesOf(name))) {
        face.tintIndex = int(&layer - layers.data());
        moveOut(face, face.tintIndex);
        faces.push_back(std::move(face));
      }
    }
    if (faces.empty()) return std::nullopt;
    return ItemLook{std::make_shared<const std::vector<ModelFace>>(std::move(faces)), poses, {}};
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
    return ofFaces(std::move(faces), posesOf("block/block"));
  }

  DisplayPoses posesOf(const std::string& parent) {
    const ResolvedModel* model = library_.find(parent, {});
    return model ? model->display : DisplayPoses{};
  }

  ItemLook ofFaces(std::vector<ModelFace> faces, const DisplayPoses& poses) {
    for (const ModelFace& face : faces) textures_.addOfModel(face.texture);
    return {std::make_shared<const std::vector<ModelFace>>(std::move(faces)), poses, {}};
  }

  std::vector<std::string> incomplete_;  // models
  const ResourceStack& resources_;
  LookTextures& textures_;
  Diagnostics& diagnostics_;
  ModelLibrary library_;
  BlockModels blocks_;
};

}  // namespace

glm::vec3 ItemLook::tintOf(int tintIndex, const std::optional<glm::vec3>& dye) const {
  const auto found = tints.find(tintIndex);
  if (found == tints.end()) return glm::vec3(1);
  return dye && found->second.takesDye ? *dye : glm::vec3(found->second.color) / 255.0f;
}

DisplayPose ItemLook::poseOf(DisplayPlace place) const {
  const DisplayPose pose = poses[std::size_t(place)].value_or(DisplayPose{});
  // The game mirrors what it is given for the left hand, too.
  const bool left = place == DisplayPlace::FirstLeft || place == DisplayPlace::ThirdLeft;
  return left ? mirroredPose(pose) : pose;
}

glm::mat4 ItemLook::posed(DisplayPlace place) const { return poseMatrix(poseOf(place)); }

DisplayPose mirroredPose(DisplayPose pose) {
  pose.translation.x = -pose.translation.x;
  pose.degrees *= glm::vec3(1, -1, -1);
  return pose;
}

glm::mat4 poseMatrix(const DisplayPose& pose) {
  glm::mat4 m = glm::translate(glm::mat4(1), pose.translation / 16.0f);
  for (const int axis : {0, 1, 2}) {
    glm::vec3 around(0);
    around[axis] = 1;
    m = glm::rotate(m, glm::radians(pose.degrees[axis]), around);
  }
  return glm::translate(glm::scale(m, pose.scale), glm::vec3(-0.5f));
}

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
