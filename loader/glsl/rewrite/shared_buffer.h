// More shared memory than a driver has: rule shared-buffer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/glsl/compile/validate.h>

namespace orris {

inline constexpr const char* kSharedBufferRule = "shared-buffer";

struct SharedBuffers {
  StageText text;
  /// Storage blocks, one for each declaration moved. Each holds one array with an element for each
  /// work group of a dispatch, so that the size of the block with one element is that of a group.
  std::vector<std::string> blocks;
};

/// Arrays that a compute stage declares `shared` become arrays of storage buffers, in which each work
/// group has a part of its own; barriers order them as they order shared memory. Slower, and the same
/// values. nullopt: there are none, or a name stands for something else besides.
std::optional<SharedBuffers> moveSharedToBuffers(const StageText& stage);

}  // namespace orris
