// Any bytes as a schematic, compressed or (so that mutations reach the tags) the tags themselves.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <orris/world/files/schematic.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  orris::Diagnostics diagnostics;
  const bool loaded = bytes.starts_with("\x1f\x8b")
                          ? orris::parseSchematic(bytes, "fuzz", diagnostics).has_value()
                          : orris::parseSchematicTags(bytes, "fuzz", diagnostics).has_value();
  if (loaded == orris::hasErrors(diagnostics)) std::abort();
  return 0;
}
