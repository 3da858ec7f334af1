// Standard uniforms: one table from Iris name to value. Contract: uniforms.csv.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <orris/pack/expressions/expression.h>
#include <orris/plan/frame/frame_state.h>

namespace orris {

/// entityId of an entity that the pack's entity.properties does not list. Contract: uniforms.csv.
inline constexpr int kUnlistedEntity = 65535;

/// What changes from draw to draw.
struct DrawState {
  glm::mat4 modelView{1}, projection{1}, textureMatrix{1};
  glm::vec3 chunkOffset{0};
  glm::ivec2 atlasSize{0}, gtextureSize{0};
  int gtextureId = 0;  ///< GL name of the texture of unit 0, 0 for none
  glm::ivec4 blendFunc{0};
  int renderStage = 0;  ///< MC_RENDER_STAGE_*
  float alphaTestRef = 0.1f;
  int alphaFunction = 7;        ///< bits: 1 less, 2 equal, 4 greater pass; 7: there is no test
  bool lightmapMatrix = false;  ///< texture matrices 1 and 2 are lightTextureMatrix()
  bool fullscreen = false;
  bool forcedDepth = false;  ///< the pack wants depth of what else writes none
  int blockEntityId = -1;
  int entityId = 0, itemId = -1;
  glm::vec4 entityColor{0};
};

struct UniformRow {
  std::string_view name;
  ValueType type;
  bool perDraw;  ///< depends on DrawState; not an input of custom uniforms
  Value (*value)(const FrameState&, const DrawState&);
};

/// Sorted by name.
std::span<const UniformRow> uniformTable();
const UniformRow* findUniform(std::string_view name);
/// Type of a uniform that custom uniforms may use; nullopt when there is none of that name.
std::optional<ValueType> expressionInput(const std::string& name);

/// GLSL type of every uniform that the host or one of the mods gives, by name.
std::map<std::string, std::string> uniformTypes();

Value valueOf(float v);
Value valueOf(const glm::vec2& v);
Value valueOf(const glm::vec3& v);
Value valueOf(const glm::vec4& v);
Value valueOf(const glm::ivec2& v);
Value valueOf(const glm::ivec3& v);
Value valueOf(const glm::mat3& m);
Value valueOf(const glm::mat4& m);

}  // namespace orris
