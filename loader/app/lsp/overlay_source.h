// The files of a pack with texts of an editor over them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include <orris/core/files/file_source.h>

namespace orris {

using Overlay = std::map<std::string, std::string>;  ///< pack path -> text

/// A text of the overlay takes the place of the file, and may be a file that is not there.
std::shared_ptr<const FileSource> overlaidSource(std::shared_ptr<const FileSource> files,
                                                 Overlay overlay);

}  // namespace orris
