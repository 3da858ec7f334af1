// The database of a Luanti world, map.sqlite: which map blocks it holds, and their bytes. Opened to read only; what of it is
// asked for is bounded in steps and memory, however the file was made.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace orris {

/// Map blocks have places from -2048 to 2047 along each axis: x east, y up, z north.
constexpr int kLowestMapBlock = -2048, kHighestMapBlock = 2047;

class MapDatabase {
 public:
  /// `file` is a regular file. nullptr and why not.
  static std::unique_ptr<MapDatabase> open(const std::string& file, std::string& problem);
  ~MapDatabase();

  /// Adds the places of those with this z and an x from `lowX` to `highX`, at any height. False and why not.
  bool addRow(int z, int lowX, int highX, std::vector<glm::ivec3>& places, std::string& problem);
  /// The columns x, z of the first limits::kMapPlaces, in no certain order.
  std::vector<glm::ivec2> firstColumns();
  /// What is stored of the one at `place`. nullopt and why not.
  std::optional<std::string> bytesAt(glm::ivec3 place, std::string& problem);

 private:
  struct Parts;
  explicit MapDatabase(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace orris
