#include "pack/folder_build.h"

#include <algorithm>

#include "pack/chosen_values.h"

namespace orris {

FolderBuild::FolderBuild(std::shared_ptr<const PackFiles> files, std::string folder,
                         OptionValues values, const MacroDefinitions& environment,
                         const FolderBuild* similar)
    : files_(std::move(files)), folder_(std::move(folder)), values_(std::move(values)) {
  readProperties(environment, similar);
  edited_ = editedFiles(files_->graph.files, files_->options, values_);
  listAll();
}

FolderBuild::FolderBuild(const FolderBuild& host, const ModFamily& mod,
                         const MacroDefinitions& environment, const FolderBuild* similar)
    : files_(host.files_),
      folder_(host.folder_),
      values_(host.values_),
      mod_(&mod),
      edited_(host.edited_) {
  // Packs ask for the mod in shaders.properties too, often to enable its programs.
  MacroDefinitions macros = environment;
  macros.emplace_back(mod.macro, "");
  readProperties(macros, similar);
  listAll();
}

void FolderBuild::readProperties(const MacroDefinitions& environment, const FolderBuild* similar) {
  const bool same =
      similar && !haveCommonName(differingOptions(files_->options, values_, similar->values_),
                                 similar->properties_->options);
  properties_ = same ? similar->properties_
                     : std::make_shared<const PackProperties>(
                           readPackProperties(*files_, values_, environment));
}

const FileLines* FolderBuild::lines(const std::string& file) const {
  const auto edited = edited_.find(file);
  if (edited != edited_.end()) return &edited->second;
  const auto known = files_->graph.files.find(file);
  return known == files_->graph.files.end() ? nullptr : &known->second;
}

ProgramSource FolderBuild::build(const ProgramEntry& entry) const {
  const FileLookup lookup = [this](const std::string& file) { return lines(file); };
  ProgramSource program =
      buildProgram(entry, {files_->graph, lookup, properties_->shader, properties_->shaderMacros,
                           files_->optionNames, mod_ ? mod_->names : std::span<const HostName>()});
  if (mod_) markAsOfMod(mod_->name, program.diagnostics);
  return program;
}

void FolderBuild::listAll() {
  const ShaderProperties& properties = properties_->shader;
  const bool tessellation =
      properties.feature("TESSELLATION_SHADERS") || properties.feature("TESSELATION_SHADERS");
  const Profile* profile = detectProfile(properties.profiles, files_->options, values_);
  programs_ =
      listPrograms(files_->entries, folder_, tessellation,
                   [this, profile](const std::string& name) { return isEnabled(name, profile); });
  std::erase_if(programs_,
                [this](const ProgramEntry& p) { return modFamilyOf(p.name.group) != mod_; });
}

bool FolderBuild::isEnabled(const std::string& program, const Profile* profile) {
  const auto& byName = properties_->shader.programEnabled;
  const auto found = byName.find(program);
  const auto disables = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), program) != names.end();
  };
  const bool enabled = found == byName.end() || found->second;
  if (enabled && !(profile && disables(profile->disabledPrograms))) return true;
  if (!disables(disabled_)) disabled_.push_back(program);
  return false;
}

std::vector<std::string> differingOptions(const OptionSet& options, const OptionValues& a,
                                          const OptionValues& b) {
  std::vector<std::string> names;
  for (const auto* values : {&a, &b}) {
    for (const auto& [name, value] : *values) {
      if (options.value(a, name) != options.value(b, name)) names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

bool haveCommonName(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& name) {
    return std::binary_search(b.begin(), b.end(), name);
  });
}

}  // namespace orris
