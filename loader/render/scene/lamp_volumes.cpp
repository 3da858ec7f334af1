#include <orris/render/scene/lamp_volumes.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <orris/gl/functions.h>

namespace orris {
namespace {

constexpr const char* kResolveVertex = R"(#version 330 core
void main() { gl_Position = vec4(gl_VertexID & 1, gl_VertexID >> 1, 0.0, 0.25) * 4.0 - vec4(1.0, 1.0, 0.0, 0.0); }
)";
constexpr const char* kResolveFragment = R"(#version 330 core
uniform uint lamp_bit;
layout(location = 0) out uint lamps;
void main() { lamps = lamp_bit; }
)";

gl::Program buildResolve() {
  return gl::buildProgram(
      {{GL_VERTEX_SHADER, kResolveVertex}, {GL_FRAGMENT_SHADER, kResolveFragment}}, {},
      "lamp volumes");
}

double strengthAt(const MeshLamp& lamp, const glm::dvec3& eye) {
  const glm::dvec3 toLamp = lamp.place() - eye;
  return double(lamp.level * lamp.level) / std::max(glm::dot(toLamp, toLamp), 1.0);
}

bool before(const glm::ivec3& a, const glm::ivec3& b) {
  return std::tie(a.y, a.z, a.x) < std::tie(b.y, b.z, b.x);
}

}  // namespace

PixelRect rectOfBall(const glm::mat4& clip, const glm::vec3& middle, float radius, int width,
                     int height) {
  glm::vec2 low(1), high(-1);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const glm::vec4 at = clip * glm::vec4(middle + side * radius, 1);
    // A box around the eye may be seen anywhere.
    if (at.w <= 1e-4f) return {0, 0, width, height};
    low = glm::min(low, glm::vec2(at) / at.w);
    high = glm::max(high, glm::vec2(at) / at.w);
  }
  const glm::vec2 size(width, height);
  const glm::ivec2 first(glm::floor((glm::clamp(low, -1.0f, 1.0f) * 0.5f + 0.5f) * size));
  const glm::ivec2 end(glm::ceil((glm::clamp(high, -1.0f, 1.0f) * 0.5f + 0.5f) * size));
  if (end.x <= first.x || end.y <= first.y) return {};
  return {first.x, first.y, end.x - first.x, end.y - first.y};
}

LampVolumes::LampVolumes(const SceneData& scene, const VolumeLightSettings& settings)
    : settings_(settings), resolve_(buildResolve()) {
  setScene(scene);
}

void LampVolumes::setScene(const SceneData& scene) {
  casters_ = castersOf(scene.mesh, scene.atlas);
  lamps_ = lampsOf(scene.mesh);
  chosen_.clear();
  volumes_.clear();
}

VolumeLights LampVolumes::choose(const glm::dvec3& eye) {
  std::vector<MeshLamp> chosen(std::min(lamps_.size(), std::size_t(settings_.count)));
  std::partial_sort_copy(lamps_.begin(), lamps_.end(), chosen.begin(), chosen.end(),
                         [&](const MeshLamp& a, const MeshLamp& b) {
                           const double first = strengthAt(a, eye), second = strengthAt(b, eye);
                           return first != second ? first > second : before(a.cell, b.cell);
                         });
  keepOnly(chosen);
  VolumeLights lights{};
  for (std::size_t i = 0; i < chosen_.size(); ++i)
    lights[i] = glm::vec4(glm::vec3(chosen_[i].place() - eye), rangeOf(chosen_[i]));
  return lights;
}

void LampVolumes::keepOnly(const std::vector<MeshLamp>& chosen) {
  if (chosen == chosen_) return;
  std::vector<std::unique_ptr<ShadowVolumes>> volumes(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto old = std::find(chosen_.begin(), chosen_.end(), chosen[i]);
    if (old != chosen_.end()) volumes[i] = std::move(volumes_[std::size_t(old - chosen_.begin())]);
  }
  chosen_ = chosen;
  volumes_ = std::move(volumes);
}

void LampVolumes::resolve(int bit) {
  gl::UseProgram(resolve_.id());
  gl::Uniform1ui(gl::GetUniformLocation(resolve_.id(), "lamp_bit"), 1u << bit);
  gl::ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl::Disable(GL_DEPTH_TEST);
  gl::StencilFunc(GL_NOTEQUAL, 0, 0xff);
  gl::StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  gl::Enable(GL_COLOR_LOGIC_OP);
  gl::LogicOp(GL_OR);
  gl::DrawArrays(GL_TRIANGLES, 0, 3);
  gl::Disable(GL_COLOR_LOGIC_OP);
  gl::StencilFunc(GL_ALWAYS, 0, 0xff);
  gl::Enable(GL_DEPTH_TEST);
  gl::ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
}

void LampVolumes::draw(const gl::Program& program, const View& view) {
  gl::Enable(GL_SCISSOR_TEST);
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    const MeshLamp& lamp = chosen_[i];
    const PixelRect rect = rectOfBall(view.clip, lamp.place() - glm::dvec3(view.base), rangeOf(lamp),
                                      view.width, view.height);
    if (rect == PixelRect()) continue;
    if (volumes_[i] == nullptr) {
      volumes_[i] =
          std::make_unique<ShadowVolumes>(castersOfLamp(casters_, lamp.cell, rangeOf(lamp)));
      ++builds_;
    }
    gl::Scissor(rect.x, rect.y, rect.width, rect.height);
    gl::ClearStencil(0);
    gl::Clear(GL_STENCIL_BUFFER_BIT);
    gl::UseProgram(program.id());
    const glm::vec3 place(lamp.place() - glm::dvec3(casters_.origin));
    volumes_[i]->draw(program, glm::vec4(place, 1), view.eye, view.base, view.method);
    resolve(int(i));
  }
  gl::UseProgram(program.id());
  gl::Scissor(0, 0, view.width, view.height);
  gl::Clear(GL_STENCIL_BUFFER_BIT);
  gl::Disable(GL_SCISSOR_TEST);
}

}  // namespace orris
