#include <orris/world/resources/block_look.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/mesh/block_mesh.h>
#include <orris/world/resources/block_models.h>
#include <orris/world/resources/look_textures.h>
#include <orris/world/resources/texture_files.h>

namespace orris {
namespace {

std::size_t mostFaces(const BlockModel& model) {
  std::size_t sum = 0;
  for (const ModelChoice& part : model.parts) {
    std::size_t most = 0;
    for (const ModelAlternative& one : part.alternatives) most = std::max(most, one.faces->size());
    sum += most;
  }
  return sum;
}

std::vector<std::size_t> countsOf(const BlockWorld& blocks) {
  std::vector<std::size_t> counts(blocks.palette().size());
  const glm::ivec3 low = blocks.origin(), end = low + blocks.size();
  for (int y = low.y; y < end.y; ++y)
    for (int z = low.z; z < end.z; ++z)
      for (int x = low.x; x < end.x; ++x) ++counts[blocks.indexAt({x, y, z})];
  return counts;
}

/// Models so large that the mesh would take the machine's memory keep no face.
void dropTooManyFaces(const BlockWorld& blocks, BlockLook& look, Diagnostics& diagnostics) {
  constexpr std::size_t kUsual = 64;  // of a model: fences and walls have fewer
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < look.models.size(); ++i)
    if (mostFaces(look.models[i]) > kUsual) order.push_back(i);
  if (order.empty()) return;
  const std::vector<std::size_t> counts = countsOf(blocks);
  const auto faces = [&](std::size_t i) { return counts[i] * mostFaces(look.models[i]); };
  std::size_t total =
      std::accumulate(order.begin(), order.end(), std::size_t{0},
                      [&](std::size_t sum, std::size_t i) { return sum + faces(i); });
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(faces(b), a) < std::pair(faces(a), b);
  });
  for (const std::size_t i : order) {
    if (total <= limits::kModelMeshFaces) return;
    total -= faces(i);
    addWarning(diagnostics, "resource-model", {},
               fmt::format("{} has a model of {} faces and stands {} times in the world: expected "
                           "at most {} faces of "
                           "such "
                           "models in all; the block keeps its own look",
                           blocks.palette()[i].toString(), mostFaces(look.models[i]), counts[i],
                           limits::kModelMeshFaces));
    look.models[i].parts.clear();
  }
}

/// A block that only the packs know: an opaque cube where its faces are, else thin.
void learnShape(const BlockModel& model, const std::set<std::string>& seeThrough, BlockFacts& facts) {
  constexpr int kAllSides = 0x3f;
  int sides = 0;
  for (const ModelFace& face : *model.parts.front().alternatives.front().faces) {
    const glm::vec3 across = face.corners[2] - face.corners[0];
    const bool whole = glm::dot(across, across) >= 2 && face.cull == face.direction;
    if (whole && !seeThrough.contains(face.texture)) sides |= 1 << int(face.direction);
  }
  facts = BlockFacts{};
  if (sides != kAllSides) return;
  facts.boxes.emplace_back();
  facts.coveredFaces = kAllSides;
  facts.fullOpaqueCube = true;
  facts.opacity = 15;
}

void readModels(const ResourceStack& resources, const BlockWorld& blocks,
                std::vector<BlockFacts>& facts, BlockLook& look, Diagnostics& diagnostics) {
  BlockModels models(resources, diagnostics);
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const bool drawn = !facts[i].air && !facts[i].fluid;
    look.models.push_back(drawn ? models.modelOf(blocks.palette()[i]) : BlockModel{});
  }
  models.warnOfMissing();
  dropTooManyFaces(blocks, look, diagnostics);
}

}  // namespace

BlockLook makeBlockLook(const ResourceStack& resources, const World& world,
                        std::vector<BlockFacts>& facts, BlockAtlas& atlas,
                        Diagnostics& diagnostics) {
  BlockLook look;
  readModels(resources, world.blocks, facts, look, diagnostics);
  LookTextures textures(resources, diagnostics);
  std::set<std::string> own;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const BlockModel& model = look.models[i];
    if (!model.parts.empty()) {
      ++look.modelled;
    } else if (!facts[i].air && !facts[i].fluid) {
      own.insert(world.blocks.palette()[i].name);
    }
    for (const ModelChoice& part : model.parts)
      for (const ModelAlternative& one : part.alternatives)
        for (const ModelFace& face : *one.faces) textures.addOfModel(face.texture);
    if (model.parts.empty())
      for (const std::string& name : texturesOf(std::vector<BlockFacts>{facts[i]})) {
        textures.addOwn(name);
        if (facts[i].fluid) textures.addFlowing(name);
      }
    if (!model.parts.empty() && !facts[i].known) learnShape(model, textures.seeThrough(), facts[i]);
  }
  look.ownLook.assign(own.begin(), own.end());
  textures.warnOfMissingTextures();
  textures.finish(atlas);
  look.flowing = textures.flowing();
  look.seeThrough = textures.seeThrough();
  look.textures = textures.ofPacks();
  look.tints = tintsOf(world, {readPicture(resources, {"minecraft", "colormap/grass"}, diagnostics),
                               readPicture(resources, {"minecraft", "colormap/foliage"}, diagnostics)});
  return look;
}

}  // namespace orris
