// libFuzzer target: a whole pack; a line "=== /path" starts each file.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include <orris/pack/shader_pack.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orris;
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
  std::map<std::string, std::string> files;
  std::string* file = &files["/composite.fsh"];
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("=== ")) {
      file = &files[line.substr(4)];
    } else {
      *file += line + "\n";
    }
  }
  const std::shared_ptr<const FileSource> source = memorySource(std::move(files));
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
