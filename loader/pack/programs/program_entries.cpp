// Which programs a folder has.
#include <algorithm>
#include <map>
#include <tuple>

#include <orris/core/files/pack_path.h>
#include <orris/pack/programs/program_builder.h>

namespace orris {
namespace {

struct Files {
  ProgramFile name;
  std::map<Stage, std::string> stages;
  std::map<char, std::string> computes;  ///< by suffix, 0 for none
};

void addStages(const Files& files, bool tessellation, ProgramEntry& entry) {
  // A lone vertex shader draws nothing; a lone fragment shader gets the default vertex shader.
  if (!files.stages.contains(Stage::Fragment)) return;
  if (!files.stages.contains(Stage::Vertex)) entry.stages.emplace_back(Stage::Vertex, "");
  for (const auto& [stage, path] : files.stages) {
    const bool tess = stage == Stage::TessControl || stage == Stage::TessEvaluation;
    if (!tess || tessellation) entry.stages.emplace_back(stage, path);
  }
}

void addComputes(const Files& files, ProgramEntry& entry) {
  const auto add = [&](char suffix) {
    const auto found = files.computes.find(suffix);
    if (found == files.computes.end()) return false;
    const std::string name = files.name.program;
    entry.computes.emplace_back(suffix ? name + "_" + suffix : name, found->second);
    return true;
  };
  add(0);
  for (char suffix = 'a'; suffix <= 'z' && add(suffix);) ++suffix;
}

}  // namespace

std::vector<ProgramEntry> listPrograms(const std::vector<std::string>& paths,
                                       const std::string& folder, bool tessellation,
                                       const std::function<bool(const std::string&)>& isEnabled) {
  using Key = std::tuple<ProgramGroup, int, std::string>;
  std::map<Key, Files> programs;
  for (const std::string& path : paths) {
    const auto file = parseProgramFile(path);
    if (!file || file->folder != folder) continue;
    if (!isEnabled(path.substr(1, path.rfind('.') - 1))) continue;
    Files& files = programs[{file->group, file->index, file->program}];
    files.name = *file;
    if (file->stage == Stage::Compute) {
      files.computes[file->computeSuffix] = path;
    } else {
      files.stages[file->stage] = path;
    }
  }
  std::vector<ProgramEntry> entries;
  for (const auto& [key, files] : programs) {
    ProgramEntry entry{.name = files.name};
    addStages(files, tessellation, entry);
    addComputes(files, entry);
    if (!entry.stages.empty() || !entry.computes.empty()) entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace orris
