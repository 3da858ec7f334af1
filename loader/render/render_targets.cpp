#include <orris/render/render_targets.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include <orris/core/add_diagnostic.h>
#include <orris/gl/functions.h>

namespace orris {
namespace {

int levelsFor(int width, int height) {
  int levels = 1;
  while (std::max(width, height) >> levels != 0) ++levels;
  return levels;
}

RenderTarget makeTarget(const TargetPlan& plan, const char* kind, Diagnostics& diagnostics) {
  RenderTarget target;
  target.plan = plan;
  target.format = findFormat(plan.format);
  if (target.format == nullptr || !target.format->renderable) {
    addError(diagnostics, "target-format", {},
             fmt::format("{}{} cannot be drawn to with format {}", kind, plan.index, plan.format),
             "use a renderable format such as RGBA16F");
    target.format = findFormat("RGBA8");
  }
  const int levels = plan.mipmaps ? levelsFor(plan.width, plan.height) : 1;
  for (int side = 0; side < (plan.needsAlt ? 2 : 1); ++side)
    target.sides[side] =
        gl::createTexture(2, *target.format, plan.width, plan.height, 1, levels,
                          fmt::format("{}{} {}", kind, plan.index, side == 0 ? "main" : "alt"));
  return target;
}

void clearDepth(const gl::Texture& texture) {
  const float one = 1;
  if (texture.id() == 0) return;
  if (texture.internalFormat == GL_DEPTH24_STENCIL8) {
    const std::uint32_t farUnshadowed = 0xffffff00;
    gl::ClearTexImage(texture.id(), 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &farUnshadowed);
  } else {
    gl::ClearTexImage(texture.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, &one);
  }
}

void copyWhole(const gl::Texture& from, const gl::Texture& to) {
  gl::CopyImageSubData(from.id(), from.target, 0, 0, 0, 0, to.id(), to.target, 0, 0, 0, 0,
                       from.width, from.height, 1);
}

}  // namespace

RenderTargets::Targets RenderTargets::makeTargets(const std::vector<TargetPlan>& plans,
                                                  const char* kind, const Targets* previous,
                                                  Diagnostics& diagnostics) {
  Targets targets;
  for (const TargetPlan& plan : plans) {
    const auto kept = previous != nullptr ? previous->find(plan.index) : Targets::const_iterator();
    const bool same = previous != nullptr && kept != previous->end() && kept->second->plan == plan;
    targets[plan.index] =
        same ? kept->second : std::make_shared<RenderTarget>(makeTarget(plan, kind, diagnostics));
  }
  return targets;
}

RenderTargets::RenderTargets(const Schedule& schedule, bool floatScreen,
                             const RenderTargets* previous, Diagnostics& diagnostics) {
  color_ = makeTargets(schedule.colortex, "colortex",
                       previous != nullptr ? &previous->color_ : nullptr, diagnostics);
  shadowColor_ = makeTargets(schedule.shadowcolor, "shadowcolor",
                             previous != nullptr ? &previous->shadowColor_ : nullptr, diagnostics);
  // Copies need one format.
  const auto makeDepth = [&](const char* name) {
    return schedule.stencil ? gl::createDepthStencilTexture(schedule.width, schedule.height, name)
                            : gl::createDepthTexture(schedule.width, schedule.height, 1, name);
  };
  depth_[0] = makeDepth("depthtex0");
  if (schedule.depthtex1) depth_[1] = makeDepth("depthtex1");
  if (schedule.depthtex2) depth_[2] = makeDepth("depthtex2");
  if (schedule.stencil) stencil_ = gl::createStencilView(depth_[0], "stenciltex0");
  if (schedule.lampShadows)
    lampShadows_ = gl::createTexture(2, *findFormat("R8UI"), schedule.width, schedule.height, 1, 1,
                                     "stenciltex1");
  if (const int size = schedule.shadowResolution; size > 0) {
    shadowDepth_[0] = gl::createDepthTexture(size, size, levelsFor(size, size), "shadowtex0");
    if (schedule.shadowtex1)
      shadowDepth_[1] = gl::createDepthTexture(size, size, levelsFor(size, size), "shadowtex1");
  }
  screen_ = gl::createTexture(2, *findFormat(floatScreen ? "RGBA32F" : "RGBA8"), schedule.width,
                              schedule.height, 1, 1, "screen");
}

RenderTarget* RenderTargets::find(bool shadow, int index) {
  auto& map = shadow ? shadowColor_ : color_;
  const auto it = map.find(index);
  return it == map.end() ? nullptr : it->second.get();
}

const gl::Framebuffer& RenderTargets::framebuffer(const Step& step, std::string& error) {
  const bool shadow = step.group == ProgramGroup::Shadow || step.group == ProgramGroup::ShadowComp;
  const bool geometry = step.kind == Step::Kind::Draw || step.kind == Step::Kind::DrawShadow ||
                        step.kind == Step::Kind::ShadowVolumes;
  std::string key = fmt::format("{}{}", shadow ? "s" : "c", geometry ? "d" : "");
  std::vector<const gl::Texture*> colors;
  for (int buffer : step.writes) {
    RenderTarget* target = find(shadow, buffer);
    if (target == nullptr) continue;
    const bool alt = step.writesAlt(buffer);
    key += fmt::format(",{}{}", buffer, alt ? "a" : "");
    colors.push_back(&target->side(alt));
  }
  if (const auto it = framebuffers_.find(key); it != framebuffers_.end()) return it->second;
  const gl::Texture* depth = !geometry ? nullptr : shadow ? &shadowDepth_[0] : &depth_[0];
  return framebuffers_.emplace(key, gl::createFramebuffer(colors, depth, step.name, error))
      .first->second;
}

const gl::Framebuffer& RenderTargets::screenFramebuffer() {
  const auto it = framebuffers_.find("screen");
  if (it != framebuffers_.end()) return it->second;
  std::string error;
  return framebuffers_
      .emplace("screen", gl::createFramebuffer({&screen_}, nullptr, "screen", error))
      .first->second;
}

const gl::Framebuffer& RenderTargets::lampFramebuffer() {
  const auto it = framebuffers_.find("lamps");
  if (it != framebuffers_.end()) return it->second;
  std::string error;
  return framebuffers_
      .emplace("lamps", gl::createFramebuffer({&lampShadows_}, &depth_[0], "lamp shadows", error))
      .first->second;
}

void RenderTargets::clearTarget(RenderTarget& target, const float fogColor[3]) {
  std::array<float, 4> color = target.plan.clearColor;
  if (target.plan.clearToFog) color = {fogColor[0], fogColor[1], fogColor[2], 1};
  const bool integer = target.format->isInteger();
  // Contract constants.csv: the bits of the float are the integer clear value.
  std::uint32_t bits[4];
  std::memcpy(bits, color.data(), sizeof bits);
  for (const gl::Texture& side : target.sides) {
    if (side.id() == 0) continue;
    if (integer)
      gl::ClearTexImage(side.id(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, bits);
    else
      gl::ClearTexImage(side.id(), 0, GL_RGBA, GL_FLOAT, color.data());
  }
}

void RenderTargets::clearFresh(const float fogColor[3]) {
  for (Targets* targets : {&color_, &shadowColor_})
    for (auto& [index, target] : *targets)
      if (std::exchange(target->isFresh, false)) clearTarget(*target, fogColor);
  for (const gl::Texture& texture : depth_) clearDepth(texture);
  for (const gl::Texture& texture : shadowDepth_) clearDepth(texture);
}

void RenderTargets::clearColor(const float fogColor[3]) {
  for (auto& [index, target] : color_)
    if (target->plan.clear) clearTarget(*target, fogColor);
  clearDepth(depth_[0]);
}

void RenderTargets::clearShadow() {
  static constexpr float kUnused[3] = {0, 0, 0};
  for (auto& [index, target] : shadowColor_)
    if (target->plan.clear) clearTarget(*target, kUnused);
  clearDepth(shadowDepth_[0]);
}

void RenderTargets::keepHistory() {
  for (auto* map : {&color_, &shadowColor_})
    for (auto& [index, target] : *map)
      if (target->plan.history && target->plan.needsAlt)
        copyWhole(target->sides[1], target->sides[0]);
}

void RenderTargets::forgetMipmaps() {
  for (auto* map : {&color_, &shadowColor_})
    for (auto& [index, target] : *map) target->mipmapped[0] = target->mipmapped[1] = false;
}

}  // namespace orris
