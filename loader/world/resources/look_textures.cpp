#include <orris/world/resources/look_textures.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include <orris/core/add_diagnostic.h>

namespace orris {
namespace {

constexpr std::string_view kQuarterTurn = "@90";

Image8 turnedImage(const Image8& image) {
  Image8 result(image.height, image.width, 4);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(image.at(x, y), 4, result.at(image.height - 1 - y, x));
  return result;
}

void turnImages(TileImages& images) {
  for (Image8* image : {&images.albedo, &images.normal, &images.specular})
    *image = turnedImage(*image);
}

void turnTexture(PackTexture& texture) {
  turnImages(texture.images);
  if (texture.animation)
    for (TileImages& frame : texture.animation->frames) turnImages(frame);
}

}  // namespace

void LookTextures::addOfModel(const std::string& name) {
  const auto parsed = parseResourceName(name);
  if (name == "missing" || !parsed || !names_.insert(name).second) return;
  if (auto texture = readTexture(resources_, *parsed, budget_, diagnostics_))
    return addOfPack(name, *std::move(texture));
  missing_.push_back(name);
  const std::size_t slash = parsed->path.rfind('/');
  add(name, {drawnTile(parsed->path.substr(slash == std::string::npos ? 0 : slash + 1))});
}

void LookTextures::addOwn(const std::string& name) {
  if (name == "missing" || !names_.insert(name).second) return;
  const bool turned = name.ends_with(kQuarterTurn);
  const std::string plain = turned ? name.substr(0, name.size() - kQuarterTurn.size()) : name;
  const auto parsed = parseResourceName("minecraft:block/" + plain);
  auto texture = parsed ? readTexture(resources_, *parsed, budget_, diagnostics_) : std::nullopt;
  if (!texture) {
    tiles_.push_back({name, drawnTile(name)});
    return;
  }
  if (turned) turnTexture(*texture);
  addOfPack(name, *std::move(texture));
}

void LookTextures::addFlowing(const std::string& still) {
  constexpr std::string_view kStill = "_still";
  if (!still.ends_with(kStill)) return;
  const std::string name = still.substr(0, still.size() - kStill.size()) + "_flow";
  if (flowing_.contains(still)) return;
  auto texture = readTexture(resources_, {"minecraft", "block/" + name}, budget_, diagnostics_);
  if (!texture) return;
  flowing_[still] = name;
  addOfPack(name, *std::move(texture));
}

bool LookTextures::addOf(const std::string& name, const ResourceName& file) {
  if (names_.contains(name)) return true;
  auto texture = readTexture(resources_, file, budget_, diagnostics_);
  if (!texture) return false;
  names_.insert(name);
  addOfPack(name, *std::move(texture));
  return true;
}

bool LookTextures::addStill(const std::string& name, const ResourceName& file) {
  if (names_.contains(name)) return true;
  AnimationBudget unused;
  auto texture = readTexture(resources_, file, unused, diagnostics_);
  if (!texture) return false;
  names_.insert(name);
  texture->animation.reset();
  addOfPack(name, *std::move(texture));
  return true;
}

void LookTextures::finish(BlockAtlas& atlas) {
  if (budget_.refused > 0)
    addWarning(diagnostics_, "resource-texture", {},
               fmt::format("{} animated textures of the resource packs stand still: expected at "
                           "most {} texels of all their frames",
                           budget_.refused, kMostFrameTexels));
  tiles_.push_back({"missing", drawnTile("missing")});
  if (packTiles(std::move(tiles_), atlas)) return;
  addWarning(diagnostics_, "resource-texture", {},
             "the largest textures of the resource packs are drawn at half of their size or less: "
             "they would not fit into one atlas");
}

void LookTextures::warnOfMissingTextures() {
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

std::vector<const Image8*> LookTextures::framesOf(const std::string& name) const {
  const auto found =
      std::find_if(tiles_.begin(), tiles_.end(), [&](const NamedTile& tile) { return tile.name == name; });
  if (found == tiles_.end()) return {};
  std::vector<const Image8*> frames = {&found->images.albedo};
  if (found->animation)
    for (const TileImages& frame : found->animation->frames) frames.push_back(&frame.albedo);
  return frames;
}

void LookTextures::add(const std::string& name, PackTexture texture) {
  const std::vector<std::uint8_t>& bytes = texture.images.albedo.pixels;
  for (std::size_t i = 3; i < bytes.size(); i += 4) {
    if (bytes[i] == 255) continue;
    seeThrough_.insert(name);
    break;
  }
  tiles_.push_back({name, std::move(texture.images), std::move(texture.animation)});
}

void LookTextures::addOfPack(const std::string& name, PackTexture texture) {
  ++ofPacks_;
  add(name, std::move(texture));
}

}  // namespace orris
