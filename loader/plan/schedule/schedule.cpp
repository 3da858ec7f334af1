#include <orris/plan/schedule/schedule.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include <orris/pack/versions/features.h>
#include <orris/plan/schedule/geometry_order.h>
#include <orris/plan/schedule/program_uses.h>
#include <orris/plan/schedule/schedule_targets.h>

namespace orris {
namespace {

using Kind = Step::Kind;

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
    addGeometry(geometry_order::kSky, Kind::Draw);
    addGeometry(geometry_order::kOpaque, Kind::Draw);
    const size_t beforeHand = schedule_.frame.size();
    addGeometry(geometry_order::kHand, Kind::Draw);
    const size_t afterOpaque = schedule_.frame.size();
    opaque_ = false;
    addShadowVolumes();
    addGroup(ProgramGroup::Deferred, schedule_.frame);
    addGeometry(geometry_order::kTranslucent, Kind::Draw);
    addGroup(ProgramGroup::Composite, schedule_.frame);
    addFinal();
    schedule_.finalFlipped = flipped_;
    schedule_.finalShadowFlipped = shadowFlipped_;
    planTargets(pack_, uses_, shadow, {everFlipped_, everShadowFlipped_}, schedule_, diagnostics_);
    addDepthCopies(beforeHand, afterOpaque);
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
    // Iris: IrisRenderingPipeline's samplers of gbuffers and shadow know of no flips.
    const bool geometry = kind == Kind::Draw || kind == Kind::DrawShadow;
    step.flippedInGroup = geometry ? 0 : groupFlips_;
    steps.push_back(std::move(step));
    return steps.back();
  }

  int indexOf(const ProgramSource* program) const {
    return program == nullptr ? -1 : pack_.programs.indexOf(program);
  }

  // Contract properties.csv "shadow.enabled": the pass exists when something outside it looks at
  // shadow buffers, or the pack forces it.
  bool shadowWanted() const {
    const auto& settings = pack_.properties.settings;
    if (const auto it = settings.find("shadow.enabled"); it != settings.end())
      return pack_.properties.flag("shadow.enabled", true);
    for (size_t i = 0; i < pack_.programs.size(); ++i) {
      const ProgramGroup group = pack_.programs[i].group;
      if (isShadowGroup(group)) continue;
      if (group == ProgramGroup::Gbuffers && !gbuffersDrawn(pack_.programs[i])) continue;
      if (usesShadow(uses_[i])) return true;
    }
    return false;
  }

  bool gbuffersDrawn(const ProgramSource& program) const {
    using Passes = std::span<const GeometryPass>;
    using namespace geometry_order;
    for (const Passes passes : {Passes(kSky), Passes(kOpaque), Passes(kHand), Passes(kTranslucent)})
      for (const GeometryPass& pass : passes)
        if (present(pass) && wanted(pass, Kind::Draw) &&
            pack_.resolve(programOf(pass, Kind::Draw)) == &program)
          return true;
    return false;
  }

  bool present(const GeometryPass& pass) const {
    return pass.needed != nullptr ? scene_.*pass.needed
                                  : (scene_.content & bitOf(pass.geometry)) != 0;
  }

  static std::string_view programOf(const GeometryPass& pass, Kind kind) {
    if (pass.needed != nullptr) return pass.program;
    const ContentKind& row = *findContentKind(pass.geometry);
    return kind == Kind::DrawShadow ? row.shadowProgram : row.program;
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

  void addGeometry(std::span<const GeometryPass> passes, Kind kind) {
    if (kind == Kind::Draw && pack_.properties.flag("skipAllRendering", false)) return;
    for (const GeometryPass& pass : passes) {
      if (!present(pass) || !wanted(pass, kind) || !inThisHalf(pass.geometry, kind)) continue;
      const std::string_view name = programOf(pass, kind);
      const ProgramSource* program = pack_.resolve(name);
      if (program != nullptr && program->stages.empty()) program = nullptr;
      Step& step = add(kind, std::string(name));
      step.program = indexOf(program);
      step.group = kind == Kind::DrawShadow ? ProgramGroup::Shadow : ProgramGroup::Gbuffers;
      step.geometry = pass.geometry;
      step.writes = program != nullptr ? program->drawBuffers : std::vector<int>{0};
    }
  }

  /// Some content is drawn before the deferred programs or after them. Iris: IrisRenderingPipeline,
  /// ParticleRenderingSettings.
  bool inThisHalf(Geometry geometry, Kind kind) const {
    if (kind == Kind::DrawShadow) return true;
    const bool blends = geometry == Geometry::EntitiesTranslucent;
    if (blends) return opaque_ != pack_.properties.flag("separateEntityDraws", false);
    if (geometry != Geometry::Particles && geometry != Geometry::ParticlesTranslucent) return true;
    const std::string order = particleOrder();
    if (order == "mixed") return opaque_ == (geometry == Geometry::Particles);
    return opaque_ == (order == "before");
  }

  std::string particleOrder() const {
    const auto& settings = pack_.properties.settings;
    if (const auto it = settings.find("particles.ordering"); it != settings.end()) {
      std::string order = it->second;
      std::transform(order.begin(), order.end(), order.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      return order;
    }
    if (settings.contains("separateEntityDraws")) return "mixed";
    if (pack_.properties.flag("particles.before.deferred", false)) return "before";
    const bool deferred =
        std::any_of(pack_.programs.begin(), pack_.programs.end(), [](const ProgramSource& program) {
          return program.group == ProgramGroup::Deferred;
        });
    return deferred ? "after" : "mixed";
  }

  bool wanted(const GeometryPass& pass, Kind kind) const {
    const auto& p = pack_.properties;
    const bool shadow = kind == Kind::DrawShadow;
    switch (pass.geometry) {
      case Geometry::Sky:
      case Geometry::EndSky:
        return p.flag("sky", true);
      case Geometry::Stars:
        return p.flag("stars", true);
      case Geometry::SunMoon:
        return p.flag("sun", true) || p.flag("moon", true);
      case Geometry::Solid:
      case Geometry::Cutout:
        return !shadow || p.flag("shadowTerrain", true);
      case Geometry::BlockEntity:
        return !shadow || p.flag("shadowBlockEntities", true) || p.flag("shadowLightBlockEntities", false);
      case Geometry::BlockText:
      case Geometry::BeamCore:
      case Geometry::BeamGlow:
        return !shadow || p.flag("shadowBlockEntities", true);
      case Geometry::Leash:
      case Geometry::Entities:
      case Geometry::EntitiesTranslucent:
      case Geometry::Lightning:
        return !shadow || p.flag("shadowEntities", true);
      case Geometry::PlayerBody:
        return p.flag("shadowEntities", true) || p.flag("shadowPlayer", false);
      case Geometry::Rain:
      case Geometry::Snow:
        return weatherDrawn();
      case Geometry::Translucent:
        return !shadow || p.flag("shadowTranslucent", true);
      case Geometry::CloudsFast:
        return clouds() == Clouds::Fast;
      case Geometry::CloudsFancy:
        return clouds() == Clouds::Fancy;
      default:
        return true;
    }
  }

  // The first of two words; the second is about particles that the game makes where rain falls.
  bool weatherDrawn() const {
    const auto it = pack_.properties.settings.find("weather");
    return it == pack_.properties.settings.end() || !it->second.starts_with("false");
  }

  Clouds clouds() const {
    const auto it = pack_.properties.settings.find("clouds");
    if (it == pack_.properties.settings.end()) return scene_.clouds;
    return it->second == "fancy"  ? Clouds::Fancy
           : it->second == "fast" ? Clouds::Fast
                                  : Clouds::Off;
  }

  void addShadow() {
    add(Kind::ClearShadow, "clear_shadow");
    if (pack_.properties.flag("shadow.enabled", true)) {
      addGeometry(geometry_order::kShadowOpaque, Kind::DrawShadow);
      add(Kind::CopyShadowDepth, "copy_shadowtex1");
      addGeometry(geometry_order::kShadowTranslucent, Kind::DrawShadow);
      add(Kind::ShadowMipmaps, "shadow_mipmaps");
    }
    addGroup(ProgramGroup::ShadowComp, schedule_.frame);
  }

  // Our extension: only where a program looks at the result.
  void addShadowVolumes() {
    const ProgramSource* program = pack_.find("shadowvolume");
    if (program == nullptr || program->stages.empty() || !declaresShadowVolumes()) return;
    for (size_t i = 0; i < pack_.programs.size(); ++i) {
      if (!isFullscreen(pack_.programs[i].group)) continue;
      schedule_.sunVolumes |= uses_[i].contains("stenciltex0");
      schedule_.lampShadows |= uses_[i].contains("stenciltex1");
    }
    schedule_.stencil = schedule_.sunVolumes || schedule_.lampShadows;
    if (!schedule_.stencil) return;
    Step& step = add(Kind::ShadowVolumes, program->name);
    step.program = indexOf(program);
    step.group = ProgramGroup::ShadowVolume;
  }

  bool declaresShadowVolumes() const {
    const auto& p = pack_.properties;
    return std::count(p.orrisOptionalFeatures.begin(), p.orrisOptionalFeatures.end(),
                      kShadowVolumes) != 0 ||
           std::count(p.orrisRequiredFeatures.begin(), p.orrisRequiredFeatures.end(),
                      kShadowVolumes) != 0;
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

  // Copies only what some program reads; depthtex2 lies before the hand, depthtex1 after it.
  void addDepthCopies(size_t beforeHand, size_t afterOpaque) {
    std::vector<Step> copies, copiesAfterHand;
    const std::uint32_t bits =
        afterOpaque < schedule_.frame.size() ? schedule_.frame[afterOpaque].flipped : flipped_;
    const auto push = [&](std::vector<Step>& list, Kind kind, std::string name, int index) {
      Step step;
      step.kind = kind;
      step.name = std::move(name);
      step.index = index;
      step.flipped = bits;
      list.push_back(step);
    };
    if (schedule_.centerDepth) push(copies, Kind::SampleCenterDepth, "sample_center_depth", 0);
    if (schedule_.depthtex2) push(copies, Kind::CopyDepth, "copy_depthtex2", 2);
    if (schedule_.depthtex1) push(copiesAfterHand, Kind::CopyDepth, "copy_depthtex1", 1);
    const auto at = [&](size_t place) {
      return schedule_.frame.begin() + static_cast<std::ptrdiff_t>(place);
    };
    schedule_.frame.insert(at(afterOpaque), copiesAfterHand.begin(), copiesAfterHand.end());
    schedule_.frame.insert(at(beforeHand), copies.begin(), copies.end());
    std::erase_if(schedule_.frame, [&](const Step& step) {
      return step.kind == Kind::CopyShadowDepth && !schedule_.shadowtex1;
    });
  }

  const ShaderPack& pack_;
  const SceneContents& scene_;
  Diagnostics& diagnostics_;
  std::vector<ProgramUses> uses_;
  Schedule schedule_;
  std::uint32_t flipped_ = 0, shadowFlipped_ = 0, everFlipped_ = 0, everShadowFlipped_ = 0;
  std::uint32_t groupFlips_ = 0;
  bool opaque_ = true;  ///< what is added is drawn before the deferred programs
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
         depthtex1 == other.depthtex1 && depthtex2 == other.depthtex2 && stencil == other.stencil &&
         lampShadows == other.lampShadows;
}

Schedule buildSchedule(const ShaderPack& pack, int width, int height, const SceneContents& scene,
                       Diagnostics& diagnostics) {
  return Builder(pack, width, height, scene, diagnostics).build();
}

}  // namespace orris
