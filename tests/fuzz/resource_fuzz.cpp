// Any texts as files of a resource pack: no crash, and faces that are numbers. The input is files, each after a
// line "@PATH" ("@/minecraft/blockstates/stone.json").
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include <orris/world/resources/block_models.h>
#include <orris/world/items/item_looks.h>

namespace {

std::map<std::string, std::string> filesOf(std::string_view text) {
  std::map<std::string, std::string> files;
  std::string* file = nullptr;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    if (line.starts_with('@')) {
      file = &files[std::string(line.substr(1, line.find_last_not_of('\n')))];
    } else if (file) {
      file->append(line);
    }
    text.remove_prefix(end);
  }
  return files;
}

void check(const orris::ModelFace& face) {
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec3& p = face.corners[i];
    if (!std::isfinite(p.x + p.y + p.z + face.uv[i].x + face.uv[i].y)) std::abort();
  }
  if (!(std::abs(glm::length(face.normal) - 1) < 1e-3f)) std::abort();
  if (!(std::abs(glm::length(glm::vec3(face.tangent)) - 1) < 1e-3f)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  orris::ResourceStack resources;
  resources.add("pack", orris::memorySource(filesOf({reinterpret_cast<const char*>(data), size})));
  orris::Diagnostics diagnostics;
  orris::BlockModels models(resources, diagnostics);
  for (const char* state :
       {"stone", "oak_fence[north=true,east=false]", "oak_stairs[facing=east,half=top]"}) {
    const orris::BlockModel model = models.modelOf(*orris::parseBlockState(state));
    for (const orris::ModelChoice& part : model.parts) {
      if (part.totalWeight < 1) std::abort();
      for (const orris::ModelAlternative& one : part.alternatives)
        for (const orris::ModelFace& face : *one.faces) check(face);
    }
  }
  models.warnOfMissing();
  orris::LookTextures textures(resources, diagnostics);
  const orris::BlockFacts facts;
  for (const auto& [item, look] :
       orris::makeItemLooks(resources, {{"minecraft:stick", {&facts, 1}}}, textures, diagnostics))
    for (const orris::ModelFace& face : *look.faces) check(face);
  if (orris::hasErrors(diagnostics)) std::abort();  // mistakes of packs are warnings
  return 0;
}
