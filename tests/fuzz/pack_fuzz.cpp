// libFuzzer target: a whole pack in one text (pack_text.h).
#include <cstddef>
#include <cstdint>
#include <string>

#include <orris/pack/shader_pack.h>
#include "pack_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orris;
  const std::shared_ptr<const FileSource> source =
      memorySource(filesOfText(std::string(reinterpret_cast<const char*>(data), size)));
  // A few of the standard macros: each program defines them anew, which took a third of the time.
  static const MacroDefinitions kEnvironment = {
      {"MC_VERSION", "12101"}, {"IS_IRIS", ""}, {"MC_GL_VERSION", "460"}, {"MC_RENDER_STAGE_SKY", "2"}};
  for (const char* dimension : {"minecraft:overworld", "world-1"}) {
    LoadRequest request{.dimension = dimension, .environment = kEnvironment};
    Diagnostics diagnostics;
    const auto pack = loadShaderPack(source, request, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics) formatDiagnostic(diagnostic);
    if (!pack) continue;
    pack->currentProfile();
    pack->resolve("gbuffers_water");
    pack->sourceLine("/shaders.properties", 1);
  }
  return 0;
}
