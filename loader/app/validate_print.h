// What `orris validate` prints of each pack, as text and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/validate_run.h"

namespace orris {

void printText(const PackVerdict& verdict);
nlohmann::json toJson(const PackVerdict& verdict);

}  // namespace orris
