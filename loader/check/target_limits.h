// What a pack is validated for: the limits of a GL implementation, or the rules of another host.
#pragma once

#include <span>
#include <string_view>

namespace orris {

/// Limits that the compiler does not know; a pack that exceeds one fails on that target only.
struct TargetLimits {
  std::string_view name;  ///< as --target spells it
  int glslVersion = 450;  ///< highest #version
  bool compute = true;
  int samplersPerStage = 32;
  int imagesPerStage = 32;
  int drawBuffers = 8;
  int sharedMemoryBytes = 32768;
  int storageBuffers = 16;
  int vertexAttributes = 16;
  int varyingComponents = 128;
};

/// The first one is the default.
std::span<const TargetLimits> targetTable();
const TargetLimits* findTarget(std::string_view name);

}  // namespace orris
