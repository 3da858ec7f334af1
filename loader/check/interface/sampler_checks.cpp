#include <orris/check/interface/sampler_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include <orris/check/interface/glsl_types.h>
#include <orris/image/texel_format.h>
#include <orris/plan/schedule/program_uses.h>

namespace orris {
namespace {

using BufferKind = BufferName::Kind;

constexpr std::string_view kOneWord = "R32F";

/// What a name stands for.
struct Bound {
  std::string what;      ///< for people: "colortex4 (RGB32UI)"
  char component = 'f';  ///< as in OpaqueType
  int dimensions = 2;
  bool depth = false;     ///< a depth texture
  bool compares = false;  ///< ... with comparison
  bool oneWord = false;   ///< R32F: one float of 32 bits
};

char componentOf(std::string_view format) {
  const TextureFormat* found = findFormat(format);
  if (!found) return 'f';
  if (found->formatClass == FormatClass::Uint) return 'u';
  return found->formatClass == FormatClass::Int ? 'i' : 'f';
}

/// The textures of shaders.properties that the program reads by this name: "colortex4.1" gives one more
/// of another type.
std::vector<const TextureBinding*> replacementsOf(const ShaderPack& pack,
                                                  const ProgramSource& program,
                                                  const std::string& name) {
  const std::string stage = textureStageOf(program.group);
  std::vector<const TextureBinding*> found;
  for (const TextureBinding& texture : pack.properties.textures) {
    if (canonicalBuffer(texture.sampler) == canonicalBuffer(name) &&
        (texture.stage.empty() || texture.stage == stage))
      found.push_back(&texture);
  }
  return found;
}

/// Images are flat; what a raw texture is, its line says.
std::optional<Bound> imageOf(const std::vector<const TextureBinding*>& textures) {
  const bool raw = std::ranges::any_of(
      textures, [](const TextureBinding* texture) { return !texture->rawType.empty(); });
  if (raw) return std::nullopt;
  return Bound{.what = textures.front()->path};
}

Bound targetOf(const ShaderPack& pack, bool shadow, int index) {
  const auto& targets = shadow ? pack.directives.shadowcolor : pack.directives.colortex;
  const auto found = targets.find(index);
  const std::string format = found == targets.end() ? "RGBA" : found->second.format;
  return {
      .what = fmt::format("{}{}, whose format is {}", shadow ? "shadowcolor" : "colortex", index,
                          format),
      .component = componentOf(format),
      .oneWord = format == kOneWord};
}

/// Does any file of any folder ask for comparison? Then a folder without shadows may lack it.
bool filtersSomewhere(const ShaderPack& pack) {
  return std::any_of(pack.files.begin(), pack.files.end(), [](const auto& file) {
    return std::any_of(file.second.begin(), file.second.end(), [](const std::string& line) {
      return line.find("shadowHardwareFiltering") != std::string::npos;
    });
  });
}

std::optional<Bound> bufferOf(const ShaderPack& pack, const ProgramSource& program,
                              const BufferName& buffer) {
  const bool geometry =
      program.group == ProgramGroup::Gbuffers || program.group == ProgramGroup::Shadow;
  switch (buffer.kind) {
    case BufferKind::Color:
      // In geometry programs the first four names are the atlas.
      if (geometry && buffer.index < 4 && !buffer.image) return std::nullopt;
      return targetOf(pack, false, buffer.index);
    case BufferKind::ShadowColor:
      return targetOf(pack, true, buffer.index);
    case BufferKind::Depth:
      return Bound{.what = fmt::format("depthtex{}", buffer.index), .depth = true};
    case BufferKind::Stencil:
      return Bound{.what = fmt::format("stenciltex{}, whose values are integers", buffer.index),
                   .component = 'u'};
    case BufferKind::ShadowDepth: {
      const auto index = static_cast<std::size_t>(std::clamp(buffer.index, 0, 1));
      return Bound{
          .what = fmt::format("shadowtex{}", buffer.index),
          .depth = true,
          .compares = pack.directives.shadowtex[index].hardwareFiltering || filtersSomewhere(pack)};
    }
  }
  return std::nullopt;
}

std::optional<Bound> boundTo(const ShaderPack& pack, const ProgramSource& program,
                             const StageGlobal& global, bool image) {
  const std::string name(global.name);
  for (const CustomImage& custom : pack.properties.images) {
    if ((image ? custom.name : custom.sampler) != name) continue;
    return Bound{.what = fmt::format("{}, whose format is {}", name, custom.internalFormat),
                 .component = componentOf(custom.internalFormat),
                 .dimensions = custom.dimensions,
                 .oneWord = custom.internalFormat == kOneWord};
  }
  const auto textures =
      image ? std::vector<const TextureBinding*>() : replacementsOf(pack, program, name);
  // Programs share declarations, and what is replaced in one of them is not in another.
  if (!textures.empty()) return global.used ? imageOf(textures) : std::nullopt;
  const auto buffer = parseBufferName(name, false);
  if (!buffer || buffer->image != image) return std::nullopt;
  return bufferOf(pack, program, *buffer);
}

std::string wantedType(const Bound& bound, bool image) {
  return fmt::format("{}{}{}D", bound.component == 'f' ? "" : std::string(1, bound.component),
                     image ? "image" : "sampler", bound.dimensions);
}

}  // namespace

std::optional<SamplerProblem> samplerProblem(const ShaderPack& pack, const ProgramSource& program,
                                             const StageGlobal& global) {
  const OpaqueType type = opaqueType(global.type);
  if (type.component == 0) return std::nullopt;
  const auto bound = boundTo(pack, program, global, type.image);
  if (!bound) return std::nullopt;
  const std::string wanted = wantedType(*bound, type.image);
  if (type.dimensions != bound->dimensions || type.array) {
    return SamplerProblem{"sampler-type",
                          fmt::format("{} cannot read {}", global.type, bound->what),
                          fmt::format("declare it as {}", wanted)};
  }
  // Iris: IrisSamplers
  if (!bound->compares && global.name.starts_with("shadowtex") && global.name.ends_with("HW")) {
    return SamplerProblem{
        "sampler-type",
        fmt::format("{} is bound only where shadow maps are compared", global.name),
        "set const bool shadowHardwareFiltering = true;, or read shadowtex0 or shadowtex1",
        global.used ? Severity::Warning : Severity::Note};
  }
  if (type.shadow && !bound->compares) {
    return SamplerProblem{
        "sampler-type", fmt::format("{} reads {}, which is not compared", global.type, bound->what),
        bound->depth && bound->what.starts_with("shadowtex")
            ? "set const bool shadowHardwareFiltering = true;, or declare it as sampler2D"
            : "declare it as sampler2D"};
  }
  if (!type.shadow && type.component != bound->component) {
    // Atomics are for integers alone, so that packs give them the bits of floats.
    const bool bits = type.image && bound->oneWord;
    return SamplerProblem{
        "sampler-format", fmt::format("{} cannot read {}", global.type, bound->what),
        bits ? fmt::format("declare it as {}, unless you mean the bits of the floats: many drivers "
                           "give them, no specification says so",
                           wanted)
             : fmt::format("declare it as {}", wanted),
        bits ? Severity::Note : Severity::Warning};
  }
  return std::nullopt;
}

}  // namespace orris
