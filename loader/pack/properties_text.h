// The line format of *.properties files. Contract: properties.csv "(file)", idmaps.csv common.*.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.h"

namespace orris {

/// One key and its value; escapes resolved, continued lines joined.
struct PropertyEntry {
  std::string key;
  std::string value;
  SourceLocation at;       ///< of the key
  std::string sourceLine;  ///< the first line, as written
};

/// How a line that ends in a backslash goes on.
enum class Continuation {
  Java,          ///< with the next line, whatever it is
  Preprocessed,  ///< blanks may follow the backslash and blank lines are skipped
};

/// All entries in order of appearance, duplicates included.
std::vector<PropertyEntry> parseProperties(const std::string& file, std::string_view text,
                                           Continuation continuation);

/// Of each key the last value, at the place in the order where the key first appeared.
std::vector<PropertyEntry> lastValues(const std::vector<PropertyEntry>& entries);

/// A diagnostic at the entry's key.
Diagnostic propertyDiagnostic(Severity severity, std::string id, const PropertyEntry& entry,
                              std::string message, std::string hint = {});

}  // namespace orris
