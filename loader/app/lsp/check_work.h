// One check of a pack for an editor: what `orris validate` reports of it, what an edit reaches first.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/lsp/overlay_source.h"
#include <orris/pack/shader_pack.h>
#include <orris/validate/validate_options.h>

namespace orris {

struct CheckJob {
  int number = 0;
  Overlay overlay;
  std::set<std::string> changed;  ///< files since the last whole check; empty: no hurry for some
};

/// What a whole check leaves for the next one: what no edit reaches is not done again.
struct CheckMemory {
  std::map<std::string, std::shared_ptr<const std::vector<ShaderPack>>> folders;  ///< as in Checker
  std::set<std::uint64_t> quiet;  ///< texts that nothing was reported of
};

/// Says {"part": "programs", "entries": [...], "findings": [...]} where an edit reaches some, then
/// {"part": "whole", "findings": [...]}. A finding is as in the JSON of `validate`, with its "uri" (a path),
/// "programs", and the edit "repair".
void checkForEditor(const std::string& path, const ValidateOptions& options, const CheckJob& job,
                    CheckMemory& memory, const std::function<void(nlohmann::json)>& say);

}  // namespace orris
