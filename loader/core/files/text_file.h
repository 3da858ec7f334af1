// The text files of a pack, refused before they are split into lines or tokens when they are larger than
// any pack needs (core/limits.h), or in an encoding that no host reads.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orris/core/files/file_source.h>

namespace orris {

struct TextFile {
  bool ok = false;
  std::string bytes;  ///< "" unless ok
  Diagnostic
      problem;  ///< an error at the file and line, unless ok; id "" when there is no such file
};

TextFile readTextFile(const FileSource& source, std::string_view path);

/// The text of a file that may be absent or refused, where that was or will be reported by others.
std::optional<std::string> readText(const FileSource& source, std::string_view path);

/// The same; a refused file is reported.
std::optional<std::string> readText(const FileSource& source, std::string_view path,
                                    Diagnostics& diagnostics);

/// UTF-16 by its mark, or by a zero beside each of the first letters.
bool isUtf16(std::string_view bytes);

/// The error that all texts of the pack together are too large at the file `path`.
Diagnostic packTextTooLarge(std::string_view path);

}  // namespace orris
