#include <orris/api/geometry.h>

#include <iterator>

#include <orris/api/call.h>
#include <orris/gl/functions.h>

namespace orris::api {
namespace {

constexpr Geometry kGeometries[] = {Geometry::Solid,
                                    Geometry::Cutout,
                                    Geometry::Translucent,
                                    Geometry::BlockEntity,
                                    Geometry::BlockText,
                                    Geometry::BeamCore,
                                    Geometry::BeamGlow,
                                    Geometry::Cracks,
                                    Geometry::Outline,
                                    Geometry::Leash,
                                    Geometry::Entities,
                                    Geometry::EntitiesTranslucent,
                                    Geometry::Eyes,
                                    Geometry::Glint,
                                    Geometry::Lightning,
                                    Geometry::Particles,
                                    Geometry::ParticlesTranslucent,
                                    Geometry::Hand,
                                    Geometry::HandTranslucent,
                                    Geometry::Rain,
                                    Geometry::Border,
                                    Geometry::PlayerBody};
static_assert(std::size(kGeometries) == ORRIS_KIND_COUNT);

std::size_t indexOf(Geometry geometry) { return static_cast<std::size_t>(geometry); }

/// What an engine's callback may have bound comes back when this dies.
class Bound {
 public:
  explicit Bound(unsigned program) : program_(program) {
    gl::GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
    gl::GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
  }
  ~Bound() {
    gl::UseProgram(program_);
    gl::BindVertexArray(static_cast<unsigned>(vertexArray_));
    gl::BindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(framebuffer_));
  }
  Bound(const Bound&) = delete;
  Bound& operator=(const Bound&) = delete;

 private:
  unsigned program_;
  int vertexArray_ = 0, framebuffer_ = 0;
};

/// A handle that lives as long as this.
class Enrolled {
 public:
  Enrolled(const void* handle, const char* kind) : handle_(handle) { enrol(handle, kind); }
  ~Enrolled() { strike(handle_); }
  Enrolled(const Enrolled&) = delete;
  Enrolled& operator=(const Enrolled&) = delete;

 private:
  const void* handle_;
};

}  // namespace

std::optional<Geometry> geometryOf(OrrisKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  if (index >= std::size(kGeometries)) return std::nullopt;
  return kGeometries[index];
}

OrrisKind kindOf(Geometry geometry) {
  for (std::size_t i = 0; i < std::size(kGeometries); ++i)
    if (kGeometries[i] == geometry) return static_cast<OrrisKind>(i);
  return ORRIS_KIND_COUNT;
}

GeometrySet geometrySetOf(std::uint32_t kinds) {
  GeometrySet set = 0;
  for (unsigned i = 0; i < 32; ++i) {
    if ((kinds >> i & 1u) == 0) continue;
    const auto geometry = geometryOf(static_cast<OrrisKind>(i));
    if (!geometry)
      fail(ORRIS_ERROR_ARGUMENT, "bit " + std::to_string(i) + " of the kinds is no OrrisKind");
    set |= bitOf(*geometry);
  }
  return set;
}

void SubmittedGeometry::add(Geometry geometry, const Submitted& submitted) {
  batches_[indexOf(geometry)].push_back(submitted);
  kinds_ |= bitOf(geometry);
}

void SubmittedGeometry::setCallback(GeometrySet kinds, OrrisDrawCallback callback, void* user) {
  callbackKinds_ = callback == nullptr ? 0 : kinds;
  callback_ = callback;
  user_ = user;
  kinds_ |= callbackKinds_;
}

void SubmittedGeometry::useUp() {
  for (std::vector<Submitted>& batches : batches_) batches.clear();
}

void beginDraw(EnginePass& pass, const Submitted& submitted) {
  const OrrisBatch& batch = submitted.batch;
  const OrrisTextures& names = batch.textures;
  const float* color = batch.entity_color;
  pass.begin(
      {batch.origin[0], batch.origin[1], batch.origin[2]},
      {names.albedo, names.normals, names.specular, submitted.textureSize},
      {batch.entity, batch.item, batch.block_entity, {color[0], color[1], color[2], color[3]}});
}

void SubmittedGeometry::draw(EnginePass& pass) {
  drawBatches(pass);
  if ((callbackKinds_ & bitOf(pass.geometry())) != 0) callBack(pass);
}

void SubmittedGeometry::drawBatches(EnginePass& pass) const {
  const std::uint32_t wanted = pass.isShadow() ? ORRIS_PASS_SHADOW : ORRIS_PASS_CAMERA;
  for (const Submitted& submitted : batches_[indexOf(pass.geometry())]) {
    const OrrisBatch& batch = submitted.batch;
    if ((batch.passes & wanted) == 0) continue;
    beginDraw(pass, submitted);
    gl::BindBuffer(GL_ARRAY_BUFFER, batch.vertex_buffer);
    pass.bindVertices({static_cast<int>(batch.stride), batch.offset});
    if (batch.primitive == ORRIS_QUADS)
      pass.drawQuads(batch.first, batch.count / 4);
    else
      pass.drawTriangles(batch.first, batch.count, batch.index_buffer,
                         batch.index_bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                         batch.index_offset);
  }
}

void SubmittedGeometry::callBack(EnginePass& pass) const {
  const Bound bound(pass.program());
  pass.begin(pass.camera(), {}, {});
  OrrisDraw draw{pass};
  const Enrolled enrolled(&draw, OrrisDraw::kKind);
  callback_(&draw, user_);
}

}  // namespace orris::api
