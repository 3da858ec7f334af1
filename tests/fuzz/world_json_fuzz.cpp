// Any text as a world.json: no crash, and a world or an error.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <orris/world/files/world_json.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  orris::WorldJson json;
  json.text = std::string_view(reinterpret_cast<const char*>(data), size);
  json.file = "world.json";
  json.maximumBlocks = 1 << 15;  // keeps an input fast
  orris::Diagnostics diagnostics;
  const bool loaded = orris::parseWorldJson(json, diagnostics).has_value();
  if (loaded == orris::hasErrors(diagnostics)) std::abort();
  return 0;
}
