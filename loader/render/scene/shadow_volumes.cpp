#include <orris/render/scene/shadow_volumes.h>

#include <algorithm>
#include <set>

#include <orris/gl/functions.h>

namespace orris {
namespace {

/// Volumes this near to the eye's pyramid count as reaching it, blocks: far more than the rounding of
/// the rasteriser, and wrong in no other way than by a little work.
constexpr double kMargin = 1e-3;
/// No face has a corner farther than this from its middle, blocks.
constexpr double kFaceRadius = 1.01;
/// Volumes lie this much behind where they are, units of depth and parts of a pixel along their slope,
/// sides and caps alike: what touches a volume from outside is not in it, however the depths of faces
/// that meet in an edge are rounded. Caps of leaves even coincide with what is seen.
constexpr float kBehind = 4, kBehindSlope = 1.0f / 256;
/// Where the light lies in a plane of blocks, one volume may end in it and the next begin, with depths
/// that are rounded differently. The ends lie so many times as far behind: whatever lies there is in
/// both rather than in none.
constexpr float kEndsBehind = 2;

void bindVolumeVertices(const gl::Program& program) {
  if (!gl::isCoreProfile()) {
    gl::EnableClientState(GL_VERTEX_ARRAY);
    gl::VertexPointer(4, GL_FLOAT, 0, nullptr);
  }
  for (const gl::ActiveVariable& attribute : program.attributes) {
    const bool position = attribute.name == "vaPosition" || attribute.name == "iris_Position";
    if (!position || attribute.location < 0) continue;
    gl::EnableVertexAttribArray(attribute.location);
    gl::VertexAttribPointer(attribute.location, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  }
}

void unbindVolumeVertices(const gl::Program& program) {
  for (const gl::ActiveVariable& attribute : program.attributes)
    if (attribute.location >= 0) gl::DisableVertexAttribArray(attribute.location);
  if (!gl::isCoreProfile()) gl::DisableClientState(GL_VERTEX_ARRAY);
}

struct StencilRule {
  unsigned depthFunction, frontFail, frontPass, backFail, backPass;
};
// Wrapping: in any order of faces the count is exact modulo 256.
constexpr StencilRule kZPass{GL_LESS, GL_KEEP, GL_INCR_WRAP, GL_KEEP, GL_DECR_WRAP};
constexpr StencilRule kZFail{GL_LESS, GL_DECR_WRAP, GL_KEEP, GL_INCR_WRAP, GL_KEEP};
/// Along the whole of a ray a closed volume is left once more than entered when the eye is in it.
constexpr StencilRule kWholeRay{GL_ALWAYS, GL_KEEP, GL_DECR_WRAP, GL_KEEP, GL_INCR_WRAP};

void drawBehind(float times, std::uint32_t first, std::uint32_t end) {
  gl::PolygonOffset(times * kBehindSlope, times * kBehind);
  gl::DrawElements(GL_TRIANGLES, static_cast<int>(end - first), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

void setRule(const StencilRule& rule) {
  gl::DepthFunc(rule.depthFunction);
  gl::StencilOpSeparate(GL_FRONT, GL_KEEP, rule.frontFail, rule.frontPass);
  gl::StencilOpSeparate(GL_BACK, GL_KEEP, rule.backFail, rule.backPass);
}

}  // namespace

VolumeMethod volumeMethodOf(const std::string& word) {
  return word == "zpass"   ? VolumeMethod::ZPass
         : word == "zfail" ? VolumeMethod::ZFail
                           : VolumeMethod::Auto;
}

// The volume is convex: the face's plane, and one through each edge along the light. The pyramid is
// outside when it lies wholly behind one of them.
bool reachesEye(const CasterFace& face, const VolumeLight& light, const EyePyramid& eye) {
  const glm::dvec3 toLight(glm::vec3(light) - light.w * face.corners[0]);
  const auto outside = [&](const glm::dvec3& normal, const glm::dvec3& on) {
    const double length = glm::length(normal);
    if (length < 1e-9) return false;
    return std::all_of(eye.begin(), eye.end(), [&](const glm::dvec3& p) {
      return glm::dot(p - on, normal) > kMargin * length;
    });
  };
  const glm::dvec3 normal(face.normal);
  const double facing = glm::dot(normal, toLight) > 0 ? 1 : -1;
  if (outside(normal * facing, glm::dvec3(face.corners[0]))) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 a(face.corners[i]), b(face.corners[(i + 1) % 4]);
    const glm::dvec3 up = light.w == 0 ? toLight : glm::dvec3(light) - a;
    if (outside(glm::cross(b - a, up) * facing, a)) return false;
  }
  return true;
}

void ShadowVolumes::setCasters(CasterSet casters) {
  casters_ = std::move(casters);
  forget();
}

void ShadowVolumes::forget() {
  light_.reset();
  sides_.reset();
  closed_.reset();
  nearEye_.reset();
  makers_.clear();
  nearFaces_.clear();
}

ShadowVolumes::Drawn ShadowVolumes::upload(VolumeMesh mesh) {
  Drawn drawn;
  drawn.corners = std::move(mesh.vertices);
  drawn.vertices = gl::createUnfilledBuffer(drawn.corners.size() * sizeof(glm::vec4), "shadow volumes");
  drawn.indices = gl::createBuffer(mesh.indices.size() * sizeof(std::uint32_t), mesh.indices.data(),
                                   "shadow volume indices");
  drawn.indexCount = static_cast<std::uint32_t>(mesh.indices.size());
  drawn.alongCount = mesh.alongIndices;
  return drawn;
}

void ShadowVolumes::moveTo(const glm::ivec3& base, Drawn& drawn) const {
  if (drawn.base == base) return;
  drawn.base = base;
  const glm::vec4 by(glm::vec3(casters_.origin - base), 0);
  std::vector<glm::vec4> moved = drawn.corners;
  for (glm::vec4& corner : moved) corner += corner.w * by;  // directions stay
  gl::upload(drawn.vertices, 0, moved.size() * sizeof(glm::vec4), moved.data());
}

ShadowVolumes::Drawn& ShadowVolumes::silhouettes(const VolumeLight& light, bool closed) {
  std::optional<Drawn>& drawn = closed ? closed_ : sides_;
  if (!drawn) {
    drawn = upload(buildVolumes(casters_, light, {.closed = closed}));
    ++builds_;
  }
  return *drawn;
}

ShadowVolumes::Drawn& ShadowVolumes::nearEye(const VolumeLight& light, const EyePyramid& eye) {
  if (makers_.empty())
    for (const CasterFace& face : casters_.faces)
      if (makesVolume(face, light)) makers_.push_back(&face);
  std::vector<const CasterFace*> reaching;
  for (const CasterFace* face : makers_) {
    const glm::dvec3 middle = glm::dvec3(face->corners[0] + face->corners[2]) * 0.5;
    const glm::dvec3 toLight = glm::dvec3(light) - double(light.w) * eye[0];
    const glm::dvec3 off = glm::cross(middle - eye[0], glm::normalize(toLight));
    // Far from the line between eye and light; a lamp's volumes grow with the distance.
    const double reach = kFaceRadius + glm::distance(eye[0], eye[1]) + kMargin;
    if (glm::dot(off, off) > reach * reach) continue;
    if (reachesEye(*face, light, eye)) reaching.push_back(face);
  }
  facesAtEye_ = static_cast<int>(reaching.size());
  if (nearEye_ && reaching == nearFaces_) return *nearEye_;
  nearFaces_ = std::move(reaching);
  const std::set<const CasterFace*> chosen(nearFaces_.begin(), nearFaces_.end());
  nearEye_ = upload(buildVolumes(casters_, light, {.closed = true, .takes = [&](const auto& face) {
                                                     return chosen.contains(&face);
                                                   }}));
  return *nearEye_;
}

void ShadowVolumes::draw(const gl::Program& program, const VolumeLight& light,
                         const EyePyramid& worldEye, const glm::ivec3& base, VolumeMethod method) {
  if (light_ != light) {
    forget();
    light_ = light;
  }
  const auto drawPart = [&](Drawn& part, const StencilRule& rule) {
    if (part.indexCount == 0) return;
    moveTo(base, part);
    gl::BindBuffer(GL_ARRAY_BUFFER, part.vertices.id());
    gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.indices.id());
    bindVolumeVertices(program);
    setRule(rule);
    gl::Enable(GL_POLYGON_OFFSET_FILL);
    drawBehind(1, part.alongCount, part.indexCount);
    if (part.alongCount > 0) {
      gl::Enable(GL_CULL_FACE);
      gl::CullFace(GL_BACK);
      drawBehind(1, 0, part.alongCount);
      gl::CullFace(GL_FRONT);
      drawBehind(kEndsBehind, 0, part.alongCount);
      gl::CullFace(GL_BACK);
      gl::Disable(GL_CULL_FACE);
    }
    gl::Disable(GL_POLYGON_OFFSET_FILL);
    unbindVolumeVertices(program);
  };
  facesAtEye_ = 0;
  if (method == VolumeMethod::ZFail) return drawPart(silhouettes(light, true), kZFail);
  drawPart(silhouettes(light, false), kZPass);
  if (method != VolumeMethod::Auto) return;
  EyePyramid eye;
  std::transform(worldEye.begin(), worldEye.end(), eye.begin(),
                 [&](const glm::dvec3& p) { return p - glm::dvec3(casters_.origin); });
  drawPart(nearEye(light, eye), kWholeRay);
}

}  // namespace orris
