// Uniforms, samplers, images and attributes: are their names known, and their types right?
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <orris/check/interface/declaration_checks.h>
#include <orris/check/interface/glsl_types.h>
#include <orris/check/interface/known_names.h>
#include <orris/check/interface/sampler_checks.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Storage = StageGlobal::Storage;
using Finding = DeclarationReport::Finding;

NameKind nameKind(const StageGlobal& global) {
  if (global.storage == Storage::In) return NameKind::Attribute;
  const OpaqueType opaque = opaqueType(global.type);
  if (opaque.component == 0) return NameKind::Uniform;
  return opaque.image ? NameKind::Image : NameKind::Sampler;
}

const CustomUniform* findCustom(const ShaderPack& pack, std::string_view name) {
  const auto& all = pack.properties.customUniforms;
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const CustomUniform& uniform) { return uniform.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Names that shaders.properties adds to those of a kind.
std::vector<std::string> packNames(const ShaderPack& pack, NameKind kind) {
  std::vector<std::string> names;
  const ShaderProperties& properties = pack.properties;
  if (kind == NameKind::Uniform) {
    for (const CustomUniform& uniform : properties.customUniforms) names.push_back(uniform.name);
  }
  if (kind == NameKind::Sampler) {
    for (const TextureBinding& texture : properties.textures) names.push_back(texture.sampler);
    for (const CustomImage& image : properties.images) {
      if (!image.sampler.empty()) names.push_back(image.sampler);
    }
  }
  if (kind == NameKind::Image) {
    for (const CustomImage& image : properties.images) names.push_back(image.name);
  }
  return names;
}

bool isOneSlip(std::string_view name, const std::string& meant) {
  // "cameraMovement" is no slip of "cameraMovementX".
  if (name.starts_with(meant) || meant.starts_with(name)) return false;
  return editDistance(name, meant) == 1 && !likelyMeant(name, {meant}).empty();
}

class StageNames {
 public:
  StageNames(const ProgramInterface& program, const StageInterface& stage,
             DeclarationReport& report)
      : program_(program), stage_(stage), report_(report), pack_(report.folder.pack) {}

  void check() {
    for (const StageGlobal& global : stage_.globals) {
      if (isChecked(global)) checkGlobal(global);
    }
  }

 private:
  bool isChecked(const StageGlobal& global) const {
    if (global.block || global.name.empty() || global.name.starts_with("gl_")) return false;
    if (global.storage == Storage::Uniform) return !global.initialised;
    return global.storage == Storage::In && stage_.stage->stage == Stage::Vertex;
  }

  void checkGlobal(const StageGlobal& global) {
    const NameKind kind = nameKind(global);
    const KnownName* known = findKnownName(kind, global.name);
    const CustomUniform* custom =
        kind == NameKind::Uniform ? findCustom(pack_, global.name) : nullptr;
    if (custom) {
      checkCustom(global, *custom);
    } else if (known) {
      checkType(global, known->type, "the host gives");
    } else {
      const std::vector<std::string> own = packNames(pack_, kind);
      if (std::find(own.begin(), own.end(), global.name) == own.end())
        return reportUnknown(global, kind, own);
    }
    if (const auto problem = samplerProblem(pack_, *program_.program, global)) {
      const bool noted = !global.used && problem->id != "sampler-type";
      report_.add(stage_, global.place,
                  {noted ? Severity::Note : problem->severity,
                   problem->id,
                   problem->message,
                   problem->hint,
                   {}});
    }
  }

  void checkCustom(const StageGlobal& global, const CustomUniform& custom) {
    if (custom.uploaded || findKnownName(NameKind::Uniform, global.name)) {
      return checkType(global, uniformTypeName(custom.type), "shaders.properties gives");
    }
    if (!global.used) return;
    report_.add(stage_, global.place,
                {Severity::Warning,
                 "uniform-unknown",
                 fmt::format("'{}' is a variable of shaders.properties, which shaders do not see",
                             global.name),
                 fmt::format("write uniform.{}.{} in {}:{}", uniformTypeName(custom.type),
                             custom.name, custom.at.file, custom.at.line),
                 {}});
  }

  // Iris: ProgramUniforms. A bool is given as an int, any other difference turns the uniform off.
  void checkType(const StageGlobal& global, std::string_view type, const char* who) {
    if (type.empty() || global.storage != Storage::Uniform) return;
    const auto plain = [](std::string_view name) { return name == "bool" ? "int" : name; };
    if (plain(type) == plain(global.type) && global.arraySizes.empty()) return;
    report_.add(
        stage_, global.place,
        {global.used ? Severity::Error : Severity::Warning,
         "uniform-type",
         fmt::format("'{}' is declared as {}{}, {} {}", global.name, global.type,
                     global.arraySizes.empty() ? "" : "[]", who, type),
         fmt::format("write uniform {} {}; with another type it stays 0", type, global.name),
         {}});
  }

  /// Does the author? The host adds what is used without being declared.
  bool declares(std::string_view name) const {
    const MappedText& text = stage_.stage->text;
    return std::any_of(stage_.globals.begin(), stage_.globals.end(),
                       [&](const StageGlobal& global) {
                         return global.name == name &&
                                !text.locate(global.place.line, global.place.column).file.empty();
                       });
  }

  void reportUnknown(const StageGlobal& global, NameKind kind, std::vector<std::string> own) {
    const auto& known = knownNames(kind);
    own.insert(own.end(), known.begin(), known.end());
    // Iris: IrisSamplers.addLevelSamplers. They are bound where blocks and entities are drawn.
    if (isFullscreen(program_.program->group)) {
      std::erase(own, "normals");
      std::erase(own, "specular");
    }
    const std::string nearest = nearestName(global.name, own);
    // Nothing uses it, and the name that was meant is one slip away or is used undeclared.
    const bool meant =
        !global.used && !nearest.empty() && !declares(nearest) &&
        (isOneSlip(global.name, nearest) || occursAsWord(stage_.stage->text.text, nearest));
    // An attribute with a number of its own is found by the number, on some hosts and drivers.
    const bool numbered = kind == NameKind::Attribute && global.layout.location >= 0;
    std::string hint = nearest.empty() ? "" : fmt::format("did you mean {}?", nearest);
    const auto& uniforms = knownNames(NameKind::Uniform);
    if (kind == NameKind::Attribute && std::ranges::find(uniforms, global.name) != uniforms.end())
      hint = fmt::format("it is a uniform: write uniform {} {};", global.type, global.name);
    if (hint.empty() && kind == NameKind::Uniform)
      hint = "define it in shaders.properties: uniform.<type>.<name> = <expression>";
    // The targets of other types have no texture there.
    if (hint.empty() && kind == NameKind::Sampler && global.type == "sampler2D")
      hint = "it reads texture unit 0: gtexture in gbuffers and shadow programs, colortex0 in fullscreen ones";
    report_.add(stage_, global.place,
                {(global.used || meant) && !numbered ? Severity::Warning : Severity::Note,
                 kind == NameKind::Attribute ? "attribute-unknown" : "uniform-unknown",
                 fmt::format("no {} is called '{}'", nameKindWord(kind), global.name),
                 hint,
                 {}});
  }

  const ProgramInterface& program_;
  const StageInterface& stage_;
  DeclarationReport& report_;
  const ShaderPack& pack_;
};

/// A uniform is one variable for all stages of a program: drivers refuse two types.
void checkConflicts(const ProgramInterface& program, DeclarationReport& report) {
  struct Seen {
    const StageInterface* stage;
    const StageGlobal* global;
  };
  std::map<std::string_view, Seen> seen;
  for (const StageInterface& stage : program.stages) {
    for (const StageGlobal& global : stage.globals) {
      if (global.storage != Storage::Uniform || global.block) continue;
      const auto [first, isNew] = seen.try_emplace(global.name, Seen{&stage, &global});
      if (isNew || first->second.global->type == global.type) continue;
      const Seen& there = first->second;
      report.addPair({*there.stage, there.global->place}, {stage, global.place},
                     {Severity::Error,
                      "uniform-conflict",
                      fmt::format("'{}' is {} in the {} stage and {} in the {} stage", global.name,
                                  there.global->type, stageName(there.stage->stage->stage),
                                  global.type, stageName(stage.stage->stage)),
                      "use one type in all stages",
                      {"in " + program.name()}});
    }
  }
}

}  // namespace

void checkNames(const ProgramInterface& program, DeclarationReport& report) {
  checkConflicts(program, report);
  for (const StageInterface& stage : program.stages) StageNames(program, stage, report).check();
}

}  // namespace orris
