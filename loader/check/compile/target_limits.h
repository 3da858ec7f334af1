// What a pack is validated for: the limits of a GL implementation, or the rules of another host.
#pragma once

#include <span>
#include <string_view>

#include <orris/pack/shader_pack.h>

namespace orris {

/// Limits that the compiler does not know; a pack that exceeds one fails on that target only.
/// Numbers of a stage unless said otherwise.
struct TargetLimits {
  std::string_view name;      ///< as --target spells it
  std::string_view fullName;  ///< for people: "Mesa"
  std::string_view glVendor, glRenderer;
  std::string_view system;  ///< macro of the operating system, "" for the one this runs on
  int glVersion = 460;
  int glslVersion = 460;  ///< highest #version
  bool iris = true;       ///< IS_IRIS, the feature flags and what else only Iris offers
  bool compute = true;
  int samplers = 32;
  int images = 32;
  int drawBuffers = 8;
  int sharedMemoryBytes = 32768;
  int storageBuffers = 16;
  int vertexAttributes = 16;
  int varyingComponents = 128;
};

/// The first one is the default.
std::span<const TargetLimits> targetTable();
const TargetLimits* findTarget(std::string_view name);

/// What the preprocessor macros say on the target.
HostDescription hostOf(const TargetLimits& target, const HostVersions& versions = {});

}  // namespace orris
