// Which option values an option matrix tries.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pack/shader_pack.h"

namespace orris {

enum class MatrixKind { None, Each, Pairwise };
std::optional<MatrixKind> parseMatrixKind(std::string_view name);  ///< "none", "each", "pairwise"

/// One option and the values it takes in a matrix, the one in force first.
struct MatrixAxis {
  std::string option;
  std::vector<std::string> values;
  bool inConditions = false;  ///< a condition asks for it, so that its values may differ in kind
  std::size_t reach = 0;      ///< programs that it reaches as the options stand
};

/// The options of a pack, or those in `only` if that is not empty. Options that nothing in `folders`
/// asks for as the values stand are among them: other options may bring them into play.
std::vector<MatrixAxis> matrixAxes(std::span<const ShaderPack> folders,
                                   const std::vector<std::string>& only);

/// For a covering array: of values that no condition asks for and that are numbers of one kind, the
/// one in force, the smallest and the largest stand for all.
void thinNumbers(std::vector<MatrixAxis>& axes);

/// Complete values in the order in which they are to be tried, the most informative first, the ones
/// in force left out. `base` are the values in force.
std::vector<OptionValues> matrixConfigurations(MatrixKind kind, const std::vector<MatrixAxis>& axes,
                                               const OptionSet& options, const OptionValues& base);

}  // namespace orris
