// The names of the contract that a program may declare, in one table: what the host sets, and what
// only other hosts or mods set. Contract: uniforms.csv, attributes.csv, buffers.csv.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/expressions/expression.h>

namespace orris {

enum class NameKind { Uniform, Sampler, Image, Attribute };
const char* nameKindWord(NameKind kind);  ///< "uniform", "sampler", ...

struct KnownName {
  std::string_view name;
  std::string_view type;  ///< of a uniform; "" when any will do
};

/// The type in GLSL: "ivec2".
std::string_view uniformTypeName(ValueType type);

/// nullptr when the contract does not know the name. Names of mods are known by their prefix.
const KnownName* findKnownName(NameKind kind, std::string_view name);

/// All names of a kind, for suggestions.
const std::vector<std::string>& knownNames(NameKind kind);

}  // namespace orris
