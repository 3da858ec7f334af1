// How many keys of a kind a properties file may have.
#pragma once

#include <vector>

#include <orris/pack/files/properties_text.h>

namespace orris {

/// Takes the entries out that stand beyond the limits of their kind; an error for each kind.
void limitProperties(std::vector<PropertyEntry>& entries, Diagnostics& diagnostics);

}  // namespace orris
