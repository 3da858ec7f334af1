// Files that a user names to be read or written: what is wrong with one is a message about it.
#pragma once

#include <optional>
#include <string>

#include <orris/core/diagnostic.h>

namespace orris {

/// Reads a whole file of at most kMaxTextBytes, no link out of its folder; nullopt: file-unreadable.
std::optional<std::string> readNamedFile(const std::string& path, Diagnostics& diagnostics);
/// The same for a file of a folder, which no link may lead out of.
std::optional<std::string> readNamedFileBelow(const std::string& folder, const std::string& name,
                                              Diagnostics& diagnostics);

/// Can a file be created at `path`? Nothing is changed there. false: file-unwritable.
bool canWriteNamedFile(const std::string& path, Diagnostics& diagnostics);
/// Writes a whole file by way of a temporary one, so that no partial file is ever left; false:
/// file-unwritable.
bool writeNamedFile(const std::string& path, const std::string& text, Diagnostics& diagnostics);

}  // namespace orris
