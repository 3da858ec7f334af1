#include <orris/world/resources/block_look.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/atlas/mixed_atlas.h>
#include <orris/world/mesh/block_mesh.h>
#include <orris/world/resources/block_models.h>
#include <orris/world/resources/texture_files.h>
#include <orris/world/saves/biome_climate.h>

namespace orris {
namespace {

constexpr std::string_view kQuarterTurn = "@90";

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
void learnShape(const BlockModel& model, const BlockLook& look, BlockFacts& facts) {
  constexpr int kAllSides = 0x3f;
  int sides = 0;
  for (const ModelFace& face : *model.parts.front().alternatives.front().faces) {
    const glm::vec3 across = face.corners[2] - face.corners[0];
    const bool whole = glm::dot(across, across) >= 2 && face.cull == face.direction;
    if (whole && !look.seeThrough.contains(face.texture)) sides |= 1 << int(face.direction);
  }
  facts = BlockFacts{};
  if (sides != kAllSides) return;
  facts.boxes.emplace_back();
  facts.coveredFaces = kAllSides;
  facts.fullOpaqueCube = true;
  facts.opacity = 15;
}

Image8 turnedImage(const Image8& image) {
  Image8 result(image.height, image.width, 4);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(image.at(x, y), 4, result.at(image.height - 1 - y, x));
  return result;
}

class LookTextures {
 public:
  LookTextures(const ResourceStack& resources, BlockLook& look, Diagnostics& diagnostics)
      : resources_(resources), look_(look), diagnostics_(diagnostics) {}

  /// A texture of a model; one that no pack has is drawn as ours of that name.
  void addOfModel(const std::string& name) {
    const auto parsed = parseResourceName(name);
    if (name == "missing" || !parsed || !names_.insert(name).second) return;
    if (auto texture = readTexture(resources_, *parsed, budget_, diagnostics_))
      return addOfPack(name, *std::move(texture));
    missing_.push_back(name);
    const std::size_t slash = parsed->path.rfind('/');
    add(name, {drawnTile(parsed->path.substr(slash == std::string::npos ? 0 : slash + 1))});
  }

  /// A texture of ours, which the packs may have by the same name.
  void addOwn(const std::string& name) {
    if (name == "missing" || !names_.insert(name).second) return;
    const bool turned = name.ends_with(kQuarterTurn);
    const std::string plain = turned ? name.substr(0, name.size() - kQuarterTurn.size()) : name;
    const auto parsed = parseResourceName("minecraft:block/" + plain);
    auto texture =
        parsed ? readTexture(resources_, *parsed, budget_, diagnostics_) : std::nullopt;
    if (!texture) {
      tiles_.push_back({name, drawnTile(name)});
      return;
    }
    if (turned) turn(*texture);
    addOfPack(name, *std::move(texture));
  }

  /// The texture of a fluid that flows, where a pack has one beside that of the still fluid.
  void addFlowing(const std::string& still) {
    constexpr std::string_view kStill = "_still";
    if (!still.ends_with(kStill)) return;
    const std::string name = still.substr(0, still.size() - kStill.size()) + "_flow";
    if (look_.flowing.contains(still)) return;
    auto texture = readTexture(resources_, {"minecraft", "block/" + name}, budget_, diagnostics_);
    if (!texture) return;
    look_.flowing[still] = name;
    addOfPack(name, *std::move(texture));
  }

  void finish(BlockAtlas& atlas) {
    if (budget_.refused > 0)
      addWarning(diagnostics_, "resource-texture", {},
                 fmt::format("{} animated textures of the resource packs stand still: expected at "
                             "most {} texels of all their frames",
                             budget_.refused, kMostFrameTexels));
    tiles_.push_back({"missing", drawnTile("missing")});
    if (packTiles(std::move(tiles_), atlas)) return;
    addWarning(
        diagnostics_, "resource-texture", {},
        "the largest textures of the resource packs are drawn at half of their size or less: "
        "they would not fit into one atlas");
  }

  void warnOfMissingTextures() {
    if (missing_.empty()) return;
    constexpr std::size_t kNamed = 8;
    const std::size_t named = std::min(kNamed, missing_.size());
    addWarning(
        diagnostics_, "resource-missing", {},
        fmt::format(
            "{} of models {} in none of the resource packs, and drawn as ours where there is "
            "one of that name: {}{}",
            missing_.size() == 1 ? "a texture" : fmt::format("{} textures", missing_.size()),
            missing_.size() == 1 ? "is" : "are",
            fmt::join(missing_.begin(), missing_.begin() + std::ptrdiff_t(named), ", "),
            named < missing_.size() ? ", ..." : ""),
        "give the game's .jar as the last --resources");
  }

 private:
  static void turn(PackTexture& texture) {
    turn(texture.images);
    if (texture.animation)
      for (TileImages& frame : texture.animation->frames) turn(frame);
  }
  static void turn(TileImages& images) {
    for (Image8* image : {&images.albedo, &images.normal, &images.specular})
      *image = turnedImage(*image);
  }

  void add(const std::string& name, PackTexture texture) {
    const std::vector<std::uint8_t>& bytes = texture.images.albedo.pixels;
    for (std::size_t i = 3; i < bytes.size(); i += 4) {
      if (bytes[i] == 255) continue;
      look_.seeThrough.insert(name);
      break;
    }
    tiles_.push_back({name, std::move(texture.images), std::move(texture.animation)});
  }
  void addOfPack(const std::string& name, PackTexture texture) {
    ++look_.textures;
    add(name, std::move(texture));
  }

  const ResourceStack& resources_;
  BlockLook& look_;
  Diagnostics& diagnostics_;
  std::set<std::string> names_;
  std::vector<std::string> missing_;
  std::vector<NamedTile> tiles_;
  AnimationBudget budget_;
};

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

void readTints(const ResourceStack& resources, const World& world, BlockLook& look,
               Diagnostics& diagnostics) {
  const ColorMaps maps{readPicture(resources, {"minecraft", "colormap/grass"}, diagnostics),
                       readPicture(resources, {"minecraft", "colormap/foliage"}, diagnostics)};
  const Environment& environment = world.environment;
  look.biomes = world.biomes;
  if (!look.biomes) {
    look.tints = {
        biomeTint(environment.biome, environment.temperature, environment.rainfall, maps)};
    return;
  }
  for (const std::string& biome : look.biomes->names) {
    const BiomeClimate climate = climateOf(biome);
    look.tints.push_back(biomeTint(biome, climate.temperature, climate.rainfall, maps));
  }
}

}  // namespace

BlockLook makeBlockLook(const ResourceStack& resources, const World& world,
                        std::vector<BlockFacts>& facts, BlockAtlas& atlas,
                        Diagnostics& diagnostics) {
  BlockLook look;
  readModels(resources, world.blocks, facts, look, diagnostics);
  LookTextures textures(resources, look, diagnostics);
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
    if (!model.parts.empty() && !facts[i].known) learnShape(model, look, facts[i]);
  }
  look.ownLook.assign(own.begin(), own.end());
  textures.warnOfMissingTextures();
  textures.finish(atlas);
  readTints(resources, world, look, diagnostics);
  return look;
}

BiomeTint BlockLook::tintAt(glm::ivec3 block) const {
  constexpr int kBlend = 2;  // blocks, the game's default
  if (!biomes) return tints[0];
  const std::uint8_t here = biomes->at(block);
  bool one = true;
  glm::ivec3 grass(0), foliage(0), dry(0), water(0);
  for (int z = -kBlend; z <= kBlend; ++z) {
    for (int x = -kBlend; x <= kBlend; ++x) {
      const std::uint8_t biome = biomes->at(block + glm::ivec3(x, 0, z));
      const BiomeTint& tint = tints[biome];
      one &= biome == here;
      grass += glm::ivec3(tint.grass);
      foliage += glm::ivec3(tint.foliage);
      dry += glm::ivec3(tint.dryFoliage);
      water += glm::ivec3(tint.water);
    }
  }
  constexpr int kPlaces = (2 * kBlend + 1) * (2 * kBlend + 1);
  if (one) return tints[here];
  return {glm::u8vec3(grass / kPlaces), glm::u8vec3(foliage / kPlaces), glm::u8vec3(dry / kPlaces),
          glm::u8vec3(water / kPlaces)};
}

}  // namespace orris
