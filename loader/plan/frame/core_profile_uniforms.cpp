#include <orris/plan/frame/core_profile_uniforms.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include <orris/plan/frame/fog.h>

namespace orris {
namespace {

glm::mat4 viewOf(const DrawState& d) { return glm::translate(d.modelView, d.chunkOffset); }

// The fullscreen projection has no inverse; GL takes the unit matrix then.
glm::mat4 inverseOr1(const DrawState& d, const glm::mat4& m) {
  return d.fullscreen ? glm::mat4(1) : glm::inverse(m);
}

using CS = const FrameState&;
using CD = const DrawState&;

constexpr UniformRow kCoreUniforms[] = {
    {"iris_ModelView", ValueType::Mat4, true, [](CS, CD d) { return valueOf(viewOf(d)); }},
    {"iris_Projection", ValueType::Mat4, true, [](CS, CD d) { return valueOf(d.projection); }},
    {"iris_ModelViewProjection", ValueType::Mat4, true,
     [](CS, CD d) { return valueOf(d.projection * viewOf(d)); }},
    {"iris_NormalMat", ValueType::Mat3, true,
     [](CS, CD d) { return valueOf(glm::transpose(glm::inverse(glm::mat3(viewOf(d))))); }},
    {"iris_ModelViewInverse", ValueType::Mat4, true,
     [](CS, CD d) { return valueOf(glm::inverse(viewOf(d))); }},
    {"iris_ProjectionInverse", ValueType::Mat4, true,
     [](CS, CD d) { return valueOf(inverseOr1(d, d.projection)); }},
    {"iris_ModelViewProjectionInverse", ValueType::Mat4, true,
     [](CS, CD d) { return valueOf(inverseOr1(d, d.projection * viewOf(d))); }},
    {"iris_LightTextureMatrix", ValueType::Mat4, true,
     [](CS, CD d) { return valueOf(d.lightmapMatrix ? lightTextureMatrix() : glm::mat4(1)); }},
    {"iris_FogColor", ValueType::Vec4, true,
     [](CS s, CD) { return valueOf(glm::vec4(s.environment.fogColor, 1)); }},
    {"iris_FogDensity", ValueType::Float, true, [](CS s, CD) { return valueOf(fogDensityOf(s)); }},
    {"iris_FogStart", ValueType::Float, true, [](CS s, CD d) { return valueOf(fogRangeOf(s, d.renderStage).start); }},
    {"iris_FogEnd", ValueType::Float, true,
     [](CS s, CD d) { return valueOf(fogRangeOf(s, d.renderStage).end); }},
    {"iris_AlphaFunction", ValueType::Int, true,
     [](CS, CD d) { return Value::ofInt(d.alphaFunction); }},
    {"iris_AlphaReference", ValueType::Float, true,
     [](CS, CD d) { return valueOf(d.alphaTestRef); }},
};

}  // namespace

const UniformRow* findCoreUniform(std::string_view name) {
  const auto* row = std::find_if(std::begin(kCoreUniforms), std::end(kCoreUniforms),
                                 [&](const UniformRow& r) { return r.name == name; });
  return row == std::end(kCoreUniforms) ? nullptr : row;
}

glm::mat4 lightTextureMatrix() {
  return glm::scale(glm::translate(glm::mat4(1), glm::vec3(1.0f / 32)), glm::vec3(1.0f / 256));
}

}  // namespace orris
