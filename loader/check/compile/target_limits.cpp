#include <orris/check/compile/target_limits.h>

#include <algorithm>
#include <array>

namespace orris {
namespace {

// Mesa: measured on 22.3 (llvmpipe, GL 4.5). NVIDIA, AMD: what their desktop drivers report for GL
// 4.6. Apple: the last OpenGL of macOS. Iris adds no limit of its own: its limits are those of the
// driver that Orris draws with, "minimum" has the minima of the GL 4.6 specification. OptiFine: its
// documentation (contract buffers.csv, macros.csv).
constexpr std::array<TargetLimits, 7> kTargets{{
    {.name = "iris",
     .fullName = "Mesa's software rasteriser",
     .glVendor = "Mesa",
     .glRenderer = "llvmpipe",
     .glVersion = 450},
    {.name = "mesa",
     .fullName = "Mesa's software rasteriser",
     .glVendor = "Mesa",
     .glRenderer = "llvmpipe",
     .glVersion = 450},
    {.name = "nvidia",
     .fullName = "NVIDIA",
     .glVendor = "NVIDIA Corporation",
     .glRenderer = "GeForce RTX 3060/PCIe/SSE2",
     .images = 8,
     .sharedMemoryBytes = 49152,
     .varyingComponents = 124},
    {.name = "amd",
     .fullName = "AMD",
     .glVendor = "ATI Technologies Inc.",
     .glRenderer = "AMD Radeon RX 6700 XT"},
    {.name = "apple",
     .fullName = "macOS",
     .glVendor = "Apple",
     .glRenderer = "Apple M1",
     .system = "MC_OS_MAC",
     .glVersion = 410,
     .glslVersion = 410,
     .compute = false,
     .samplers = 16,
     .images = 0,
     .sharedMemoryBytes = 0,
     .storageBuffers = 0,
     .varyingComponents = 124},
    {.name = "minimum",
     .fullName = "the least that GL 4.6 guarantees",
     .glVendor = "Mesa",
     .glRenderer = "llvmpipe",
     .samplers = 16,
     .images = 8,
     .storageBuffers = 8,
     .varyingComponents = 60},
    {.name = "optifine",
     .fullName = "OptiFine",
     .glVendor = "Mesa",
     .glRenderer = "llvmpipe",
     .iris = false,
     .samplers = 16,
     .images = 8,
     .storageBuffers = 0},
}};

}  // namespace

std::span<const TargetLimits> targetTable() { return kTargets; }

const TargetLimits* findTarget(std::string_view name) {
  const auto found = std::find_if(kTargets.begin(), kTargets.end(),
                                  [&](const TargetLimits& target) { return target.name == name; });
  return found == kTargets.end() ? nullptr : &*found;
}

HostDescription hostOf(const TargetLimits& target, const HostVersions& versions) {
  HostDescription host;
  host.versions = versions;
  host.glVendor = target.glVendor;
  host.glRenderer = target.glRenderer;
  host.system = target.system;
  host.iris = target.iris;
  host.glVersion = target.glVersion;
  // The numbers of GLSL follow those of GL; a driver may accept more than it advertises.
  host.glslVersion = target.glVersion;
  return host;
}

}  // namespace orris
