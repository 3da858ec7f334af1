// What an engine's draw callback may ask for and set.
#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>

#include <orris/api/renderer.h>

namespace orris::api {
namespace {

/// Names of a vertex attribute: of programs that declare it, and of the core text of old GLSL.
struct AttributeNames {
  const char* own;
  const char* core;
};
constexpr AttributeNames kAttributeNames[] = {{"vaPosition", "iris_Position"},
                                              {"vaUV0", "iris_UV0"},
                                              {"mc_midTexCoord", "iris_MidTexCoord"},
                                              {"vaNormal", "iris_Normal"},
                                              {"at_tangent", nullptr},
                                              {"vaColor", "iris_Color"},
                                              {"vaUV2", "iris_UV2"},
                                              {"at_midBlock", nullptr},
                                              {"mc_Entity", nullptr}};
static_assert(std::size(kAttributeNames) == ORRIS_ATTRIBUTE_ENTITY + 1);

}  // namespace
}  // namespace orris::api

using namespace orris::api;

OrrisStatus orris_draw_facts(OrrisDraw* handle, OrrisDrawFacts* facts) {
  return guardedInside([&] {
    const orris::EnginePass& pass = live(handle).pass;
    sized(facts, "facts");
    facts->kind = kindOf(pass.geometry());
    facts->shadow = pass.isShadow() ? 1 : 0;
    facts->patches = pass.patches() ? 1 : 0;
    facts->program = pass.program();
    facts->program_name = pass.name().c_str();
    for (int i = 0; i < 3; ++i) facts->camera_position[i] = pass.camera()[i];
    std::copy_n(glm::value_ptr(pass.view()), 16, facts->view);
    std::copy_n(glm::value_ptr(pass.projection()), 16, facts->projection);
  });
}

OrrisStatus orris_draw_attribute_location(OrrisDraw* handle, OrrisAttribute attribute,
                                          int32_t* out) {
  return guardedInside([&] {
    const orris::EnginePass& pass = live(handle).pass;
    refuseNull(out, "out");
    const auto index = static_cast<std::size_t>(attribute);
    if (index >= std::size(kAttributeNames))
      fail(ORRIS_ERROR_ARGUMENT, "attribute is no OrrisAttribute");
    const AttributeNames& names = kAttributeNames[index];
    *out = pass.attributeLocation(names.own);
    if (*out < 0 && names.core != nullptr) *out = pass.attributeLocation(names.core);
  });
}

OrrisStatus orris_draw_bind_vertices(OrrisDraw* handle, uint32_t stride, uint64_t offset) {
  return guardedInside([&] {
    const orris::EnginePass& pass = live(handle).pass;
    if (stride < sizeof(OrrisVertex) || stride > 2048)
      fail(ORRIS_ERROR_ARGUMENT, "stride must be 56 to 2048");
    pass.bindVertices({static_cast<int>(stride), offset});
  });
}

OrrisStatus orris_draw_set(OrrisDraw* handle, const OrrisBatch* values) {
  return guardedInside([&] {
    orris::EnginePass& pass = live(handle).pass;
    beginDraw(pass, checkedForDraw(sized(values, "values")));
  });
}
