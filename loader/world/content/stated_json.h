// The uniforms that a world.json states.
#pragma once

#include <orris/world/content/stated_values.h>
#include <orris/world/files/json_reader.h>

namespace orris {

/// Of the member "uniforms" of `environment`; mistakes are located errors.
StatedValues readStatedValues(JsonReader& reader, const JsonNode& environment);

}  // namespace orris
