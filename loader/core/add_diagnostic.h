// How a mistake is reported that has no place in the text of shaders: of files, requests and worlds.
#pragma once

#include <utility>

#include <orris/core/diagnostic.h>

namespace orris {

/// Appends an error of a file, or of none (`at` empty). Always false, for functions that return
/// whether they succeeded.
inline bool addError(Diagnostics& diagnostics, std::string id, SourceLocation at,
                     std::string message, std::string hint = "") {
  diagnostics.push_back({.severity = Severity::Error,
                         .id = std::move(id),
                         .at = std::move(at),
                         .message = std::move(message),
                         .hint = std::move(hint)});
  return false;
}

/// The same as a warning.
inline void addWarning(Diagnostics& diagnostics, std::string id, SourceLocation at,
                       std::string message, std::string hint = "") {
  addError(diagnostics, std::move(id), std::move(at), std::move(message), std::move(hint));
  diagnostics.back().severity = Severity::Warning;
}

}  // namespace orris
