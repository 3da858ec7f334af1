#include <orris/pack/files/pack_files.h>

#include <algorithm>

#include <orris/core/files/text_file.h>
#include <orris/pack/files/properties_text.h>
#include <orris/pack/mods/voxy.h>
#include <orris/pack/options/language.h>
#include <orris/pack/programs/program_id.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/properties/property_limits.h>

namespace orris {
namespace {

std::vector<std::string> programFiles(const FileSource& source, const Dimensions& dimensions) {
  std::vector<std::string> entries;
  const auto& folders = dimensions.folders;
  for (const std::string& path : source.files()) {
    const auto program = parseProgramFile(path);
    if (program && std::find(folders.begin(), folders.end(), program->folder) != folders.end()) {
      entries.push_back(path);
    }
  }
  return entries;
}

/// Iris reads no file that only the programs of mods of their own use.
bool makesOptions(const std::string& entry) {
  const auto program = parseProgramFile(entry);
  return program && program->group != ProgramGroup::Colorwheel &&
         program->group != ProgramGroup::Voxy;
}

OptionSet optionsOf(const PackFiles& files, Diagnostics& diagnostics) {
  std::map<std::string, FileLines> own, others;
  for (const std::string& entry : files.entries) {
    if (!makesOptions(entry) || own.contains(entry)) continue;
    for (const std::string& file : reachableFiles(files.graph, entry)) {
      const auto known = files.graph.files.find(file);
      if (known != files.graph.files.end()) own.insert(*known);
    }
  }
  for (const auto& file : files.graph.files) {
    if (!own.contains(file.first)) others.insert(file);
  }
  OptionSet options = discoverOptions(own, diagnostics);
  addModFiles(others, options);
  return options;
}

// Profiles do not depend on option values, so they can be read before the values are known; their
// problems are reported when the whole file is read.
std::vector<Profile> profilesOf(const PackFiles& files) {
  ShaderProperties early;
  Diagnostics ignored;
  auto entries = lastValues(
      parseProperties(kPropertiesFile, files.properties.value_or(""), Continuation::Java));
  limitProperties(entries, ignored);
  readProfiles(entries, early, files.options, ignored);
  return early.profiles;
}

Diagnostic noPrograms(const FileSource& source) {
  Diagnostic d{.severity = Severity::Error,
               .id = "no-programs",
               .at = {.file = "/"},
               .message = "the pack has no program that this host knows",
               .hint = "program files are named like composite.fsh, in shaders/ or shaders/world0/"};
  for (const char* script : {"/pack.ts", "/pack.js"}) {
    if (!source.contains(script)) continue;
    d.at.file = script;
    d.message = "this is a pack for Aperture, a newer pipeline that a script sets up; this host reads "
                "packs for Iris, of program files like composite.fsh";
    d.hint = "give the pack's version for Iris, if it has one";
    break;
  }
  return d;
}

}  // namespace

std::shared_ptr<const PackFiles> readPackFiles(std::shared_ptr<const FileSource> source,
                                               const MacroDefinitions& environment,
                                               Diagnostics& diagnostics) {
  auto files = std::make_shared<PackFiles>();
  Diagnostics found;
  files->dimensions = readDimensions(*source, environment, found);
  files->entries = programFiles(*source, files->dimensions);
  if (files->entries.empty()) {
    found.push_back(noPrograms(*source));
  }
  std::vector<std::string> roots = files->entries;
  if (!roots.empty()) {
    std::copy_if(source->files().begin(), source->files().end(), std::back_inserter(roots),
                 isVoxyFile);
  }
  files->graph = readIncludeGraph(*source, roots, found);
  files->complete = !hasErrors(found);
  for (const auto& [file, includes] : files->graph.includes) {
    for (const auto& [line, target] : includes) {
      if (target.empty()) files->broken.insert(file);
    }
  }
  files->options = optionsOf(*files, found);
  for (const auto& [name, option] : files->options.all()) files->optionNames.push_back(name);
  files->properties = readText(*source, kPropertiesFile, found);
  files->profiles = profilesOf(*files);
  files->languages = readLanguages(*source, found);
  files->source = std::move(source);
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  return files;
}

}  // namespace orris
