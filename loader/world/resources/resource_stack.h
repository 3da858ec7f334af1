// The resource packs of a scene, one over the other, and the names of what is in them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/files/file_source.h>

namespace orris {

/// "minecraft:block/stone": letters that the game allows, and no part that leaves its folder.
struct ResourceName {
  std::string space, path;
  bool operator==(const ResourceName&) const = default;
  auto operator<=>(const ResourceName&) const = default;
  std::string text() const { return space + ":" + path; }
};

/// Without a colon the namespace is "minecraft". nullopt: the game would not take the name.
std::optional<ResourceName> parseResourceName(std::string_view text);

/// What a name stands for: "models" and ".json", "textures" and ".png".
struct ResourceKind {
  std::string_view folder, ending;
};
inline constexpr ResourceKind kBlockStates{"blockstates", ".json"}, kModels{"models", ".json"},
    kItems{"items", ".json"}, kTextures{"textures", ".png"}, kTextureMeta{"textures", ".png.mcmeta"};

struct ResourceFile {
  std::string bytes;
  std::string place;  ///< for messages: "Pack.zip/assets/minecraft/models/block/stone.json"
};

/// A file of an earlier pack hides those of the same name in the packs behind it, as the game's list of
/// packs does from its top down.
class ResourceStack {
 public:
  /// `label` names the pack in messages.
  void add(std::string label, std::unique_ptr<FileSource> files);
  bool contains(const ResourceName& name, ResourceKind kind) const;
  /// nullopt: no pack has it, or (a warning) it cannot be read.
  std::optional<ResourceFile> read(const ResourceName& name, ResourceKind kind,
                                   Diagnostics& diagnostics) const;

 private:
  struct Pack {
    std::string label;
    std::unique_ptr<FileSource> files;
  };
  std::vector<Pack> packs_;
};

/// Folders, zips or jars; nullopt and an error for one that cannot be opened.
std::optional<ResourceStack> openResources(const std::vector<std::string>& paths,
                                           Diagnostics& diagnostics);

}  // namespace orris
