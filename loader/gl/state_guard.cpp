#include <orris/gl/state_guard.h>

#include <algorithm>

#include <orris/gl/functions.h>

namespace orris::gl {
namespace {

struct Capability {
  unsigned name;
  bool byDefault;
};
constexpr Capability kCapabilities[] = {{GL_CULL_FACE, false},
                                        {GL_DEPTH_TEST, false},
                                        {GL_STENCIL_TEST, false},
                                        {GL_SCISSOR_TEST, false},
                                        {GL_POLYGON_OFFSET_FILL, false},
                                        {GL_SAMPLE_ALPHA_TO_COVERAGE, false},
                                        {GL_SAMPLE_COVERAGE, false},
                                        {GL_SAMPLE_MASK, false},
                                        {GL_DEPTH_CLAMP, false},
                                        {GL_FRAMEBUFFER_SRGB, false},
                                        {GL_PRIMITIVE_RESTART, false},
                                        {GL_PRIMITIVE_RESTART_FIXED_INDEX, false},
                                        {GL_RASTERIZER_DISCARD, false},
                                        {GL_COLOR_LOGIC_OP, false},
                                        {GL_LINE_SMOOTH, false},
                                        {GL_POLYGON_SMOOTH, false},
                                        {GL_CLIP_DISTANCE0, false},
                                        {GL_CLIP_DISTANCE1, false},
                                        {GL_CLIP_DISTANCE2, false},
                                        {GL_CLIP_DISTANCE3, false},
                                        {GL_CLIP_DISTANCE4, false},
                                        {GL_CLIP_DISTANCE5, false},
                                        {GL_DITHER, true}};

struct Parameter {
  unsigned name;
  int byDefault;
};
constexpr Parameter kPixelStore[] = {
    {GL_PACK_ALIGNMENT, 4},    {GL_PACK_ROW_LENGTH, 0},  {GL_PACK_SKIP_ROWS, 0},
    {GL_PACK_SKIP_PIXELS, 0},  {GL_PACK_SWAP_BYTES, 0},  {GL_PACK_LSB_FIRST, 0},
    {GL_PACK_IMAGE_HEIGHT, 0}, {GL_PACK_SKIP_IMAGES, 0}, {GL_UNPACK_ALIGNMENT, 4},
    {GL_UNPACK_ROW_LENGTH, 0}, {GL_UNPACK_SKIP_ROWS, 0}, {GL_UNPACK_SKIP_PIXELS, 0},
    {GL_UNPACK_SWAP_BYTES, 0}, {GL_UNPACK_LSB_FIRST, 0}, {GL_UNPACK_IMAGE_HEIGHT, 0},
    {GL_UNPACK_SKIP_IMAGES, 0}};

// What is bound: the name to ask for, and how to bind it. The vertex array comes before the array
// buffer, which it does not hold.
struct Binding {
  unsigned asked;
  void (*bind)(unsigned id);
};
template <unsigned Target>
void bindBuffer(unsigned id) {
  BindBuffer(Target, id);
}
constexpr Binding kBindings[] = {
    {GL_DRAW_FRAMEBUFFER_BINDING, [](unsigned id) { BindFramebuffer(GL_DRAW_FRAMEBUFFER, id); }},
    {GL_READ_FRAMEBUFFER_BINDING, [](unsigned id) { BindFramebuffer(GL_READ_FRAMEBUFFER, id); }},
    {GL_CURRENT_PROGRAM, [](unsigned id) { UseProgram(id); }},
    {GL_VERTEX_ARRAY_BINDING, [](unsigned id) { BindVertexArray(id); }},
    {GL_ARRAY_BUFFER_BINDING, bindBuffer<GL_ARRAY_BUFFER>},
    {GL_PIXEL_PACK_BUFFER_BINDING, bindBuffer<GL_PIXEL_PACK_BUFFER>},
    {GL_PIXEL_UNPACK_BUFFER_BINDING, bindBuffer<GL_PIXEL_UNPACK_BUFFER>},
    {GL_DISPATCH_INDIRECT_BUFFER_BINDING, bindBuffer<GL_DISPATCH_INDIRECT_BUFFER>},
    {GL_COPY_READ_BUFFER_BINDING, bindBuffer<GL_COPY_READ_BUFFER>},
    {GL_COPY_WRITE_BUFFER_BINDING, bindBuffer<GL_COPY_WRITE_BUFFER>}};

constexpr unsigned kKeptTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D};
constexpr unsigned kTargetBindings[] = {GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D,
                                        GL_TEXTURE_BINDING_3D};
constexpr unsigned kBlendBuffers = 8;
constexpr unsigned kStencilNames[2][7] = {
    {GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_FAIL,
     GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_WRITEMASK},
    {GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK, GL_STENCIL_BACK_FAIL,
     GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS, GL_STENCIL_BACK_WRITEMASK}};

int integerOf(unsigned name) {
  int value = 0;
  GetIntegerv(name, &value);
  return value;
}

int integerAt(unsigned name, unsigned index) {
  int value = 0;
  GetIntegeri_v(name, index, &value);
  return value;
}

void setCapability(unsigned name, bool on) { on ? Enable(name) : Disable(name); }

bool hasClipControl() {
  return ClipControl != nullptr &&
         integerOf(GL_MAJOR_VERSION) * 10 + integerOf(GL_MINOR_VERSION) >= 45;
}

}  // namespace

StateGuard::StateGuard() {
  for (const Capability& row : kCapabilities) {
    capabilities_.emplace_back(row.name, IsEnabled(row.name));
    setCapability(row.name, row.byDefault);
  }
  for (const Parameter& row : kPixelStore) {
    pixelStore_.emplace_back(row.name, integerOf(row.name));
    PixelStorei(row.name, row.byDefault);
  }
  for (const Binding& row : kBindings) bindings_.push_back(integerOf(row.asked));
  BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  GetIntegerv(GL_VIEWPORT, viewport_.data());
  GetIntegerv(GL_SCISSOR_BOX, scissor_.data());
  GetIntegerv(GL_POLYGON_MODE, polygonMode_.data());
  PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  GetFloatv(GL_POLYGON_OFFSET_FACTOR, &polygonOffset_[0]);
  GetFloatv(GL_POLYGON_OFFSET_UNITS, &polygonOffset_[1]);
  std::array<float, 2> range{};
  GetFloatv(GL_DEPTH_RANGE, range.data());
  depthRange_ = {double(range[0]), double(range[1])};
  DepthRange(0, 1);
  depthFunction_ = integerOf(GL_DEPTH_FUNC);
  GetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
  cullFace_ = integerOf(GL_CULL_FACE_MODE);
  frontFace_ = integerOf(GL_FRONT_FACE);
  patchVertices_ = integerOf(GL_PATCH_VERTICES);
  clearStencil_ = integerOf(GL_STENCIL_CLEAR_VALUE);
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t i = 0; i < 7; ++i)
      stencil_[side].values[i] = integerOf(kStencilNames[side][i]);
  StencilMask(~0u);
  if (hasClipControl()) {
    clip_ = {integerOf(GL_CLIP_ORIGIN), integerOf(GL_CLIP_DEPTH_MODE)};
    ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
  saveUnits();
  saveBlending();
  if (!isCoreProfile()) saveFixedFunctions();
  unsigned id = 0;
  CreateVertexArrays(1, &id);
  vertexArray_ = Handle<deleteVertexArray>(id);
  BindVertexArray(id);
}

void StateGuard::saveUnits() {
  activeTexture_ = integerOf(GL_ACTIVE_TEXTURE);
  units_.resize(static_cast<std::size_t>(integerOf(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS)));
  for (std::size_t i = 0; i < units_.size(); ++i) {
    ActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(i));
    for (std::size_t t = 0; t < 3; ++t) units_[i].textures[t] = integerOf(kTargetBindings[t]);
    units_[i].sampler = integerOf(GL_SAMPLER_BINDING);
    BindSampler(static_cast<unsigned>(i), 0);
  }
  images_.resize(static_cast<std::size_t>(integerOf(GL_MAX_IMAGE_UNITS)));
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const auto at = [i](unsigned name) { return integerAt(name, static_cast<unsigned>(i)); };
    images_[i] = {at(GL_IMAGE_BINDING_NAME),    at(GL_IMAGE_BINDING_LEVEL),
                  at(GL_IMAGE_BINDING_LAYERED), at(GL_IMAGE_BINDING_LAYER),
                  at(GL_IMAGE_BINDING_ACCESS),  at(GL_IMAGE_BINDING_FORMAT)};
  }
}

void StateGuard::restoreUnits() const {
  for (std::size_t i = 0; i < units_.size(); ++i) {
    ActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(i));
    for (std::size_t t = 0; t < 3; ++t)
      BindTexture(kKeptTargets[t], static_cast<unsigned>(units_[i].textures[t]));
    BindSampler(static_cast<unsigned>(i), static_cast<unsigned>(units_[i].sampler));
  }
  ActiveTexture(static_cast<unsigned>(activeTexture_));
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const Image& image = images_[i];
    BindImageTexture(static_cast<unsigned>(i), static_cast<unsigned>(image.name), image.level,
                     image.layered != 0 ? GL_TRUE : GL_FALSE, image.layer,
                     static_cast<unsigned>(image.access), static_cast<unsigned>(image.format));
  }
}

void StateGuard::saveBlending() {
  for (unsigned i = 0; i < kBlendBuffers; ++i) {
    Blend blend;
    blend.enabled = integerAt(GL_BLEND, i);
    blend.factors = {integerAt(GL_BLEND_SRC_RGB, i), integerAt(GL_BLEND_DST_RGB, i),
                     integerAt(GL_BLEND_SRC_ALPHA, i), integerAt(GL_BLEND_DST_ALPHA, i)};
    blend.equations = {integerAt(GL_BLEND_EQUATION_RGB, i), integerAt(GL_BLEND_EQUATION_ALPHA, i)};
    std::array<int, 4> mask{};
    GetIntegeri_v(GL_COLOR_WRITEMASK, i, mask.data());
    for (std::size_t c = 0; c < 4; ++c) blend.mask[c] = mask[c] != 0 ? 1 : 0;
    blend_.push_back(blend);
  }
  Disable(GL_BLEND);
  BlendEquation(GL_FUNC_ADD);
  ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void StateGuard::restoreBlending() const {
  for (unsigned i = 0; i < kBlendBuffers; ++i) {
    const Blend& blend = blend_[i];
    blend.enabled != 0 ? Enablei(GL_BLEND, i) : Disablei(GL_BLEND, i);
    const auto& f = blend.factors;
    BlendFuncSeparatei(i, static_cast<unsigned>(f[0]), static_cast<unsigned>(f[1]),
                       static_cast<unsigned>(f[2]), static_cast<unsigned>(f[3]));
    BlendEquationSeparatei(i, static_cast<unsigned>(blend.equations[0]),
                           static_cast<unsigned>(blend.equations[1]));
    ColorMaski(i, blend.mask[0], blend.mask[1], blend.mask[2], blend.mask[3]);
  }
}

void StateGuard::saveFixedFunctions() {
  matrixMode_ = integerOf(GL_MATRIX_MODE);
  clientTexture_ = integerOf(GL_CLIENT_ACTIVE_TEXTURE);
  alphaTest_ = IsEnabled(GL_ALPHA_TEST);
  Disable(GL_ALPHA_TEST);
  alphaFunction_ = integerOf(GL_ALPHA_TEST_FUNC);
  GetFloatv(GL_ALPHA_TEST_REF, &alphaReference_);
  matrices_.resize(5);
  GetFloatv(GL_MODELVIEW_MATRIX, matrices_[0].data());
  GetFloatv(GL_PROJECTION_MATRIX, matrices_[1].data());
  for (unsigned unit = 0; unit < 3; ++unit) {
    ActiveTexture(GL_TEXTURE0 + unit);
    GetFloatv(GL_TEXTURE_MATRIX, matrices_[2 + unit].data());
  }
}

void StateGuard::restoreFixedFunctions() const {
  for (unsigned unit = 0; unit < 3; ++unit) {
    ActiveTexture(GL_TEXTURE0 + unit);
    MatrixMode(GL_TEXTURE);
    LoadMatrixf(matrices_[2 + unit].data());
  }
  MatrixMode(GL_PROJECTION);
  LoadMatrixf(matrices_[1].data());
  MatrixMode(GL_MODELVIEW);
  LoadMatrixf(matrices_[0].data());
  MatrixMode(static_cast<unsigned>(matrixMode_));
  setCapability(GL_ALPHA_TEST, alphaTest_ != 0);
  AlphaFunc(static_cast<unsigned>(alphaFunction_), alphaReference_);
  ClientActiveTexture(static_cast<unsigned>(clientTexture_));
}

StateGuard::~StateGuard() {
  if (!isCoreProfile()) restoreFixedFunctions();
  restoreBlending();
  restoreUnits();
  if (hasClipControl())
    ClipControl(static_cast<unsigned>(clip_[0]), static_cast<unsigned>(clip_[1]));
  for (std::size_t side = 0; side < 2; ++side) {
    const unsigned face = side == 0 ? GL_FRONT : GL_BACK;
    const auto& v = stencil_[side].values;
    const auto at = [&v](std::size_t i) { return static_cast<unsigned>(v[i]); };
    StencilFuncSeparate(face, at(0), v[1], at(2));
    StencilOpSeparate(face, at(3), at(4), at(5));
    StencilMaskSeparate(face, at(6));
  }
  ClearStencil(clearStencil_);
  PatchParameteri(GL_PATCH_VERTICES, patchVertices_);
  FrontFace(static_cast<unsigned>(frontFace_));
  CullFace(static_cast<unsigned>(cullFace_));
  DepthMask(depthMask_);
  DepthFunc(static_cast<unsigned>(depthFunction_));
  DepthRange(depthRange_[0], depthRange_[1]);
  PolygonOffset(polygonOffset_[0], polygonOffset_[1]);
  PolygonMode(GL_FRONT_AND_BACK, static_cast<unsigned>(polygonMode_[0]));
  Scissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  for (std::size_t i = 0; i < bindings_.size(); ++i)
    kBindings[i].bind(static_cast<unsigned>(bindings_[i]));
  for (const auto& [name, value] : pixelStore_) PixelStorei(name, value);
  for (const auto& [name, on] : capabilities_) setCapability(name, on != 0);
}

}  // namespace orris::gl
