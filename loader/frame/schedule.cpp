#include "frame/schedule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "frame/program_uses.h"

namespace orris {
namespace {

using Kind = Step::Kind;

struct GeometryPass {
  std::string_view program;
  Geometry geometry;
  bool SceneContents::*needed;
};
constexpr GeometryPass kSky[] = {{"gbuffers_skybasic", Geometry::Sky, &SceneContents::sky},
                                 {"gbuffers_skybasic", Geometry::Stars, &SceneContents::sky},
                                 {"gbuffers_skytextured", Geometry::SunMoon, &SceneContents::sky}};
constexpr GeometryPass kOpaque[] = {
    {"gbuffers_terrain_solid", Geometry::Solid, &SceneContents::solid},
    {"gbuffers_terrain_cutout", Geometry::Cutout, &SceneContents::cutout}};
constexpr GeometryPass kTranslucent[] = {
    {"gbuffers_water", Geometry::Translucent, &SceneContents::translucent}};
constexpr GeometryPass kShadowOpaque[] = {
    {"shadow_solid", Geometry::Solid, &SceneContents::solid},
    {"shadow_cutout", Geometry::Cutout, &SceneContents::cutout}};
constexpr GeometryPass kShadowTranslucent[] = {
    {"shadow_water", Geometry::Translucent, &SceneContents::translucent}};

bool isShadowGroup(ProgramGroup group) {
  return group == ProgramGroup::Shadow || group == ProgramGroup::ShadowComp;
}

/// Builds the steps in frame order while keeping the flip bits; then finds what they touch.
class Builder {
 public:
  Builder(const ShaderPack& pack, int width, int height, const SceneContents& scene,
          Diagnostics& diagnostics)
      : pack_(pack), scene_(scene), diagnostics_(diagnostics) {
    schedule_.width = width;
    schedule_.height = height;
    for (const ProgramSource& program : pack.programs) uses_.push_back(usesOf(program));
  }

  Schedule build() {
    const bool shadow = shadowWanted();
    addGroup(ProgramGroup::Setup, schedule_.setup);
    add(Kind::ClearImages, "clear_images");
    if (shadow) addComputes("shadow", ProgramGroup::Shadow);
    add(Kind::ClearColor, "clear_color");
    addGroup(ProgramGroup::Begin, schedule_.frame);
    if (shadow) addShadow();
    addGroup(ProgramGroup::Prepare, schedule_.frame);
    addGeometry(kSky, Kind::Draw);
    addGeometry(kOpaque, Kind::Draw);
    const size_t afterOpaque = schedule_.frame.size();
    addGroup(ProgramGroup::Deferred, schedule_.frame);
    addGeometry(kTranslucent, Kind::Draw);
    addGroup(ProgramGroup::Composite, schedule_.frame);
    addFinal();
    schedule_.finalFlipped = flipped_;
    schedule_.finalShadowFlipped = shadowFlipped_;
    collectTargets(shadow);
    addDepthCopies(afterOpaque);
    checkSizes();
    return std::move(schedule_);
  }

 private:
  Step& add(Kind kind, std::string name) { return addTo(schedule_.frame, kind, std::move(name)); }

  Step& addTo(std::vector<Step>& steps, Kind kind, std::string name) {
    Step step;
    step.kind = kind;
    step.name = std::move(name);
    step.flipped = flipped_;
    step.shadowFlipped = shadowFlipped_;
    step.flippedInGroup = groupFlips_;
    steps.push_back(std::move(step));
    return steps.back();
  }

  int indexOf(const ProgramSource* program) const {
    return program == nullptr ? -1 : static_cast<int>(program - pack_.programs.data());
  }

  // Contract properties.csv "shadow.enabled": the pass exists when something outside it looks at
  // shadow buffers, or the pack forces it.
  bool shadowWanted() const {
    const auto& settings = pack_.properties.settings;
    if (const auto it = settings.find("shadow.enabled"); it != settings.end())
      return pack_.properties.flag("shadow.enabled", true);
    for (size_t i = 0; i < pack_.programs.size(); ++i) {
      const ProgramGroup group = pack_.programs[i].group;
      if (isShadowGroup(group) || group == ProgramGroup::DistantHorizons) continue;
      if (group == ProgramGroup::Gbuffers && !gbuffersDrawn(pack_.programs[i])) continue;
      if (usesShadow(uses_[i])) return true;
    }
    return false;
  }

  bool gbuffersDrawn(const ProgramSource& program) const {
    for (const auto* passes :
         {&kSky[0], &kSky[1], &kSky[2], &kOpaque[0], &kOpaque[1], &kTranslucent[0]})
      if (scene_.*passes->needed && pack_.resolve(passes->program) == &program) return true;
    return false;
  }

  static bool usesShadow(const ProgramUses& uses) {
    for (const std::string& name : uses)
      if (const auto buffer = parseBufferName(name, false);
          buffer && (buffer->kind == BufferName::Kind::ShadowDepth ||
                     buffer->kind == BufferName::Kind::ShadowColor))
        return true;
    return false;
  }

  void preFlip(const std::string& group) {
    const auto it = pack_.properties.flip.find(group + "_pre");
    if (it == pack_.properties.flip.end()) return;
    for (const auto& [buffer, flip] : it->second)
      if (const auto name = parseBufferName(buffer, false); flip && name)
        (name->kind == BufferName::Kind::ShadowColor ? shadowFlipped_ : flipped_) ^= 1u
                                                                                     << name->index;
  }

  void addGroup(ProgramGroup group, std::vector<Step>& steps) {
    static const std::map<ProgramGroup, std::string> kPrefix = {
        {ProgramGroup::Begin, "begin"},
        {ProgramGroup::ShadowComp, "shadowcomp"},
        {ProgramGroup::Prepare, "prepare"},
        {ProgramGroup::Deferred, "deferred"},
        {ProgramGroup::Composite, "composite"}};
    if (const auto it = kPrefix.find(group); it != kPrefix.end()) preFlip(it->second);
    groupFlips_ = 0;
    std::vector<const ProgramSource*> programs;
    for (const ProgramSource& program : pack_.programs)
      if (program.group == group) programs.push_back(&program);
    std::sort(programs.begin(), programs.end(),
              [](const auto* a, const auto* b) { return a->index < b->index; });
    for (const ProgramSource* program : programs) addFullscreen(*program, steps);
  }

  void addFullscreen(const ProgramSource& program, std::vector<Step>& steps) {
    if (!program.computes.empty()) addCompute(program, steps);
    if (program.stages.empty()) return;
    const bool shadow = program.group == ProgramGroup::ShadowComp;
    Step& step = addTo(steps, Kind::Fullscreen, program.name);
    step.program = indexOf(&program);
    step.group = program.group;
    step.writes = program.drawBuffers;
    step.mipmaps.assign(program.directives.mipmaps.begin(), program.directives.mipmaps.end());
    std::uint32_t flips = 0;
    for (int buffer : program.drawBuffers) flips |= 1u << buffer;
    for (const auto& [name, flip] : program.flips) {
      const auto buffer = parseBufferName(name, false);
      if (!buffer) continue;
      flips = flip ? flips | 1u << buffer->index : flips & ~(1u << buffer->index);
    }
    (shadow ? shadowFlipped_ : flipped_) ^= flips;
    (shadow ? everShadowFlipped_ : everFlipped_) |= flips;
    if (!shadow) groupFlips_ |= flips;
  }

  void addCompute(const ProgramSource& program, std::vector<Step>& steps) {
    Step& step = addTo(steps, Kind::Compute, program.name);
    step.program = indexOf(&program);
    step.group = program.group;
  }

  void addComputes(std::string_view name, ProgramGroup group) {
    const ProgramSource* program = pack_.find(name);
    if (program == nullptr || program->group != group || program->computes.empty()) return;
    addCompute(*program, schedule_.frame);
  }

  template <size_t N>
  void addGeometry(const GeometryPass (&passes)[N], Kind kind) {
    if (kind == Kind::Draw && pack_.properties.flag("skipAllRendering", false)) return;
    for (const GeometryPass& pass : passes) {
      if (!(scene_.*pass.needed) || !wanted(pass)) continue;
      const ProgramSource* program = pack_.resolve(pass.program);
      if (program != nullptr && program->stages.empty()) program = nullptr;
      Step& step = add(kind, std::string(pass.program));
      step.program = indexOf(program);
      step.group = kind == Kind::DrawShadow ? ProgramGroup::Shadow : ProgramGroup::Gbuffers;
      step.geometry = pass.geometry;
      step.writes = program != nullptr ? program->drawBuffers : std::vector<int>{0};
    }
  }

  bool wanted(const GeometryPass& pass) const {
    const auto& p = pack_.properties;
    switch (pass.geometry) {
      case Geometry::Sky:
        return p.flag("sky", true);
      case Geometry::Stars:
        return p.flag("stars", true);
      case Geometry::SunMoon:
        return p.flag("sun", true) || p.flag("moon", true);
      case Geometry::Solid:
      case Geometry::Cutout:
        return !pass.program.starts_with("shadow") || p.flag("shadowTerrain", true);
      case Geometry::Translucent:
        return !pass.program.starts_with("shadow") || p.flag("shadowTranslucent", true);
    }
    return true;
  }

  void addShadow() {
    add(Kind::ClearShadow, "clear_shadow");
    if (pack_.properties.flag("shadow.enabled", true)) {
      addGeometry(kShadowOpaque, Kind::DrawShadow);
      add(Kind::CopyShadowDepth, "copy_shadowtex1");
      addGeometry(kShadowTranslucent, Kind::DrawShadow);
      add(Kind::ShadowMipmaps, "shadow_mipmaps");
    }
    addGroup(ProgramGroup::ShadowComp, schedule_.frame);
  }

  void addFinal() {
    const ProgramSource* program = pack_.find("final");
    if (program != nullptr && !program->computes.empty()) addCompute(*program, schedule_.frame);
    Step& step = add(Kind::Present, "final");
    step.group = ProgramGroup::Final;
    if (program == nullptr || program->stages.empty()) return;
    step.program = indexOf(program);
    step.mipmaps.assign(program->directives.mipmaps.begin(), program->directives.mipmaps.end());
  }

  struct Touched {
    std::set<int> color, shadowColor;
    bool shadowDepth[2] = {false, false};
    bool depth[3] = {false, false, false};
  };

  void touchUses(const Step& step, Touched& touched) {
    const ProgramUses& uses = uses_[step.program];
    schedule_.programs.insert(step.program);
    schedule_.noisetex |= uses.contains("noisetex");
    schedule_.centerDepth |= uses.contains("centerDepthSmooth");
    const bool geometry = step.kind == Kind::Draw || step.kind == Kind::DrawShadow;
    for (const std::string& name : uses) {
      const auto buffer = parseBufferName(name, uses.contains("watershadow"));
      if (!buffer) continue;
      switch (buffer->kind) {
        case BufferName::Kind::Color:
          // colortex0..3 in geometry programs are the atlas (contract: "Samplers nobody binds").
          if (!geometry || buffer->image || buffer->index >= 4) touched.color.insert(buffer->index);
          break;
        case BufferName::Kind::ShadowColor:
          touched.shadowColor.insert(buffer->index);
          break;
        case BufferName::Kind::Depth:
          touched.depth[buffer->index] = true;
          break;
        case BufferName::Kind::ShadowDepth:
          touched.shadowDepth[buffer->index] = true;
          break;
      }
    }
  }

  void touchStep(const Step& step, Touched& touched, std::map<int, bool>& explicitShadow) {
    if (step.program >= 0) touchUses(step, touched);
    const bool explicitWrites =
        step.program >= 0 && pack_.programs[step.program].directives.drawBuffers.has_value();
    for (int buffer : step.writes) {
      if (!isShadowGroup(step.group))
        touched.color.insert(buffer);
      else if (explicitWrites)
        explicitShadow[buffer] = true;
    }
    if (step.kind == Kind::Present && step.program < 0) touched.color.insert(0);
  }

  void collectTargets(bool shadow) {
    Touched touched;
    std::map<int, bool> explicitShadow;
    for (const auto* steps : {&schedule_.setup, &schedule_.frame})
      for (const Step& step : *steps) touchStep(step, touched, explicitShadow);
    for (const auto& [buffer, wantedThere] : explicitShadow)
      if (wantedThere) touched.shadowColor.insert(buffer);
    schedule_.depthtex1 = touched.depth[1];
    schedule_.depthtex2 = touched.depth[2];
    for (int index : touched.color) schedule_.colortex.push_back(planColor(index));
    if (!shadow) return;
    schedule_.shadowResolution = pack_.directives.shadowMapResolution;
    schedule_.shadowtex1 = touched.shadowDepth[1];
    // Slots are positions in a list, so a used higher buffer keeps the lower ones it comes after.
    trimShadowWrites(touched.shadowColor);
    for (int index : touched.shadowColor) schedule_.shadowcolor.push_back(planShadow(index));
  }

  // A shadow program without a directive writes 0 and 1; what nobody reads is not allocated.
  void trimShadowWrites(std::set<int>& used) {
    for (Step& step : schedule_.frame) {
      if (!isShadowGroup(step.group)) continue;
      while (!step.writes.empty() && !used.contains(step.writes.back())) step.writes.pop_back();
    }
    for (const Step& step : schedule_.frame)
      if (isShadowGroup(step.group)) used.insert(step.writes.begin(), step.writes.end());
  }

  TargetPlan planColor(int index) {
    TargetPlan plan;
    plan.index = index;
    plan.width = schedule_.width;
    plan.height = schedule_.height;
    if (index == 1) plan.clearColor = {1, 1, 1, 1};
    plan.clearToFog = index == 0;
    if (const auto it = pack_.directives.colortex.find(index);
        it != pack_.directives.colortex.end())
      applySettings(it->second, plan);
    else
      plan.format = TargetSettings().format;
    const std::string name = fmt::format("colortex{}", index);
    if (const auto it = pack_.properties.bufferSize.find(name);
        it != pack_.properties.bufferSize.end()) {
      plan.width = axis(it->second, 0, schedule_.width);
      plan.height = axis(it->second, 1, schedule_.height);
    }
    plan.needsAlt = (everFlipped_ >> index & 1u) != 0 || writtenFullscreen(index, false);
    plan.mipmaps = readWithMipmaps(index, false);
    plan.history = !plan.clear && (schedule_.finalFlipped >> index & 1u) != 0;
    return plan;
  }

  TargetPlan planShadow(int index) {
    TargetPlan plan;
    plan.index = index;
    plan.width = plan.height = pack_.directives.shadowMapResolution;
    plan.clearColor = {1, 1, 1, 1};
    if (const auto it = pack_.directives.shadowcolor.find(index);
        it != pack_.directives.shadowcolor.end())
      applySettings(it->second, plan);
    else
      plan.format = TargetSettings().format;
    plan.needsAlt = (everShadowFlipped_ >> index & 1u) != 0 || writtenFullscreen(index, true);
    plan.mipmaps = readWithMipmaps(index, true);
    plan.history = !plan.clear && (schedule_.finalShadowFlipped >> index & 1u) != 0;
    return plan;
  }

  static void applySettings(const TargetSettings& settings, TargetPlan& plan) {
    plan.format = settings.format;
    plan.clear = settings.clear;
    if (!settings.clearColor) return;
    plan.clearColor = *settings.clearColor;
    plan.clearToFog = false;
  }

  static int axis(const BufferSize& size, int i, int window) {
    const float value = size.relative[i] ? size.size[i] * static_cast<float>(window) : size.size[i];
    return std::clamp(static_cast<int>(value), 1, 16384);
  }

  bool writtenFullscreen(int index, bool shadow) const {
    return std::any_of(schedule_.frame.begin(), schedule_.frame.end(), [&](const Step& step) {
      return step.kind == Kind::Fullscreen && isShadowGroup(step.group) == shadow &&
             std::count(step.writes.begin(), step.writes.end(), index) != 0;
    });
  }

  bool readWithMipmaps(int index, bool shadow) const {
    return std::any_of(schedule_.frame.begin(), schedule_.frame.end(), [&](const Step& step) {
      return (step.group == ProgramGroup::ShadowComp) == shadow &&
             std::count(step.mipmaps.begin(), step.mipmaps.end(), index) != 0;
    });
  }

  // Copies only what some program reads; depthtex2 lies before the hand, depthtex1 after it.
  void addDepthCopies(size_t afterOpaque) {
    std::vector<Step> copies;
    const std::uint32_t bits =
        afterOpaque < schedule_.frame.size() ? schedule_.frame[afterOpaque].flipped : flipped_;
    const auto push = [&](Kind kind, std::string name, int index) {
      Step step;
      step.kind = kind;
      step.name = std::move(name);
      step.index = index;
      step.flipped = bits;
      copies.push_back(step);
    };
    if (schedule_.centerDepth) push(Kind::SampleCenterDepth, "sample_center_depth", 0);
    if (schedule_.depthtex2) push(Kind::CopyDepth, "copy_depthtex2", 2);
    if (schedule_.depthtex1) push(Kind::CopyDepth, "copy_depthtex1", 1);
    schedule_.frame.insert(schedule_.frame.begin() + static_cast<std::ptrdiff_t>(afterOpaque),
                           copies.begin(), copies.end());
    std::erase_if(schedule_.frame, [&](const Step& step) {
      return step.kind == Kind::CopyShadowDepth && !schedule_.shadowtex1;
    });
  }

  void checkSizes() {
    for (const Step& step : schedule_.frame) {
      if (step.program < 0 || isShadowGroup(step.group) || step.writes.size() < 1) continue;
      const TargetPlan* first = schedule_.target(false, step.writes[0]);
      for (int buffer : step.writes) {
        const TargetPlan* plan = schedule_.target(false, buffer);
        const bool window = plan->width == schedule_.width && plan->height == schedule_.height;
        if (step.kind == Kind::Draw && !window)
          report(step, *plan, "a gbuffers program needs window-sized buffers");
        else if (plan->width != first->width || plan->height != first->height)
          report(step, *plan,
                 fmt::format("colortex{} of the same program is {}x{}", first->index, first->width,
                             first->height));
      }
    }
  }

  void report(const Step& step, const TargetPlan& plan, const std::string& why) {
    Diagnostic d;
    d.id = "target-size-mismatch";
    d.at = pack_.programs[step.program].directives.drawBuffersAt;
    if (d.at.file.empty()) d.at.file = pack_.programs[step.program].name;
    d.message = fmt::format("{} draws to colortex{} of {}x{}, but {}", step.name, plan.index,
                            plan.width, plan.height, why);
    d.hint = "give all draw buffers of one program the same size.buffer, or drop it";
    d.sourceLine = pack_.sourceLine(d.at.file, d.at.line);
    diagnostics_.push_back(std::move(d));
  }

  const ShaderPack& pack_;
  const SceneContents& scene_;
  Diagnostics& diagnostics_;
  std::vector<ProgramUses> uses_;
  Schedule schedule_;
  std::uint32_t flipped_ = 0, shadowFlipped_ = 0, everFlipped_ = 0, everShadowFlipped_ = 0;
  std::uint32_t groupFlips_ = 0;
};

}  // namespace

bool Step::writesAlt(int buffer) const {
  const bool shadow = group == ProgramGroup::ShadowComp || group == ProgramGroup::Shadow;
  const bool bit = ((shadow ? shadowFlipped : flipped) >> buffer & 1u) != 0;
  // Fullscreen programs write the side they do not read; geometry writes the side it reads, and the
  // shadow pass always main.
  if (kind == Kind::Fullscreen) return !bit;
  return kind == Kind::DrawShadow ? false : bit;
}

const TargetPlan* Schedule::target(bool shadow, int index) const {
  for (const TargetPlan& plan : shadow ? shadowcolor : colortex)
    if (plan.index == index) return &plan;
  return nullptr;
}

bool Schedule::sameTargets(const Schedule& other) const {
  return width == other.width && height == other.height &&
         shadowResolution == other.shadowResolution && colortex == other.colortex &&
         shadowcolor == other.shadowcolor && shadowtex1 == other.shadowtex1 &&
         depthtex1 == other.depthtex1 && depthtex2 == other.depthtex2;
}

Schedule buildSchedule(const ShaderPack& pack, int width, int height, const SceneContents& scene,
                       Diagnostics& diagnostics) {
  return Builder(pack, width, height, scene, diagnostics).build();
}

}  // namespace orris
