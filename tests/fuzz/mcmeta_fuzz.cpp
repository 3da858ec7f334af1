// Any text as the .mcmeta of a texture of 32 x 96 texels: every frame lies in it.
#include <cstdint>
#include <cstdlib>
#include <string>

#include <orris/world/resources/texture_meta.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr glm::ivec2 kSize(32, 96);
  orris::Diagnostics diagnostics;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto meta = orris::parseTextureMeta({text, "fuzz"}, kSize, diagnostics);
  if (orris::hasErrors(diagnostics)) std::abort();  // mistakes of packs are warnings
  if (!meta) return 0;
  if (meta->steps.empty() || meta->width < 1 || meta->height < 1) std::abort();
  const int frames = (kSize.x / meta->width) * (kSize.y / meta->height);
  for (const orris::AnimationStep& step : meta->steps)
    if (step.frame < 0 || step.frame >= frames || step.ticks < 1) std::abort();
  return 0;
}
