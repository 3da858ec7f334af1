// One blockstates file of a resource pack, as it stands in JSON.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {

/// A model as it is placed: turned first about x, then about y, in degrees.
struct ModelUse {
  std::string model;
  std::size_t offset = 0;  ///< of its name in the file
  int x = 0, y = 0;
  bool uvLock = false;  ///< textures stay as they lie when the model turns
  int weight = 1;
};
using ModelUses = std::vector<ModelUse>;  ///< one of them

/// A property has one of these values, or, negated, none of them.
struct PropertyTest {
  std::string name;
  std::vector<std::string> values;
  bool negated = false;
};

/// All tests hold and all of `all`, and one of `any` unless that is empty.
struct StateCondition {
  std::vector<PropertyTest> tests;
  std::vector<StateCondition> all, any;
  bool holds(const std::map<std::string, std::string>& properties) const;
};

/// `variants`: the one whose properties the state has; else `parts`: all whose condition holds.
struct BlockStateFile {
  std::vector<std::pair<std::map<std::string, std::string>, ModelUses>> variants;
  std::vector<std::pair<StateCondition, ModelUses>> parts;
  bool multipart = false;
  std::string text, place;  ///< for messages

  /// The variant for a state; of a property that the state lacks any value will do, rather than none.
  const ModelUses* variantFor(const std::map<std::string, std::string>& properties) const;
};

/// nullopt and warnings: the file says nothing of use.
std::optional<BlockStateFile> parseBlockStates(ResourceFile file, Diagnostics& diagnostics);

}  // namespace orris
