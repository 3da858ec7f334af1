// What `orris validate` prints of each pack, as text and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/validate/validate_run.h"

namespace orris {

/// A line with the counts, and one for each program that failed.
std::string toText(const PackVerdict& verdict);
nlohmann::json toJson(const PackVerdict& verdict);

}  // namespace orris
