#include <orris/plan/schedule/schedule_targets.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace orris {
namespace {

using Kind = Step::Kind;

class TargetPlanner {
 public:
  TargetPlanner(const ShaderPack& pack, const std::vector<ProgramUses>& uses,
                const FlippedBuffers& flipped, Schedule& schedule, Diagnostics& diagnostics)
      : pack_(pack),
        uses_(uses),
        flipped_(flipped),
        schedule_(schedule),
        diagnostics_(diagnostics) {}

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

  void checkSizes() {
    for (const Step& step : schedule_.frame) {
      if (step.program < 0 || isShadowGroup(step.group) || step.writes.size() < 1) continue;
      const TargetPlan* first = schedule_.target(false, step.writes[0]);
      for (int buffer : step.writes) {
        const TargetPlan* plan = schedule_.target(false, buffer);
        const bool window = plan->width == schedule_.width && plan->height == schedule_.height;
        // Iris: CompositeRenderer refuses unequal sizes; the framebuffer of a gbuffers program is
        // only drawn where all its buffers have texels.
        if (step.kind == Kind::Draw) {
          if (!window && writesOutputs(pack_.programs[step.program]))
            report(Severity::Warning, step, *plan,
                   "a gbuffers program covers the window: the rest of its picture is lost");
        } else if (plan->width != first->width || plan->height != first->height) {
          report(Severity::Error, step, *plan,
                 fmt::format("colortex{} of the same program is {}x{}", first->index, first->width,
                             first->height));
        }
      }
    }
  }

 private:
  /// Packs switch a program off by leaving its fragment stage empty.
  static bool writesOutputs(const ProgramSource& program) {
    if (program.writesFragData || program.stages.empty()) return true;
    const std::string& text = program.stages.back().text.text;
    return text.find("out ") != std::string::npos;
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
        case BufferName::Kind::Stencil:
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
    plan.needsAlt = (flipped_.color >> index & 1u) != 0 || writtenFullscreen(index, false);
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
    plan.needsAlt = (flipped_.shadowColor >> index & 1u) != 0 || writtenFullscreen(index, true);
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

  void report(Severity severity, const Step& step, const TargetPlan& plan, const std::string& why) {
    SourceLocation at = pack_.programs[step.program].directives.drawBuffersAt;
    if (at.file.empty()) at.file = pack_.programs[step.program].name;
    diagnostics_.push_back(
        {.severity = severity,
         .id = "target-size-mismatch",
         .at = at,
         .message = fmt::format("{} draws to colortex{} of {}x{}, but {}", step.name, plan.index,
                                plan.width, plan.height, why),
         .sourceLine = pack_.sourceLine(at.file, at.line),
         .hint = "give all draw buffers of one program the same size.buffer, or drop it"});
  }

  const ShaderPack& pack_;
  const std::vector<ProgramUses>& uses_;
  const FlippedBuffers& flipped_;
  Schedule& schedule_;
  Diagnostics& diagnostics_;
};

}  // namespace

bool isShadowGroup(ProgramGroup group) {
  return group == ProgramGroup::Shadow || group == ProgramGroup::ShadowComp;
}

void planTargets(const ShaderPack& pack, const std::vector<ProgramUses>& uses, bool shadow,
                 const FlippedBuffers& flipped, Schedule& schedule, Diagnostics& diagnostics) {
  TargetPlanner planner(pack, uses, flipped, schedule, diagnostics);
  planner.collectTargets(shadow);
  planner.checkSizes();
}

}  // namespace orris
