// Checks of options: lists that do not fit, options that nothing uses, options nobody can reach.
#pragma once

#include <set>
#include <span>
#include <string_view>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Lists: a value given twice, a default that is missing, lines that differ in their lists.
void checkOptionLists(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// Options that no shader text and no properties file mentions outside their own definition.
void checkOptionUse(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

/// What a player can choose on the screens: all options of a pack without screens, or with `*` on one.
class ShownOptions {
 public:
  explicit ShownOptions(const ShaderPack& pack);
  bool all() const { return all_; }
  bool contains(std::string_view name) const { return all_ || names_.contains(name); }

 private:
  std::set<std::string_view> names_;
  bool all_ = false;
};

/// Options on no screen, in a pack whose screens do not show all the rest with `*`.
void checkHiddenOptions(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
