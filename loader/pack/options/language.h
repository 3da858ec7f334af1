// Texts of option screens. Contract: options.csv lang.files, lang.keys.
#pragma once

#include <map>
#include <string>

#include <orris/core/files/file_source.h>

namespace orris {

/// Every lang/<code>.lang, by lower-case code: key -> text.
std::map<std::string, std::map<std::string, std::string>> readLanguages(const FileSource& source,
                                                                        Diagnostics& diagnostics);

}  // namespace orris
