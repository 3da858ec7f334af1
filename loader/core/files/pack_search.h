// Shader packs somewhere below a folder.
#pragma once

#include <string>
#include <vector>

namespace orris {

/// Paths of the packs below `folder`, sorted: folders that hold a folder `shaders` (`folder` itself
/// too) and zips that do. At most 4 levels down; hidden folders and symbolic links are left out, and
/// the search ends after 20000 entries.
std::vector<std::string> findPacks(const std::string& folder);

}  // namespace orris
