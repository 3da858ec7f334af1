// Collects the textures of a scene, of the resource packs or drawn by Orris, into an atlas.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <orris/world/atlas/mixed_atlas.h>
#include <orris/world/resources/resource_stack.h>
#include <orris/world/resources/texture_files.h>

namespace orris {

class LookTextures {
 public:
  LookTextures(const ResourceStack& resources, Diagnostics& diagnostics)
      : resources_(resources), diagnostics_(diagnostics) {}

  /// A texture of a model; one that no pack has is drawn as ours of that name.
  void addOfModel(const std::string& name);
  /// A texture of ours, which the packs may have by the same name.
  void addOwn(const std::string& name);
  /// The texture of a fluid that flows, where a pack has one beside that of the still fluid.
  void addFlowing(const std::string& still);
  /// As `name`. False: no pack has the texture, or (warnings) it cannot be used.
  bool addOf(const std::string& name, const ResourceName& file);
  /// The same without its animation.
  bool addStill(const std::string& name, const ResourceName& file);
  /// All that was added, and "missing".
  void finish(BlockAtlas& atlas);
  void warnOfMissingTextures();

  /// Names with texels that are not opaque.
  const std::set<std::string>& seeThrough() const { return seeThrough_; }
  /// Texture of a still fluid -> of the flowing one.
  const std::map<std::string, std::string>& flowing() const { return flowing_; }
  /// How many are of the packs.
  std::size_t ofPacks() const { return ofPacks_; }
  /// The colours of one that was added, of each frame; none: there is no such texture. Of use until the next is added.
  std::vector<const Image8*> framesOf(const std::string& name) const;

 private:
  void add(const std::string& name, PackTexture texture);
  void addOfPack(const std::string& name, PackTexture texture);

  const ResourceStack& resources_;
  Diagnostics& diagnostics_;
  std::set<std::string> names_, seeThrough_;
  std::map<std::string, std::string> flowing_;
  std::vector<std::string> missing_;
  std::vector<NamedTile> tiles_;
  AnimationBudget budget_;
  std::size_t ofPacks_ = 0;
};

}  // namespace orris
