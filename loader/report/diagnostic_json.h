// Diagnostics as JSON, and JSON as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include <orris/core/diagnostic.h>

namespace orris {

nlohmann::json toJson(const SourceLocation& location);
nlohmann::json toJson(const Diagnostics& diagnostics);
/// JSON in ASCII, indented, with a final line feed: any bytes in its texts are safe to print.
std::string jsonText(const nlohmann::json& value);

}  // namespace orris
