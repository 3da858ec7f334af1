// Diagnostics as bytes, to pass them between processes.
#pragma once

#include <string>
#include <string_view>

#include <orris/core/diagnostic.h>

namespace orris {

std::string encodeDiagnostics(const Diagnostics& diagnostics);
/// What encodeDiagnostics() was given.
Diagnostics decodeDiagnostics(std::string_view bytes);

}  // namespace orris
