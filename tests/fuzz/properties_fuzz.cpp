// libFuzzer target: shaders.properties, id maps and option files over arbitrary bytes.
#include <cstddef>
#include <cstdint>
#include <string>

#include <orris/pack/ids/id_map.h>
#include <orris/pack/properties/shader_properties.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orris;
  const std::string text(reinterpret_cast<const char*>(data), size);
  OptionSet options;
  options.all()["BLOOM"] = {
      .name = "BLOOM", .isBoolean = true, .defaultValue = "true", .values = {"true", "false"}};
  options.all()["Q"] = {.name = "Q", .defaultValue = "2", .values = {"1", "2"}};

  Diagnostics diagnostics;
  parseShaderProperties("/shaders.properties", text, {{"BLOOM", "1"}}, options, diagnostics);
  const BlockIdMap blocks = parseBlockProperties("/block.properties", text, text, diagnostics);
  blocks.idOf("minecraft:oak_leaves", {{"persistent", "true"}});
  parseIdProperties("/item.properties", text, text, "item.", diagnostics);
  writeOptionFile(options, parseOptionFile("pack.txt", text, options, diagnostics));
  for (const Diagnostic& diagnostic : diagnostics) formatDiagnostic(diagnostic);
  return 0;
}
