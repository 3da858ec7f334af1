#include <orris/check/pack/version_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include <orris/check/interface/glsl_types.h>
#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>
#include <orris/pack/versions/iris_versions.h>
#include <orris/plan/schedule/program_uses.h>

namespace orris {
namespace {

using Storage = StageGlobal::Storage;

/// What the pack is checked for; no Iris: nothing to compare with.
struct Host {
  Version iris, game;
};
std::optional<Host> checkedHost(const ShaderPack& pack) {
  const auto iris = irisVersionOf(pack.propertyMacros);
  if (!iris) return std::nullopt;
  return Host{*iris, gameVersionOf(pack.propertyMacros)};
}

/// "Iris 1.10.5", or "Minecraft 1.21.9" where the game lacks it; "" when the host has it.
std::string needed(const OfferRow& row, const Host& host) {
  if (host.iris < row.iris) return "Iris " + versionText(row.iris);
  if (host.game < row.game) return "Minecraft " + versionText(row.game);
  return "";
}

std::string guardOf(std::string_view version) {
  const bool iris = version.starts_with("Iris");
  const auto number = parseVersion(version.substr(version.find(' ') + 1));
  return fmt::format("guard it with #if {} >= {}", iris ? "IRIS_VERSION" : "MC_VERSION",
                     number ? versionNumber(*number) : 0);
}

DeclarationReport::Finding newer(std::string_view what, std::string_view version,
                                 std::string_view effect, const Host& host) {
  return {Severity::Warning,
          "version-newer",
          fmt::format("{} is there since {}; with Iris {} and Minecraft {} {}", what, version,
                      versionText(host.iris), versionText(host.game), effect),
          guardOf(version),
          {}};
}

bool definedByPack(const ShaderPack& pack, std::string_view name) {
  const auto& all = pack.properties.customUniforms;
  return std::any_of(all.begin(), all.end(),
                     [&](const CustomUniform& uniform) { return uniform.name == name; });
}

/// Where the author's text of the stage first says `name`; line 0: nowhere.
TextPlace firstMention(const StageInterface& stage, std::string_view name) {
  const std::string& text = stage.stage->text.text;
  int line = 1;
  size_t begin = 0;
  for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const size_t end = at + name.size();
    if ((at > 0 && isWordCharacter(text[at - 1])) ||
        (end < text.size() && isWordCharacter(text[end])))
      continue;
    for (size_t i = begin; i < at; ++i) {
      if (text[i] != '\n') continue;
      ++line;
      begin = i + 1;
    }
    const TextPlace place{line, static_cast<int>(at - begin) + 1};
    if (!stage.stage->text.locate(place.line, place.column).file.empty()) return place;
  }
  return {};
}

class NewNames {
 public:
  NewNames(const ProgramInterface& program, const Host& host, DeclarationReport& report)
      : program_(program), host_(host), report_(report) {}

  void check() {
    for (const StageInterface& stage : program_.stages) {
      for (const StageGlobal& global : stage.globals) {
        if (!global.used || global.block) continue;
        if (global.storage == Storage::In && stage.stage->stage == Stage::Vertex)
          checkName(stage, global, Offer::Attribute, "the program is refused");
        if (global.storage == Storage::Uniform) checkUniform(stage, global);
      }
    }
    checkDrawBuffers();
  }

 private:
  void checkUniform(const StageInterface& stage, const StageGlobal& global) {
    if (opaqueType(global.type).component == 0)
      return checkName(stage, global, Offer::Uniform, "it stays 0");
    const auto buffer = parseBufferName(global.name, false);
    if (!buffer || buffer->kind != BufferName::Kind::Color) return;
    if (buffer->index >= colorBuffersOf(host_.iris))
      add(stage, global, "Iris " + versionText(kMoreBuffers), lastBuffer());
  }

  void checkName(const StageInterface& stage, const StageGlobal& global, Offer kind,
                 const std::string& effect) {
    const OfferRow* row = findOffer(kind, global.name);
    const std::string version = row == nullptr ? "" : needed(*row, host_);
    if (version.empty() || definedByPack(report_.folder.pack, global.name)) return;
    add(stage, global, version, effect);
  }

  void add(const StageInterface& stage, const StageGlobal& global, const std::string& version,
           const std::string& effect) {
    TextPlace place = global.place;
    // What the host declares is met where the author uses it.
    if (stage.stage->text.locate(place.line, place.column).file.empty())
      place = firstMention(stage, global.name);
    if (place.line == 0) return;
    report_.add(stage, place, newer(fmt::format("'{}'", global.name), version, effect, host_));
  }

  void checkDrawBuffers() {
    if (program_.compute || !program_.program->directives.drawBuffers) return;
    const ProgramGroup group = program_.program->group;
    if (group == ProgramGroup::Shadow || group == ProgramGroup::ShadowComp) return;
    for (const int buffer : *program_.program->directives.drawBuffers) {
      if (buffer < colorBuffersOf(host_.iris)) continue;
      report_.add(program_.program->directives.drawBuffersAt,
                  newer(fmt::format("colortex{}", buffer), "Iris " + versionText(kMoreBuffers),
                        lastBuffer(), host_));
    }
  }

  std::string lastBuffer() const {
    return fmt::format("the last one is colortex{}", colorBuffersOf(host_.iris) - 1);
  }

  const ProgramInterface& program_;
  const Host& host_;
  DeclarationReport& report_;
};

/// Words of an entry that name something which is newer than the host.
class NewWords {
 public:
  NewWords(const Host& host, Diagnostics& diagnostics) : host_(host), diagnostics_(diagnostics) {}

  void check(const PropertyEntry& entry) {
    if (const OfferRow* row = findOffer(Offer::Property, entry.key))
      add(entry, entry.key, needed(*row, host_), "the line is ignored", "");
    if (entry.key.starts_with("bufferObject.")) checkBufferObject(entry);
    const bool formats = entry.key.starts_with("image.") || entry.key.starts_with("texture.") ||
                         entry.key.starts_with("customTexture.");
    if (!formats) return;
    for (const std::string& word : splitBlanks(entry.value)) {
      for (const Offer kind : {Offer::PixelType, Offer::InternalFormat}) {
        if (const OfferRow* row = findOffer(kind, upperCase(word)))
          add(entry, word, needed(*row, host_), "the pack is refused", word);
      }
    }
  }

 private:
  void checkBufferObject(const PropertyEntry& entry) {
    const auto index = parseInteger(std::string_view(entry.key).substr(entry.key.find('.') + 1));
    const int count = bufferObjectsOf(host_.iris);
    if (!index || *index < count) return;
    add(entry, entry.key, "Iris " + versionText(kMoreBuffers),
        fmt::format("the last one is bufferObject.{}", count - 1), "");
  }

  void add(const PropertyEntry& entry, std::string_view what, const std::string& version,
           const std::string& effect, std::string_view word) {
    if (version.empty()) return;
    const DeclarationReport::Finding found = newer(what, version, effect, host_);
    diagnostics_.push_back(
        propertyDiagnostic(found.severity, found.id, entry, found.message, found.hint, word));
  }

  const Host& host_;
  Diagnostics& diagnostics_;
};

}  // namespace

void checkNewNames(const ProgramInterface& program, DeclarationReport& report) {
  if (const auto host = checkedHost(report.folder.pack)) NewNames(program, *host, report).check();
}

void checkNewProperties(const FolderInput& input, Diagnostics& diagnostics) {
  constexpr const char* kPropertiesPath = "/shaders.properties";
  const auto host = checkedHost(input.pack);
  const auto text = host ? input.pack.source->read(kPropertiesPath) : std::nullopt;
  if (!text) return;
  Diagnostics reported;
  const std::string active =
      preprocessProperties(kPropertiesPath, *text, input.pack.propertyMacros, reported);
  NewWords words(*host, diagnostics);
  for (const PropertyEntry& entry :
       parseProperties(kPropertiesPath, active, Continuation::Preprocessed, *text))
    words.check(entry);
}

}  // namespace orris
