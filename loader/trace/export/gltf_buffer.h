// The binary part of a glTF file: views and accessors of one buffer.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace orris {

/// Numbers of the glTF specification.
enum class GltfTarget { None = 0, Vertices = 34962, Indices = 34963 };

struct GltfBuffer {
  std::string bytes;  ///< every view begins at a multiple of 4
  nlohmann::json views = nlohmann::json::array(), accessors = nlohmann::json::array();

  /// Each returns the index of what it adds.
  int addView(const void* data, std::size_t size, GltfTarget target);
  int add(const std::vector<glm::vec3>& values, GltfTarget target);
  int add(const std::vector<glm::vec2>& values, GltfTarget target);
  int add(const std::vector<std::uint32_t>& values, GltfTarget target);

 private:
  int addAccessor(int view, int componentType, std::size_t count, const char* type);
};

}  // namespace orris
