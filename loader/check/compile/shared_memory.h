// How much shared memory a compute shader takes, as Mesa counts it.
#pragma once

#include <cstdint>
#include <optional>

#include <orris/check/interface/stage_interface.h>

namespace orris {

/// Bytes of all used `shared` variables; nullopt when a size is not known. Mesa aligns a vec3 like a
/// vec4 and pads all array elements but the last one.
std::optional<std::int64_t> sharedMemoryBytes(const StageInterface& stage);

}  // namespace orris
