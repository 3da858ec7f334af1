// Any bytes as a region file, or (so that mutations reach the tags) as the tags of a chunk, a chunk of
// entities or a level.dat.
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <orris/world/saved_things/saved_things.h>
#include <orris/world/saves/anvil_chunk.h>
#include <orris/world/saves/anvil_region.h>
#include <orris/world/saves/level_data.h>

namespace {

void parseTags(std::string_view tags) {
  orris::AnvilChunk chunk;
  std::string problem;
  const auto outcome = orris::parseAnvilChunk(tags, chunk, problem);
  if ((outcome == orris::ChunkOutcome::Unreadable) == problem.empty()) std::abort();
  orris::SavedThings things;
  orris::readEntityChunk(tags, things);
  if ((things.unreadableChunks == 0) != things.problem.empty()) std::abort();
  if (outcome == orris::ChunkOutcome::Read) orris::join(things, std::move(chunk.things));
  orris::keepNearest(things, {8, 8});
  for (const orris::SavedSign& sign : things.signs)
    orris::textsOf(sign, {"minecraft:oak_sign", {{"rotation", "4"}}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::string problem;
  if (bytes.starts_with("\x1f\x8b")) {
    if (!orris::parseLevelData(bytes, problem) && problem.empty()) std::abort();
    return 0;
  }
  if (bytes.starts_with("\x0a")) {
    parseTags(bytes);
    return 0;
  }
  const orris::AnvilRegion region(bytes, {0, 0});
  for (int i = 0; i < orris::kRegionChunks; ++i) {
    const auto tags = region.tags({i, 0}, nullptr, problem);
    if (tags) parseTags(*tags);
  }
  return 0;
}
