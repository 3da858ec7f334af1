// Models of resource packs with what they inherit.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orris/world/resources/model_json.h>

namespace orris {

/// Elements, with the textures that their faces name: "minecraft:block/stone", or "" where no variable
/// of the model leads to one.
struct ResolvedModel {
  std::vector<ElementTemplate> elements;
  bool ambientOcclusion = true;
  std::vector<std::string> layers{};  ///< of a flat item: textures, one over the other
  DisplayPoses display{};             ///< without one: the item is put there as it is
};

/// Reads each file once.
class ModelLibrary {
 public:
  ModelLibrary(const ResourceStack& resources, Diagnostics& diagnostics)
      : resources_(resources), diagnostics_(diagnostics) {}

  /// nullptr and warnings: the model, or one that it inherits from, is absent or wrong. `askedAt` is where
  /// it is named.
  const ResolvedModel* find(const std::string& name, const SourceLocation& askedAt);
  /// Models that no pack has, and Orris neither: how often each was asked for.
  const std::map<std::string, int>& missing() const { return missing_; }

 private:
  std::optional<ResolvedModel> resolve(const std::string& name, const SourceLocation& askedAt);
  const ModelFile* file(const std::string& name, const SourceLocation& askedAt);
  void warn(const SourceLocation& at, std::string message, std::string hint = "");

  const ResourceStack& resources_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::optional<ModelFile>> files_;
  std::map<std::string, std::optional<ResolvedModel>> resolved_;
  std::map<std::string, int> missing_;
};

}  // namespace orris
