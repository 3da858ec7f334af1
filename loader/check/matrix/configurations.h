// Which option values an option matrix tries.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/shader_pack.h>

namespace orris {

enum class MatrixKind { None, Each, Pairwise };
std::optional<MatrixKind> parseMatrixKind(std::string_view name);  ///< "none", "each", "pairwise"
std::string_view matrixKindName(MatrixKind kind);

/// One option and the values it takes in a matrix, the one in force first.
struct MatrixAxis {
  std::string option;
  std::vector<std::string> values;
  bool inConditions = false;  ///< a condition asks for it, so that its values may differ in kind
  std::size_t reach = 0;      ///< programs that it reaches as the options stand
};

/// The options that a player can choose, on a screen or by a profile, or those in `only` if that is not
/// empty; include guards, which are options by the letter, only if they are named there. Options that nothing in `folders`
/// asks for as the values stand are among them: other options may bring them into play.
std::vector<MatrixAxis> matrixAxes(std::span<const ShaderPack> folders,
                                   const std::vector<std::string>& only);

/// For a covering array, where long lists multiply: of an option whose values are all numbers, the
/// one in force and of each kind, "0.5" or "12", the smallest and the largest stand for all; of one
/// that a condition asks for also 0, 1 and the neighbours of the one in force.
void thinNumbers(std::vector<MatrixAxis>& axes);

/// Complete values in the order in which they are to be tried, the most informative first, the ones
/// in force left out. `base` are the values in force. `stop` as for pairwiseRows().
std::vector<OptionValues> matrixConfigurations(
    MatrixKind kind, const std::vector<MatrixAxis>& axes, const OptionSet& options,
    const OptionValues& base, const std::function<bool()>& stop = [] { return false; });

}  // namespace orris
