// The options of a pack as its players see them: a tree of screens.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>

namespace orris {

/// The lines of one option, without indentation.
using OptionLines = std::function<std::vector<std::string>(const Option&)>;

/// Label of an option or screen in the language file, "" without one. Contract: options.csv.
std::string labelOf(const ShaderPack& pack, const std::string& key);

/// Does the name, label, value list or comment of an option have all the words in it, whatever the case?
bool matchesFilter(const ShaderPack& pack, const Option& option,
                   const std::vector<std::string>& words);

/// The screens from the main one on, below each its options, those on no screen last; a screen that two
/// others link to is written out once. Only options that `wanted` accepts, and screens that lead to one.
std::string optionTree(const ShaderPack& pack, const std::function<bool(const Option&)>& wanted,
                       const OptionLines& lines);

}  // namespace orris
