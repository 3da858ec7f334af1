#include <orris/plan/schedule/builtin_program.h>

namespace orris {
namespace {

constexpr const char* kVertex = R"(#version 450 compatibility
out vec2 uv;
out vec2 light;
out vec4 tint;
void main() {
  gl_Position = ftransform();
  uv = gl_MultiTexCoord0.xy;
  light = (gl_TextureMatrix[1] * gl_MultiTexCoord1).xy;
  tint = gl_Color;
}
)";
// Written through gl_FragData, so that the fixed-function alpha test applies.
constexpr const char* kTerrainFragment = R"(#version 450 compatibility
uniform sampler2D gtexture;
uniform sampler2D lightmap;
in vec2 uv;
in vec2 light;
in vec4 tint;
void main() { gl_FragData[0] = texture(gtexture, uv) * tint * texture(lightmap, light); }
)";
constexpr const char* kSkyFragment = R"(#version 450 compatibility
uniform sampler2D gtexture;
in vec2 uv;
in vec4 tint;
void main() { gl_FragData[0] = texture(gtexture, uv) * tint; }
)";

StageText stage(Stage kind, const char* text) {
  StageText result;
  result.stage = kind;
  result.text.text = text;
  return result;
}

}  // namespace

bool usesBuiltinSky(Geometry geometry) { return isSky(geometry) || isClouds(geometry); }

std::vector<StageText> builtinProgram(bool sky) {
  return {stage(Stage::Vertex, kVertex),
          stage(Stage::Fragment, sky ? kSkyFragment : kTerrainFragment)};
}

}  // namespace orris
