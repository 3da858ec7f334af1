// What the window draws with the pack switched off: a pack of nothing but the host's own programs.
#pragma once

#include <memory>

#include <orris/core/files/file_source.h>

namespace orris {

std::shared_ptr<const FileSource> plainPack();

}  // namespace orris
