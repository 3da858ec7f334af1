// What this process reads packs from: what its workers may still read once they are shut in.
#pragma once

#include <string>
#include <vector>

namespace orris {

/// A folder or file on the disk from which a pack's files are read when they are needed.
void addReadPlace(const std::string& path);
std::vector<std::string> readPlaces();

}  // namespace orris
