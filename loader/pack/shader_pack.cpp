#include "pack/shader_pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "pack/chosen_values.h"
#include "pack/dimensions.h"
#include "pack/features.h"
#include "pack/include_graph.h"
#include "pack/language.h"
#include "pack/mods.h"
#include "pack/program_builder.h"
#include "pack/properties_text.h"
#include "pack/property_keys.h"
#include "pack/resource_check.h"
#include "pack/text.h"

namespace orris {
namespace {

constexpr const char* kPropertiesFile = "/shaders.properties";

/// Loads one pack step by step; each step returns false when the pack cannot run.
class Loader {
 public:
  Loader(std::shared_ptr<const FileSource> source, const LoadRequest& request,
         Diagnostics& diagnostics)
      : request_(request), diagnostics_(diagnostics) {
    pack_.name = request.name;
    pack_.source = std::move(source);
  }

  std::optional<ShaderPack> load() {
    if (!readFiles() || !readOptions() || !readProperties()) return std::nullopt;
    pack_.files = applyOptions(graph_.files, pack_.options, pack_.values);
    readIds();
    pack_.languages = readLanguages(*pack_.source);
    if (request_.buildSources) buildSources();
    return std::move(pack_);
  }

 private:
  bool failedSince(size_t count) const {
    return std::any_of(diagnostics_.begin() + static_cast<std::ptrdiff_t>(count),
                       diagnostics_.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
  }

  bool readFiles() {
    const size_t before = diagnostics_.size();
    dimensions_ = readDimensions(*pack_.source, request_.environment, diagnostics_);
    pack_.dimensions = dimensions_.folders;
    pack_.folder = dimensions_.resolve(request_.dimension);
    for (const std::string& path : pack_.source->files()) {
      const auto program = parseProgramFile(path);
      const auto& folders = dimensions_.folders;
      if (program && std::find(folders.begin(), folders.end(), program->folder) != folders.end()) {
        entries_.push_back(path);
      }
    }
    if (entries_.empty()) {
      diagnostics_.push_back(
          {.severity = Severity::Error,
           .id = "no-programs",
           .at = {.file = "/"},
           .message = "the pack has no program that this host knows",
           .hint = "program files are named like composite.fsh, in shaders/ or shaders/world0/"});
    }
    graph_ = readIncludeGraph(*pack_.source, entries_, diagnostics_);
    return !failedSince(before);
  }

  bool readOptions() {
    const size_t before = diagnostics_.size();
    pack_.options = discoverOptions(graph_.files, diagnostics_);
    propertiesText_ = pack_.source->read(kPropertiesFile);
    // Profiles do not depend on option values, so they can be read before the values are known;
    // their problems are reported when the whole file is read.
    ShaderProperties early;
    Diagnostics ignored;
    const auto entries = lastValues(
        parseProperties(kPropertiesFile, propertiesText_.value_or(""), Continuation::Java));
    readProfiles(entries, early, pack_.options, ignored);
    pack_.values = chooseValues(request_, pack_.options, early.profiles, diagnostics_);
    return !failedSince(before);
  }

  bool readProperties() {
    const size_t before = diagnostics_.size();
    if (propertiesText_) {
      pack_.properties = parseShaderProperties(kPropertiesFile, *propertiesText_, propertyMacros(),
                                               pack_.options, diagnostics_);
      checkDeclared(pack_.properties, diagnostics_);
      checkResources(pack_.properties, *pack_.source, diagnostics_);
    }
    shaderMacros_ = request_.environment;
    for (auto& macro : shaderFeatureMacros(pack_.properties))
      shaderMacros_.push_back(std::move(macro));
    return !failedSince(before);
  }

  /// Environment, features and options as *.properties files see them: no macro is empty there.
  MacroDefinitions propertyMacros() const {
    MacroDefinitions macros;
    for (const auto& [name, option] : pack_.options.all()) {
      const std::string value = pack_.options.value(pack_.values, name);
      if (!option.isBoolean || value == "true")
        macros.emplace_back(name, option.isBoolean ? "1" : value);
    }
    for (const MacroDefinitions& more : {request_.environment, propertyFeatureMacros()}) {
      for (const auto& [name, body] : more) macros.emplace_back(name, body.empty() ? "1" : body);
    }
    return macros;
  }

  void readIds() {
    const MacroDefinitions macros = propertyMacros();
    const auto read = [&](const std::string& file, auto parse) {
      const auto text = pack_.source->read(file);
      if (text) parse(file, preprocessProperties(file, *text, macros, diagnostics_), *text);
    };
    read("/block.properties", [&](auto& file, const auto& text, auto& original) {
      pack_.blockIds = parseBlockProperties(file, text, original, diagnostics_);
    });
    read("/item.properties", [&](auto& file, const auto& text, auto& original) {
      pack_.itemIds = parseIdProperties(file, text, original, "item.", diagnostics_);
    });
    read("/entity.properties", [&](auto& file, const auto& text, auto& original) {
      pack_.entityIds = parseIdProperties(file, text, original, "entity.", diagnostics_);
    });
  }

  bool isEnabled(const std::string& program, const ShaderProperties& properties) const {
    const auto found = properties.programEnabled.find(program);
    if (found != properties.programEnabled.end() && !found->second) return false;
    const Profile* profile = detectProfile(pack_.properties.profiles, pack_.options, pack_.values);
    return !profile || std::find(profile->disabledPrograms.begin(), profile->disabledPrograms.end(),
                                 program) == profile->disabledPrograms.end();
  }

  void buildSources() {
    const Mentions mentions = findMentions(pack_.files, pack_.options);
    const auto enabled = [this](const std::string& name) {
      if (isEnabled(name, pack_.properties)) return true;
      auto& disabled = pack_.disabledPrograms;
      if (std::find(disabled.begin(), disabled.end(), name) == disabled.end())
        disabled.push_back(name);
      return false;
    };
    auto programs = list(enabled);
    std::erase_if(programs, [](const ProgramEntry& p) { return modFamilyOf(p.name.group); });
    auto built =
        buildPrograms(programs, {graph_, pack_.files, pack_.properties, shaderMacros_, mentions});
    readDirectives(built);
    take(built, pack_.programs);
    if (request_.buildModPrograms) {
      for (const ModFamily& family : modFamilies()) buildModPrograms(family, mentions);
    }
    removeDuplicates(diagnostics_);
  }

  std::vector<ProgramEntry> list(const std::function<bool(const std::string&)>& enabled) const {
    const bool tessellation = pack_.properties.feature("TESSELLATION_SHADERS") ||
                              pack_.properties.feature("TESSELATION_SHADERS");
    return listPrograms(entries_, pack_.folder, tessellation, enabled);
  }

  void take(std::vector<BuiltProgram>& built, std::vector<ProgramSource>& programs) {
    for (BuiltProgram& program : built) {
      diagnostics_.insert(diagnostics_.end(), program.diagnostics.begin(),
                          program.diagnostics.end());
      programs.push_back(std::move(program.source));
    }
  }

  /// Packs ask for the mod in shaders.properties too, often to enable its programs.
  void buildModPrograms(const ModFamily& family, const Mentions& mentions) {
    const auto isOther = [&](const ProgramEntry& p) { return p.name.group != family.group; };
    auto programs = list([](const std::string&) { return true; });
    std::erase_if(programs, isOther);
    if (programs.empty()) return;
    MacroDefinitions macros = propertyMacros();
    macros.emplace_back(family.macro, "1");
    Diagnostics ignored;  // what is wrong with the file was told when it was read
    const ShaderProperties properties = parseShaderProperties(
        kPropertiesFile, propertiesText_.value_or(""), macros, pack_.options, ignored);
    programs = list([&](const std::string& name) { return isEnabled(name, properties); });
    std::erase_if(programs, isOther);
    macros = shaderMacros_;
    macros.emplace_back(family.macro, "");
    auto built =
        buildPrograms(programs, {graph_, pack_.files, properties, macros, mentions, family.names});
    for (BuiltProgram& program : built) markAsOfMod(family.name, program.diagnostics);
    take(built, pack_.modPrograms);
  }

  /// Contract: constants.csv "(precedence)"; the last directive wins.
  void readDirectives(std::vector<BuiltProgram>& built) {
    std::vector<std::pair<int, BuiltProgram*>> order;
    for (BuiltProgram& program : built) order.emplace_back(scanRank(program.source), &program);
    std::stable_sort(order.begin(), order.end(),
                     [](auto& a, auto& b) { return a.first < b.first; });
    for (const auto& [rank, program] : order) {
      readPackDirectives(program->constLines, program->sites, pack_.directives, diagnostics_);
    }
  }

  static int scanRank(const ProgramSource& program) {
    constexpr ProgramGroup kFirst[] = {ProgramGroup::ShadowComp, ProgramGroup::Begin,
                                       ProgramGroup::Prepare};
    constexpr int kGeometry = 3, kAfterGeometry = 1000;
    const auto early = std::find(std::begin(kFirst), std::end(kFirst), program.group);
    if (early != std::end(kFirst)) return static_cast<int>(early - std::begin(kFirst));
    if (program.group == ProgramGroup::Deferred) return kAfterGeometry + 1;
    if (program.group == ProgramGroup::Composite) return kAfterGeometry + 2;
    const auto& geometry = geometryPrograms();
    const auto found = std::find_if(geometry.begin(), geometry.end(),
                                    [&](auto& g) { return g.name == program.name; });
    return found == geometry.end() ? kAfterGeometry
                                   : kGeometry + static_cast<int>(found - geometry.begin());
  }

  const LoadRequest& request_;
  Diagnostics& diagnostics_;
  ShaderPack pack_;
  Dimensions dimensions_;
  std::vector<std::string> entries_;
  IncludeGraph graph_;
  std::optional<std::string> propertiesText_;
  MacroDefinitions shaderMacros_;
};

}  // namespace

const ProgramSource* ShaderPack::find(std::string_view program) const {
  const auto found =
      std::find_if(programs.begin(), programs.end(), [&](auto& p) { return p.name == program; });
  return found == programs.end() ? nullptr : &*found;
}

const ProgramSource* ShaderPack::resolve(std::string_view program) const {
  for (; !program.empty(); program = fallbackOf(program)) {
    const ProgramSource* found = find(program);
    // A program of compute shaders only draws nothing.
    if (found && !found->stages.empty()) return found;
  }
  return nullptr;
}

std::string ShaderPack::sourceLine(const std::string& file, int line) const {
  if (line < 1) return "";
  const size_t index = static_cast<size_t>(line) - 1;
  const auto known = files.find(file);
  if (known != files.end()) return index < known->second.size() ? known->second[index] : "";
  const auto text = source ? source->read(file) : std::nullopt;
  const FileLines lines = splitLines(text.value_or(""));
  return index < lines.size() ? lines[index] : "";
}

std::string ShaderPack::currentProfile() const {
  const Profile* profile = detectProfile(properties.profiles, options, values);
  return profile ? profile->name : "";
}

std::optional<ShaderPack> loadShaderPack(std::shared_ptr<const FileSource> source,
                                         const LoadRequest& request, Diagnostics& diagnostics) {
  return Loader(std::move(source), request, diagnostics).load();
}

}  // namespace orris
