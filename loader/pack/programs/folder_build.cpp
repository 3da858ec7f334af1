#include <orris/pack/programs/folder_build.h>

#include <algorithm>

#include <orris/pack/expressions/expression_functions.h>
#include <orris/pack/files/extended_graph.h>
#include <orris/pack/mods/voxy.h>
#include <orris/pack/options/chosen_values.h>

namespace orris {
namespace {

class SourceHash {
 public:
  void add(std::string_view text) { add(std::hash<std::string_view>()(text)); }
  void add(std::uint64_t value) { hash_ = (hash_ ^ value) * 0x9e3779b97f4a7c15u + (hash_ >> 29); }

  void add(const FlatSource& source) {
    for (const IncludeSite& site : source.sites) {
      add(site.file);
      add(std::uint64_t(site.parent));
      add(std::uint64_t(site.parentLine));
    }
    for (const FlatLine& line : source.lines) {
      add(line.text);
      add(std::uint64_t(line.site));
      add(std::uint64_t(line.line));
    }
  }

  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0;
};

/// Did the text of the program meet a limit? Whatever is missing then is no mistake of its own.
bool isCutOff(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& d) {
    return d.id == "source-too-large" || d.id == "struct-too-large" ||
           d.id == "stage-too-large" || d.id == "macro-expansion-limit";
  });
}

}  // namespace

FolderBuild::FolderBuild(std::shared_ptr<const PackFiles> files, std::string folder,
                         OptionValues values, const MacroDefinitions& environment, bool irisTexts,
                         const FolderBuild* similar, const std::set<std::string>& live)
    : files_(std::move(files)),
      folder_(std::move(folder)),
      values_(std::move(values)),
      textValues_(values_),
      live_(liveUniforms(files_->options, live)),
      irisTexts_(irisTexts) {
  for (const LiveUniform& one : live_) textValues_[one.option] = one.name;
  readProperties(environment, similar);
  edited_ = editedFiles(files_->graph.files, files_->options, textValues_);
  listAll();
}

FolderBuild::FolderBuild(const FolderBuild& host, const ModFamily& mod,
                         const MacroDefinitions& environment,
                         const std::map<std::string, std::string>& uniformTypes,
                         const FolderBuild* similar)
    : files_(host.files_),
      folder_(host.folder_),
      values_(host.values_),
      textValues_(host.textValues_),
      live_(host.live_),
      irisTexts_(host.irisTexts_),
      mod_(&mod),
      edited_(host.edited_) {
  // Packs ask for the mod in shaders.properties too, often to enable its programs.
  const auto asks = [&](const std::string& macro) { return macro == mod.macro; };
  if (std::ranges::any_of(host.properties().modMacros, asks)) {
    MacroDefinitions macros = environment;
    macros.emplace_back(mod.macro, mod.value);
    readProperties(macros, similar);
  } else {
    properties_ = std::make_shared<const PackProperties>(withMacro(host.properties(), mod.macro, mod.value));
  }
  if (mod.group == ProgramGroup::Voxy) {
    listVoxy(uniformTypes);
  } else {
    listAll();
  }
}

// What cannot be judged is not listed.
void FolderBuild::listVoxy(const std::map<std::string, std::string>& uniformTypes) {
  const std::string prefix = folder_ == "/" ? folder_ : folder_ + "/";
  const std::string interfaceFile = prefix + std::string(kVoxyInterfaceFile);
  if (!lines(interfaceFile)) return;
  const FileLookup lookup = [this](const std::string& file) { return lines(file); };
  Diagnostics ignored;  // the file is no shader
  const TokenStream interface = preprocess(flatten(files_->graph, lookup, interfaceFile, ignored),
                                           properties_->shaderMacros, ignored);
  const auto prelude = voxyPrelude(readVoxyInterface(interface), [&](const std::string& uniform) {
    for (const CustomUniform& own : properties_->shader.customUniforms) {
      if (own.name != uniform) continue;
      return own.type == ValueType::Bool ? "int" : std::string(typeName(own.type));
    }
    const auto known = uniformTypes.find(uniform);
    return known == uniformTypes.end() ? "" : known->second;
  });
  if (!prelude) return;
  voxyPrelude_ = *prelude;
  for (const std::string_view name : kVoxyPrograms) {
    const std::string file = prefix + std::string(name) + ".glsl";
    if (!lines(file)) continue;
    programs_.push_back(
        {.name = {.folder = folder_, .program = std::string(name), .group = ProgramGroup::Voxy},
         .stages = {{Stage::Vertex, ""}, {Stage::Fragment, file}}});
  }
}

BuildContext FolderBuild::context(const IncludeGraph& graph, const FileLookup& lookup) const {
  return {graph,
          lookup,
          properties_->shader,
          properties_->shaderMacros,
          files_->optionNames,
          mod_ ? mod_->names : std::span<const HostName>(),
          voxyPrelude_,
          irisTexts_,
          live_};
}

void FolderBuild::readProperties(const MacroDefinitions& environment, const FolderBuild* similar) {
  const bool same =
      similar && similar->files_ == files_ &&
      !haveCommonName(differingOptions(files_->options, values_, similar->values_),
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

const ProgramEntry* FolderBuild::entryNamed(std::string_view program) const {
  const auto found = std::find_if(programs_.begin(), programs_.end(),
                                  [&](auto& entry) { return entry.name.program == program; });
  return found == programs_.end() ? nullptr : &*found;
}

ProgramSource FolderBuild::build(const ProgramEntry& entry) const {
  std::vector<PreprocessedPart> parts;
  for (std::size_t i = 0; i < partCount(entry); ++i) parts.push_back(buildPart(entry, i));
  return finish(entry, std::move(parts));
}

ProgramSource FolderBuild::buildWith(const ProgramEntry& entry, const AddedLine& added) const {
  const ExtendedGraph with(*this, added);
  if (!with.changed()) return build(entry);
  const FileLookup lookup = [&](const std::string& file) { return with.lines(file); };
  BuildContext here = context(with.graph(), lookup);
  here.judgedOnly = true;
  std::vector<PreprocessedPart> parts;
  for (std::size_t i = 0; i < partCount(entry); ++i)
    parts.push_back(preprocessPart(entry, i, here));
  return finishProgram(entry, here, std::move(parts));
}

std::optional<std::uint64_t> FolderBuild::hashWith(const ProgramEntry& entry,
                                                   const AddedLine& added) const {
  const ExtendedGraph with(*this, added);
  if (!with.changed()) return std::nullopt;
  SourceHash hash;
  hash.add(folder_);
  hash.add(mod_ ? mod_->name : "");
  hash.add(voxyPrelude_);
  hash.add(irisTexts_);
  for (const auto& [name, value] : properties_->shaderMacros) {
    hash.add(name);
    hash.add(value);
  }
  for (const LiveUniform& live : live_) {
    hash.add(live.name);
    hash.add(live.declaration);
  }
  hash.add(entry.name.program);
  hash.add(std::uint64_t(entry.name.group));
  const FileLookup lookup = [&](const std::string& file) { return with.lines(file); };
  const auto addFile = [&](const std::string& file) {
    Diagnostics limits;
    if (!file.empty()) hash.add(flatten(with.graph(), lookup, file, limits));
    for (const Diagnostic& limit : limits) hash.add(limit.message);
  };
  for (const auto& [stage, file] : entry.stages) {
    hash.add(std::uint64_t(stage));
    addFile(file);
  }
  for (const auto& [name, file] : entry.computes) {
    hash.add(name);
    addFile(file);
  }
  return hash.value();
}

PreprocessedPart FolderBuild::buildPart(const ProgramEntry& entry, std::size_t part) const {
  const FileLookup lookup = [this](const std::string& file) { return lines(file); };
  return preprocessPart(entry, part, context(lookup));
}

ProgramSource FolderBuild::finish(const ProgramEntry& entry,
                                  std::vector<PreprocessedPart> parts) const {
  const FileLookup lookup = [this](const std::string& file) { return lines(file); };
  ProgramSource program = finishProgram(entry, context(lookup), std::move(parts));
  if (mod_) markAsOfMod(mod_->name, program.diagnostics);
  program.incomplete =
      reachesAny(entry, files_->broken) || isCutOff(program.diagnostics);
  program.misnames = reachesAny(entry, files_->graph.misnaming);
  // The #version may be in the file that is missing.
  if (program.incomplete) {
    std::erase_if(program.diagnostics, [](const auto& d) { return d.id == "version-missing"; });
  }
  return program;
}

bool FolderBuild::reachesAny(const ProgramEntry& entry, const std::set<std::string>& wanted) const {
  if (wanted.empty()) return false;
  const auto reaches = [&](const auto& named) {
    const auto files = reachableFiles(files_->graph, named.second);
    return std::any_of(files.begin(), files.end(),
                       [&](const std::string& file) { return wanted.contains(file); });
  };
  return std::any_of(entry.stages.begin(), entry.stages.end(), reaches) ||
         std::any_of(entry.computes.begin(), entry.computes.end(), reaches);
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
