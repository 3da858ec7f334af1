#include <orris/check/graph/pass_graph.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <orris/check/compile/program_text.h>
#include <orris/check/frame/frame_passes.h>

namespace orris {
namespace {

using Kind = FramePass::Kind;

std::string colorName(bool shadow, int index) {
  return fmt::format("{}{}", shadow ? "shadowcolor" : "colortex", index);
}

std::string bufferName(const BufferName& buffer) {
  switch (buffer.kind) {
    case BufferName::Kind::Color:
      return colorName(false, buffer.index);
    case BufferName::Kind::ShadowColor:
      return colorName(true, buffer.index);
    case BufferName::Kind::Depth:
      return fmt::format("depthtex{}", buffer.index);
    case BufferName::Kind::ShadowDepth:
      return fmt::format("shadowtex{}", buffer.index);
    case BufferName::Kind::Stencil:
      return fmt::format("stenciltex{}", buffer.index);
  }
  return "";
}

bool isDepth(const BufferName& buffer) {
  return buffer.kind == BufferName::Kind::Depth || buffer.kind == BufferName::Kind::ShadowDepth;
}

const char* kindName(Kind kind) {
  switch (kind) {
    case Kind::Compute:
      return "compute";
    case Kind::Fullscreen:
      return "fullscreen";
    case Kind::Present:
      return "present";
    case Kind::Copy:
      return "copy";
    default:
      return "geometry";
  }
}

std::string groupName(const FramePass& pass) {
  switch (pass.group) {
    case ProgramGroup::Setup:
      return "setup";
    case ProgramGroup::Begin:
      return "begin";
    case ProgramGroup::Shadow:
      return "shadow";
    case ProgramGroup::ShadowComp:
      return "shadowcomp";
    case ProgramGroup::Prepare:
      return "prepare";
    case ProgramGroup::ShadowVolume:
      return "shadowvolume";
    case ProgramGroup::Deferred:
      return "deferred";
    case ProgramGroup::Composite:
      return "composite";
    case ProgramGroup::Final:
      return "final";
    default:
      return pass.translucent ? "translucent" : "gbuffers";
  }
}

/// Walks the frame once and keeps who filled which side.
class GraphBuilder {
 public:
  GraphBuilder(const ShaderPack& pack, const Schedule& schedule)
      : pack_(pack), schedule_(schedule), passes_(framePasses(pack, schedule)) {}

  PassGraph build() {
    graph_.pack = pack_.name.empty() ? "pack" : pack_.name;
    graph_.folder = pack_.folder;
    graph_.profile = pack_.currentProfile();
    graph_.width = schedule_.width;
    graph_.height = schedule_.height;
    addBuffers();
    // What the last frame left is known after the first walk.
    walk();
    history_ = sides_;
    graph_.passes.clear();
    sides_.clear();
    walk();
    graph_.images = pack_.properties.images;
    graph_.textures = pack_.properties.textures;
    graph_.bufferObjects = pack_.properties.bufferObjects;
    graph_.disabled = pack_.disabledPrograms;
    return std::move(graph_);
  }

 private:
  using Side = std::pair<std::string, bool>;

  void addBuffers() {
    for (const auto* plans : {&schedule_.colortex, &schedule_.shadowcolor})
      for (const TargetPlan& plan : *plans) {
        GraphBuffer& buffer = graph_.buffers.emplace_back();
        buffer.name = colorName(plans == &schedule_.shadowcolor, plan.index);
        buffer.format = plan.format;
        buffer.width = plan.width;
        buffer.height = plan.height;
        buffer.clear = plan.clear;
        buffer.clearToFog = plan.clearToFog;
        buffer.clearColor = plan.clearColor;
        buffer.history = plan.history;
        buffer.mipmaps = plan.mipmaps;
        buffer.twoSides = plan.needsAlt;
      }
  }

  void walk() {
    for (size_t i = 0; i < passes_.size(); ++i) addPass(passes_[i], i);
  }

  void addPass(const FramePass& pass, size_t index) {
    GraphPass out;
    out.title = pass.name;
    out.group = groupName(pass);
    out.kind = kindName(pass.kind);
    out.name = uniqueName(pass);
    out.drawn = pass.drawn;
    if (pass.kind == Kind::Copy) return addCopy(pass, std::move(out));
    if (pass.program != nullptr) {
      out.scale = pass.program->scale;
      const std::string folder = pass.program->folder == "/" ? "" : pass.program->folder;
      out.file = fmt::format("{}/{}.{}", folder, pass.program->name,
                             pass.kind == Kind::Compute ? "csh" : "fsh");
    }
    addSize(pass, out);
    addUses(pass, out);
    if (pass.kind == Kind::Compute) addComputes(pass, out);
    addWrites(pass, out);
    if (pass.kind == Kind::Fullscreen) addFlips(pass, index, out);
    graph_.passes.push_back(std::move(out));
  }

  void addCopy(const FramePass& pass, GraphPass out) {
    const bool center = pass.name.starts_with("sample");
    const bool shadow = pass.name.find("shadow") != std::string::npos;
    out.group = shadow ? "shadow" : "gbuffers";
    out.reads.push_back({.buffer = shadow ? "shadowtex0" : "depthtex0"});
    if (!center) out.writes.push_back({.buffer = pass.name.substr(pass.name.find('_') + 1)});
    graph_.passes.push_back(std::move(out));
  }

  std::string uniqueName(const FramePass& pass) const {
    std::string name = pass.name;
    if (pass.kind == Kind::Compute) name += " (compute)";
    const auto taken = [&] {
      return std::any_of(graph_.passes.begin(), graph_.passes.end(),
                         [&](const GraphPass& other) { return other.name == name; });
    };
    if (taken() && pass.translucent) name += " (translucent)";
    for (int i = 2; taken(); ++i) name = fmt::format("{} ({})", pass.name, i);
    return name;
  }

  void addSize(const FramePass& pass, GraphPass& out) {
    const bool shadow = pass.isShadowGroup();
    out.width = shadow ? schedule_.shadowResolution : schedule_.width;
    out.height = shadow ? schedule_.shadowResolution : schedule_.height;
    const TargetPlan* first =
        pass.writes.empty() ? nullptr : schedule_.target(shadow, pass.writes[0]);
    if (pass.kind != Kind::Fullscreen || first == nullptr) return;
    out.width = first->width;
    out.height = first->height;
  }

  void addUses(const FramePass& pass, GraphPass& out) {
    for (const BufferUse& use : pass.uses) {
      if (use.buffer.image) {
        addImage(pass, use, out);
      } else {
        addRead(pass, use.buffer, out);
      }
    }
    if (pass.kind == Kind::Present && pass.program == nullptr)
      addRead(pass, {BufferName::Kind::Color, 0, false}, out);
    addCustom(pass, out);
    std::stable_sort(
        out.reads.begin(), out.reads.end(), [](const GraphRead& a, const GraphRead& b) {
          return std::pair(a.buffer.size(), a.buffer) < std::pair(b.buffer.size(), b.buffer);
        });
  }

  void addRead(const FramePass& pass, const BufferName& buffer, GraphPass& out) {
    GraphRead read{.buffer = bufferName(buffer)};
    const bool known = std::any_of(out.reads.begin(), out.reads.end(),
                                   [&](const GraphRead& r) { return r.buffer == read.buffer; });
    if (known) return;
    if (!isDepth(buffer)) {
      const bool shadow = buffer.kind == BufferName::Kind::ShadowColor;
      read.alt = pass.readsAlt(shadow, buffer.index);
      read.mipmaps = shadow == pass.isShadowGroup() &&
                     std::count(pass.mipmaps.begin(), pass.mipmaps.end(), buffer.index) != 0;
      setSource(read, schedule_.target(shadow, buffer.index));
    }
    out.reads.push_back(std::move(read));
  }

  void setSource(GraphRead& read, const TargetPlan* plan) {
    read.from = sides_[{read.buffer, read.alt}];
    read.source = GraphRead::Source::Passes;
    if (!read.from.empty()) return;
    read.source = GraphRead::Source::Clear;
    if (plan == nullptr || plan->clear) return;
    // At the frame's end the side last written becomes main.
    const bool shadow = read.buffer.starts_with("shadow");
    const bool last =
        ((shadow ? schedule_.finalShadowFlipped : schedule_.finalFlipped) >> plan->index & 1u) != 0;
    read.source = GraphRead::Source::History;
    read.from = history_[{read.buffer, read.alt ? read.alt : last}];
  }

  void addImage(const FramePass& pass, const BufferUse& use, GraphPass& out) {
    const bool shadow = use.buffer.kind == BufferName::Kind::ShadowColor;
    GraphImage image{.name = use.name, .buffer = bufferName(use.buffer)};
    image.alt = pass.readsAlt(shadow, use.buffer.index);
    setAccess(pass, image);
    if (image.loads) addRead(pass, {use.buffer.kind, use.buffer.index, false}, out);
    if (image.stores) sides_[{image.buffer, image.alt}].push_back(out.name);
    out.images.push_back(std::move(image));
  }

  void addCustom(const FramePass& pass, GraphPass& out) {
    for (const CustomImage& image : pack_.properties.images) {
      if (pass.names.contains(image.name)) {
        GraphImage use{.name = image.name};
        setAccess(pass, use);
        out.images.push_back(std::move(use));
      }
      if (!image.sampler.empty() && pass.names.contains(image.sampler))
        out.images.push_back({.name = image.sampler, .loads = true});
    }
    const std::string stage = textureStageOf(pass.group);
    for (const TextureBinding& texture : pack_.properties.textures)
      if ((texture.stage.empty() || texture.stage == stage) && pass.names.contains(texture.sampler))
        out.textures.push_back(texture.sampler);
    std::sort(out.textures.begin(), out.textures.end());
    out.textures.erase(std::unique(out.textures.begin(), out.textures.end()), out.textures.end());
  }

  /// From the calls that name the image; a name handed to another function may do both.
  static void setAccess(const FramePass& pass, GraphImage& image) {
    const ImageAccess access = imageAccess(*pass.program, pass.kind == Kind::Compute, image.name);
    image.loads = access.loads;
    image.stores = access.stores;
  }

  void addWrites(const FramePass& pass, GraphPass& out) {
    const bool replaces = pass.kind == Kind::Fullscreen && pass.program != nullptr &&
                          !pass.program->blend && pass.program->bufferBlend.empty();
    for (size_t slot = 0; slot < pass.writes.size(); ++slot) {
      const int index = pass.writes[slot];
      GraphWrite write{.buffer = colorName(pass.isShadowGroup(), index),
                       .alt = pass.writesAlt(index),
                       .slot = static_cast<int>(slot)};
      auto& writers = sides_[{write.buffer, write.alt}];
      if (replaces) writers.clear();
      writers.push_back(out.name);
      out.writes.push_back(std::move(write));
    }
  }

  /// The bits before the next pass, less those before this one.
  void addFlips(const FramePass& pass, size_t index, GraphPass& out) {
    const bool last = index + 1 == passes_.size();
    const bool shadow = pass.isShadowGroup();
    const std::uint32_t before = shadow ? pass.shadowFlipped : pass.flipped;
    const std::uint32_t after = last     ? before
                                : shadow ? passes_[index + 1].shadowFlipped
                                         : passes_[index + 1].flipped;
    for (int i = 0; i < kColorTargets; ++i)
      if (((before ^ after) >> i & 1u) != 0) out.flips.push_back(colorName(shadow, i));
  }

  void addComputes(const FramePass& pass, GraphPass& out) {
    for (const ComputeSource& compute : pass.program->computes) {
      GraphCompute entry{.name = compute.name, .localSize = compute.localSize};
      entry.indirect = pack_.properties.indirect.contains(compute.name);
      entry.groups = groupsOf(compute, out);
      out.computes.push_back(std::move(entry));
    }
  }

  // Contract: constants.csv workGroups, workGroupsRender.
  static std::array<int, 3> groupsOf(const ComputeSource& compute, const GraphPass& pass) {
    if (compute.directives.workGroups) return *compute.directives.workGroups;
    const auto scale = compute.directives.workGroupsRender.value_or(std::array<float, 2>{1, 1});
    const std::array<int, 2> size =
        pass.group == "setup" ? std::array{1, 1} : std::array{pass.width, pass.height};
    std::array<int, 3> groups{1, 1, 1};
    for (size_t i = 0; i < 2; ++i) {
      const float texels = std::ceil(static_cast<float>(size[i]) * scale[i]);
      groups[i] = static_cast<int>(
          std::ceil(texels / static_cast<float>(std::max(1, compute.localSize[i]))));
    }
    return groups;
  }

  const ShaderPack& pack_;
  const Schedule& schedule_;
  const std::vector<FramePass> passes_;
  PassGraph graph_;
  std::map<Side, std::vector<std::string>> sides_, history_;
};

}  // namespace

PassGraph passGraph(const ShaderPack& pack, const Schedule& schedule) {
  return GraphBuilder(pack, schedule).build();
}

}  // namespace orris
