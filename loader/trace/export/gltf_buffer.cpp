#include <orris/trace/export/gltf_buffer.h>

#include <bit>

namespace orris {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

constexpr int kGltfUnsigned = 5125, kGltfFloat = 5126;

}  // namespace

int GltfBuffer::addView(const void* data, std::size_t size, GltfTarget target) {
  nlohmann::json view = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}};
  if (target != GltfTarget::None) view["target"] = int(target);
  bytes.append(static_cast<const char*>(data), size);
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  views.push_back(std::move(view));
  return int(views.size()) - 1;
}

int GltfBuffer::addAccessor(int view, int componentType, std::size_t count, const char* type) {
  accessors.push_back(
      {{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
  return int(accessors.size()) - 1;
}

int GltfBuffer::add(const std::vector<glm::vec3>& values, GltfTarget target) {
  const int view = addView(values.data(), values.size() * sizeof(glm::vec3), target);
  const int accessor = addAccessor(view, kGltfFloat, values.size(), "VEC3");
  glm::vec3 low(values.at(0)), high(low);
  for (const glm::vec3& value : values) {
    low = glm::min(low, value);
    high = glm::max(high, value);
  }
  accessors.back()["min"] = {low.x, low.y, low.z};
  accessors.back()["max"] = {high.x, high.y, high.z};
  return accessor;
}

int GltfBuffer::add(const std::vector<glm::vec2>& values, GltfTarget target) {
  const int view = addView(values.data(), values.size() * sizeof(glm::vec2), target);
  return addAccessor(view, kGltfFloat, values.size(), "VEC2");
}

int GltfBuffer::add(const std::vector<std::uint32_t>& values, GltfTarget target) {
  const int view = addView(values.data(), values.size() * sizeof(std::uint32_t), target);
  return addAccessor(view, kGltfUnsigned, values.size(), "SCALAR");
}

}  // namespace orris
