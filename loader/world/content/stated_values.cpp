#include <orris/world/content/stated_values.h>

#include <algorithm>
#include <cmath>

namespace orris {

const StatedUniform* findStated(std::string_view name) {
  const auto* found = std::ranges::find(kStatedUniforms, name, &StatedUniform::name);
  return found == kStatedUniforms.end() ? nullptr : found;
}

std::size_t componentCount(const StatedUniform& uniform) {
  return uniform.type == StatedType::IVec3 || uniform.type == StatedType::Vec3 ? 3 : 1;
}

bool takes(const StatedUniform& uniform, std::span<const float> values) {
  const bool whole = uniform.type != StatedType::Float && uniform.type != StatedType::Vec3;
  return values.size() == componentCount(uniform) && std::ranges::all_of(values, [&](float value) {
           const bool inside = value >= uniform.low && value <= uniform.high;  // false of NaN
           return inside && (!whole || value == std::floor(value));
         });
}

std::array<float, 3> valueIn(const StatedValues& values, const StatedUniform& uniform) {
  const auto found = values.find(uniform.name);
  return found == values.end() ? uniform.otherwise : found->second;
}

}  // namespace orris
