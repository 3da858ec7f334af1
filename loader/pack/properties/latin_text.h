// Characters at which Iris stops reading a *.properties file.
#pragma once

#include <string>
#include <string_view>

#include <orris/core/diagnostic.h>

namespace orris {

/// `preprocessed` up to the first character that Iris's preprocessor cannot take, with a warning where
/// there is one. It takes the bytes of the file for Latin-1: some end a line, and with it a comment,
/// others are no letters and end the file. `original` is what the author wrote, line by line the same.
/// Iris: PropertiesPreprocessor.
std::string upToForeignCharacter(const std::string& file, std::string_view original,
                                 std::string preprocessed, Diagnostics& diagnostics);

}  // namespace orris
