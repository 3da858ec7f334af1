#include <orris/render/draw/pass_state.h>

#include <algorithm>
#include <cctype>
#include <glm/gtc/type_ptr.hpp>
#include <string>

#include <orris/plan/frame/core_profile_uniforms.h>
#include <orris/plan/frame/fog.h>
#include <orris/gl/functions.h>

namespace orris {
namespace {

struct NamedEnum {
  std::string_view name;
  unsigned value;
};
constexpr NamedEnum kFactors[] = {{"ZERO", GL_ZERO},
                                  {"ONE", GL_ONE},
                                  {"SRC_COLOR", GL_SRC_COLOR},
                                  {"ONE_MINUS_SRC_COLOR", GL_ONE_MINUS_SRC_COLOR},
                                  {"DST_COLOR", GL_DST_COLOR},
                                  {"ONE_MINUS_DST_COLOR", GL_ONE_MINUS_DST_COLOR},
                                  {"SRC_ALPHA", GL_SRC_ALPHA},
                                  {"ONE_MINUS_SRC_ALPHA", GL_ONE_MINUS_SRC_ALPHA},
                                  {"DST_ALPHA", GL_DST_ALPHA},
                                  {"ONE_MINUS_DST_ALPHA", GL_ONE_MINUS_DST_ALPHA},
                                  {"SRC_ALPHA_SATURATE", GL_SRC_ALPHA_SATURATE}};
constexpr NamedEnum kFunctions[] = {
    {"NEVER", GL_NEVER},   {"LESS", GL_LESS},       {"EQUAL", GL_EQUAL},
    {"LEQUAL", GL_LEQUAL}, {"GREATER", GL_GREATER}, {"NOTEQUAL", GL_NOTEQUAL},
    {"GEQUAL", GL_GEQUAL}, {"ALWAYS", GL_ALWAYS},   {"GL_ALWAYS", GL_ALWAYS}};

template <size_t N>
unsigned lookup(const NamedEnum (&table)[N], const std::string& name, unsigned fallback) {
  const auto* it = std::find_if(std::begin(table), std::end(table),
                                [&](const NamedEnum& e) { return e.name == name; });
  return it == std::end(table) ? fallback : it->value;
}

constexpr glm::ivec4 kNoBlend(0);
constexpr glm::ivec4 kTranslucentBlend(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
                                       GL_ONE_MINUS_SRC_ALPHA);
constexpr glm::ivec4 kAdditive(GL_SRC_ALPHA, GL_ONE, GL_ONE, GL_ZERO);

// Iris: ProgramId has that of eyes; the others are the game's.
glm::ivec4 factorsOf(DefaultBlend blend) {
  switch (blend) {
    case DefaultBlend::Translucent:
      return kTranslucentBlend;
    case DefaultBlend::Additive:
      return kAdditive;
    case DefaultBlend::Lightning:
      return {GL_SRC_ALPHA, GL_ONE, GL_SRC_ALPHA, GL_ONE};
    case DefaultBlend::Eyes:
      return {GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_ONE};
    case DefaultBlend::Glint:
      return {GL_SRC_COLOR, GL_ONE, GL_ZERO, GL_ONE};
    case DefaultBlend::Cracks:
      return {GL_DST_COLOR, GL_SRC_COLOR, GL_ONE, GL_ZERO};
    case DefaultBlend::Off:
      break;
  }
  return kNoBlend;
}

glm::ivec4 factorsOf(const BlendMode& mode) {
  if (mode.off) return kNoBlend;
  glm::ivec4 factors;
  for (int i = 0; i < 4; ++i)
    factors[i] = static_cast<int>(lookup(kFactors, mode.factors[i], GL_ONE));
  return factors;
}

void applyBlend(const glm::ivec4& f) {
  if (f == kNoBlend) return gl::Disable(GL_BLEND);
  gl::Enable(GL_BLEND);
  gl::BlendFuncSeparate(f[0], f[1], f[2], f[3]);
}

// Sets one draw buffer's blending apart from the others'.
void applyBufferBlend(const Step& step, const ProgramSource& program) {
  for (const auto& [buffer, mode] : program.bufferBlend)
    for (size_t slot = 0; slot < step.writes.size(); ++slot) {
      const std::string prefix = step.kind == Step::Kind::DrawShadow ? "shadowcolor" : "colortex";
      if (buffer != prefix + std::to_string(step.writes[slot])) continue;
      const glm::ivec4 f = factorsOf(mode);
      const auto index = static_cast<unsigned>(slot);
      if (f == kNoBlend) {
        gl::Disablei(GL_BLEND, index);
      } else {
        gl::Enablei(GL_BLEND, index);
        gl::BlendFuncSeparatei(index, f[0], f[1], f[2], f[3]);
      }
    }
}

glm::ivec4 defaultBlend(const Step& step) {
  if (step.kind == Step::Kind::DrawShadow) return kNoBlend;
  if (const ContentKind* kind = findContentKind(step.geometry)) return factorsOf(kind->blend);
  switch (step.geometry) {
    case Geometry::Translucent:
    case Geometry::CloudsFast:
    case Geometry::CloudsFancy:
      return kTranslucentBlend;
    case Geometry::Stars:
    case Geometry::SunMoon:
      return kAdditive;
    default:
      return kNoBlend;
  }
}

// Iris: ShaderKey. Cutout terrain, block entities and clouds always, every textured shadow caster
// but solid terrain.
bool hasDefaultAlphaTest(const Step& step) {
  return step.geometry == Geometry::Cutout || step.geometry == Geometry::BlockEntity ||
         isClouds(step.geometry) ||
         (step.kind == Step::Kind::DrawShadow && step.geometry == Geometry::Translucent);
}

void setAlphaTest(const Step& step, const ProgramSource* program, DrawState& draw) {
  AlphaTest test;
  test.off = !hasDefaultAlphaTest(step);
  if (const ContentKind* kind = findContentKind(step.geometry)) {
    test.off = kind->alphaReference < 0;
    test.reference = kind->alphaReference;
  }
  if (program != nullptr && program->alphaTest) test = *program->alphaTest;
  draw.alphaTestRef = test.off ? 0.0f : test.reference;
  // Iris adds its discard only to programs that write gl_FragData or gl_FragColor.
  const bool applies = program == nullptr || program->writesFragData;
  if (test.off || !applies) return unsetAlphaTest();
  const unsigned function = lookup(kFunctions, test.function, GL_GREATER);
  draw.alphaFunction = static_cast<int>(function - GL_NEVER);
  if (gl::isCoreProfile()) return;
  gl::Enable(GL_ALPHA_TEST);
  gl::AlphaFunc(function, test.reference);
}

void setColorMasks(const Step& step, std::uint32_t outputs, GLboolean on) {
  for (std::size_t slot = 0; slot < step.writes.size() && slot < 32; ++slot)
    if ((outputs >> slot & 1) == 0) gl::ColorMaski(static_cast<unsigned>(slot), on, on, on, on);
}

void loadTextureMatrix(int unit, const glm::mat4& matrix) {
  gl::ActiveTexture(GL_TEXTURE0 + unit);
  gl::MatrixMode(GL_TEXTURE);
  gl::LoadMatrixf(glm::value_ptr(matrix));
}

/// Passes all. Mesa's software rasteriser compiles a program that tests nothing twice, for pixels inside and at
/// edges of triangles, which a pass over the screen has none of.
void setPassingAlphaTest() {
  if (gl::isCoreProfile()) return;
  gl::Enable(GL_ALPHA_TEST);
  gl::AlphaFunc(GL_ALWAYS, 0);
}

}  // namespace

glm::mat4 fullscreenProjection() {
  glm::mat4 m(0);
  m[0][0] = m[1][1] = 2;
  m[3] = glm::vec4(-1, -1, 0, 1);
  return m;
}

int renderStageOf(Geometry geometry) {
  if (const ContentKind* kind = findContentKind(geometry)) return kind->renderStage;
  switch (geometry) {
    case Geometry::Sky:
    case Geometry::EndSky:
      return 1;
    case Geometry::SunMoon:
      return 4;
    case Geometry::Stars:
      return 6;
    case Geometry::Solid:
      return 8;
    case Geometry::Cutout:
      return 10;
    case Geometry::BlockEntity:
      return 12;
    case Geometry::Translucent:
      return 17;
    case Geometry::CloudsFast:
    case Geometry::CloudsFancy:
      return 20;
    default:
      return 0;
  }
}

void setFullscreenState(const ProgramSource* program, DrawState& draw) {
  gl::Disable(GL_DEPTH_TEST);
  gl::DepthMask(GL_FALSE);
  gl::Disable(GL_CULL_FACE);
  setPassingAlphaTest();
  draw.fullscreen = true;
  draw.blendFunc = program != nullptr && program->blend ? factorsOf(*program->blend) : kNoBlend;
  applyBlend(draw.blendFunc);
  draw.projection = fullscreenProjection();
  loadMatrices(draw, false);
}

void setGeometryState(const Step& step, const ProgramSource* program, DrawState& draw) {
  const ContentKind* kind = findContentKind(step.geometry);
  const bool sky = isSky(step.geometry), shadow = step.kind == Step::Kind::DrawShadow;
  gl::Enable(GL_DEPTH_TEST);
  // The glint lies on what was drawn with the same vertices.
  gl::DepthFunc(isGlint(step.geometry) ? GL_EQUAL : GL_LEQUAL);
  const bool writesDepth = kind == nullptr || shadow || kind->writesDepth || draw.forcedDepth;
  gl::DepthMask(sky || !writesDepth ? GL_FALSE : GL_TRUE);
  // Contract programs.csv "shadow": back faces are drawn there. Flat clouds are seen from above too.
  const bool culled = kind != nullptr ? kind->culled : step.geometry != Geometry::CloudsFast;
  if (!sky && !shadow && culled)
    gl::Enable(GL_CULL_FACE);
  else
    gl::Disable(GL_CULL_FACE);
  gl::CullFace(GL_BACK);
  gl::FrontFace(GL_CCW);
  draw.blendFunc =
      program != nullptr && program->blend ? factorsOf(*program->blend) : defaultBlend(step);
  applyBlend(draw.blendFunc);
  if (program != nullptr) applyBufferBlend(step, *program);
  setAlphaTest(step, program, draw);
  draw.renderStage = renderStageOf(step.geometry);
}

void loadMatrices(DrawState& draw, bool lightmapMatrix) {
  draw.lightmapMatrix = lightmapMatrix;
  if (gl::isCoreProfile()) return;
  const glm::mat4 light = lightmapMatrix ? lightTextureMatrix() : glm::mat4(1);
  loadTextureMatrix(0, draw.textureMatrix);
  loadTextureMatrix(1, light);
  loadTextureMatrix(2, light);
  gl::MatrixMode(GL_PROJECTION);
  gl::LoadMatrixf(glm::value_ptr(draw.projection));
  loadModelView(draw.modelView);
}

void loadModelView(const glm::mat4& modelView) {
  if (gl::isCoreProfile()) return;
  gl::MatrixMode(GL_MODELVIEW);
  gl::LoadMatrixf(glm::value_ptr(modelView));
}

void maskBuffers(const Step& step, std::uint32_t outputs) { setColorMasks(step, outputs, GL_FALSE); }
void unmaskBuffers(const Step& step, std::uint32_t outputs) { setColorMasks(step, outputs, GL_TRUE); }

void unsetAlphaTest() {
  if (!gl::isCoreProfile()) gl::Disable(GL_ALPHA_TEST);
}

void setFog(const FrameState& state, int renderStage) {
  if (gl::isCoreProfile()) return;
  const FogRange range = fogRangeOf(state, renderStage);
  const float color[4] = {state.environment.fogColor.r, state.environment.fogColor.g,
                          state.environment.fogColor.b, 1};
  gl::Fogf(GL_FOG_START, range.start);
  gl::Fogf(GL_FOG_END, range.end);
  gl::Fogf(GL_FOG_DENSITY, fogDensityOf(state));
  gl::Fogfv(GL_FOG_COLOR, color);
}

}  // namespace orris
