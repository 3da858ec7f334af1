#include <orris/check/frame/frame_passes.h>

#include <algorithm>
#include <array>

#include <orris/check/interface/stage_interface.h>
#include <orris/plan/schedule/schedule_targets.h>

namespace orris {
namespace {

using Kind = FramePass::Kind;

// Contract: README "Frame" 12.
constexpr std::array<std::string_view, 8> kTranslucent = {
    "gbuffers_water",      "gbuffers_entities_translucent",
    "gbuffers_particles",  "gbuffers_particles_translucent",
    "gbuffers_clouds",     "gbuffers_weather",
    "gbuffers_hand_water", "gbuffers_block_translucent"};

// Programs that draw the scene get no lower ones. Iris: IrisSamplers.addRenderTargetSamplers
constexpr int kFirstInGeometry = 4;

bool isTranslucent(std::string_view program) {
  return std::find(kTranslucent.begin(), kTranslucent.end(), program) != kTranslucent.end();
}

void addUsed(const StageText& stage, ProgramUses& names) {
  for (const StageGlobal& global : readStageInterface(stage).globals)
    if (global.storage == StageGlobal::Storage::Uniform && global.used) names.emplace(global.name);
}

ProgramUses targetNames(const ProgramSource& program, bool computes) {
  ProgramUses names;
  if (computes) {
    for (const ComputeSource& compute : program.computes) addUsed(compute.text, names);
  } else {
    for (const StageText& stage : program.stages) addUsed(stage, names);
  }
  return names;
}

bool isPass(const Step& step) {
  return step.kind != Step::Kind::ClearImages && step.kind != Step::Kind::ClearShadow &&
         step.kind != Step::Kind::ClearColor && step.kind != Step::Kind::ShadowMipmaps;
}

Kind kindOf(const Step& step) {
  switch (step.kind) {
    case Step::Kind::Compute:
      return Kind::Compute;
    case Step::Kind::Draw:
      return Kind::Geometry;
    case Step::Kind::DrawShadow:
      return Kind::Shadow;
    case Step::Kind::Present:
      return Kind::Present;
    case Step::Kind::CopyDepth:
    case Step::Kind::CopyShadowDepth:
    case Step::Kind::SampleCenterDepth:
      return Kind::Copy;
    default:
      return Kind::Fullscreen;
  }
}

bool isReplaced(const ShaderPack& pack, const FramePass& pass, const BufferName& buffer,
                const std::string& name) {
  const bool ended =
      buffer.kind == BufferName::Kind::Color && (pass.flippedInGroup >> buffer.index & 1u) != 0;
  const std::string stage = textureStageOf(pass.group);
  const auto& textures = pack.properties.textures;
  const auto& images = pack.properties.images;
  return (!ended && std::any_of(textures.begin(), textures.end(),
                                [&](const TextureBinding& texture) {
                                  return texture.sampler == name &&
                                         (texture.stage.empty() || texture.stage == stage);
                                })) ||
         std::any_of(images.begin(), images.end(), [&](const CustomImage& image) {
           return image.name == name || image.sampler == name;
         });
}

/// Where no texture of the scene is bound, a sampler named texture or gcolor, which the host renames,
/// reads colortex0. Iris: IrisSamplers.addRenderTargetSamplers
bool isDefaultSampler(const FramePass& pass, const std::string& name) {
  return name == "gtexture" && !pass.isGeometry();
}

void addBuffers(const ShaderPack& pack, FramePass& pass) {
  for (const std::string& name : pass.names) {
    const auto buffer = parseBufferName(isDefaultSampler(pass, name) ? "gcolor" : name,
                                        pass.names.contains("watershadow"));
    if (!buffer || isReplaced(pack, pass, *buffer, name)) continue;
    const bool color = buffer->kind == BufferName::Kind::Color;
    if (color && !buffer->image && pass.isGeometry() && buffer->index < kFirstInGeometry) {
      pass.unbound.push_back(name);
      continue;
    }
    if (color && pass.group == ProgramGroup::ShadowComp) continue;
    pass.uses.push_back({*buffer, name});
  }
}

class PassLister {
 public:
  PassLister(const ShaderPack& pack, const Schedule& schedule) : pack_(pack), schedule_(schedule) {}

  std::vector<FramePass> list() {
    for (const Step& step : schedule_.setup) add(step, true);
    for (const Step& step : schedule_.frame) add(step, false);
    for (const ProgramSource& program : pack_.programs) addUndrawn(program);
    for (FramePass& pass : passes_) addBuffers(pack_, pass);
    return std::move(passes_);
  }

 private:
  void add(const Step& step, bool setup) {
    if (!isPass(step)) return;
    FramePass pass;
    pass.kind = kindOf(step);
    pass.group = step.group;
    if (step.kind == Step::Kind::CopyShadowDepth) pass.group = ProgramGroup::Shadow;
    pass.setup = setup;
    pass.translucent = step.geometry == Geometry::Translucent;
    pass.writes = step.writes;
    pass.mipmaps = step.mipmaps;
    pass.flipped = step.flipped;
    pass.shadowFlipped = step.shadowFlipped;
    pass.flippedInGroup = step.flippedInGroup;
    pass.name = step.name;
    if (step.program >= 0) {
      pass.program = &pack_.programs[static_cast<size_t>(step.program)];
      pass.name = pass.program->name;
      pass.names = targetNames(*pass.program, pass.kind == Kind::Compute);
    }
    if (!drawnAlready(pass)) passes_.push_back(std::move(pass));
  }

  /// One program draws several geometries in a row: sky and stars, solid and cutout terrain.
  bool drawnAlready(const FramePass& pass) const {
    if (!pass.isGeometry()) return false;
    for (size_t i = passes_.size(); i-- > 0 && passes_[i].group == pass.group;)
      if (passes_[i].kind == pass.kind && passes_[i].name == pass.name &&
          (pass.kind == Kind::Shadow || passes_[i].translucent == pass.translucent))
        return true;
    return false;
  }

  /// The place of a geometry program: after the last that is drawn of its half.
  size_t placeFor(Kind kind, bool translucent) const {
    for (size_t i = passes_.size(); i-- > 0;)
      if (passes_[i].kind == kind &&
          (kind == Kind::Shadow || passes_[i].translucent == translucent))
        return i;
    return passes_.size();
  }

  void addUndrawn(const ProgramSource& program) {
    const bool shadow = program.group == ProgramGroup::Shadow;
    if ((!shadow && program.group != ProgramGroup::Gbuffers) || program.stages.empty()) return;
    const Kind kind = shadow ? Kind::Shadow : Kind::Geometry;
    const bool known = std::any_of(passes_.begin(), passes_.end(), [&](const FramePass& pass) {
      return pass.kind == kind && pass.program == &program;
    });
    if (known) return;
    const bool translucent = isTranslucent(program.name);
    const size_t place = placeFor(kind, translucent);
    if (place == passes_.size()) return;  // no such geometry in this frame
    FramePass pass = passes_[place];
    pass.name = program.name;
    pass.program = &program;
    pass.writes = program.drawBuffers;
    pass.mipmaps.clear();
    pass.drawn = false;
    pass.translucent = translucent;
    pass.names = targetNames(program, false);
    passes_.insert(passes_.begin() + static_cast<std::ptrdiff_t>(place) + 1, std::move(pass));
  }

  const ShaderPack& pack_;
  const Schedule& schedule_;
  std::vector<FramePass> passes_;
};

}  // namespace

bool BufferUse::isColor(bool shadow) const {
  return buffer.kind == (shadow ? BufferName::Kind::ShadowColor : BufferName::Kind::Color);
}

bool FramePass::isShadowGroup() const { return orris::isShadowGroup(group); }

bool FramePass::readsAlt(bool shadow, int buffer) const {
  return ((shadow ? shadowFlipped : flipped) >> buffer & 1u) != 0;
}

bool FramePass::writesAlt(int buffer) const {
  const bool bit = readsAlt(isShadowGroup(), buffer);
  // As Step::writesAlt: fullscreen programs write the side they do not read.
  if (kind == Kind::Fullscreen) return !bit;
  return kind == Kind::Shadow ? false : bit;
}

std::vector<FramePass> framePasses(const ShaderPack& pack, const Schedule& schedule) {
  return PassLister(pack, schedule).list();
}

}  // namespace orris
