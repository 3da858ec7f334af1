#include "app/validate/patched_sources.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <set>

#include "app/input/inputs.h"
#include "core/read_file.h"

namespace orris {
namespace {

using WriteStage = std::function<bool(const std::string& name, const StageText& stage)>;

bool forEachStage(const ShaderPack& pack, const WriteStage& write) {
  for (const ProgramSource& program : pack.programs) {
    for (const StageText& stage : program.stages)
      if (!write(program.name, stage)) return false;
    for (const ComputeSource& compute : program.computes)
      if (!write(compute.name, compute.text)) return false;
  }
  return true;
}

/// `inside` is `folder` or a folder of it; what is there may be no link to elsewhere.
bool createFolder(const std::string& folder, const std::string& inside, Report& report,
                  int& status) {
  // A folder that cannot be made shows when its first file is written.
  std::error_code error;
  std::filesystem::create_directories(inside, error);
  if (error || liesBelow(folder, inside)) return true;
  report.error("file-unwritable", "leads out of the folder that --patched names",
               "remove this link, or name another folder", inside);
  status = kUsage;
  return false;
}

std::string pathOf(const std::string& folder, const std::string& name, const StageText& stage) {
  return fmt::format("{}/{}.{}", folder, name, stageExtension(stage.stage));
}

std::string mapOf(const MappedText& text) {
  std::string map;
  for (const auto& segments : text.lines) {
    std::set<std::string> places;
    const auto add = [&](const Origin& origin) {
      const SourceLocation at = locate(text.sites, origin);
      if (!at.file.empty()) places.insert(fmt::format("{}:{}", at.file, at.line));
    };
    for (const MappedText::Segment& segment : segments) {
      add(segment.origin);
      const auto macro = static_cast<size_t>(segment.macro);
      if (macro < text.macroOrigins.size()) add(text.macroOrigins[macro]);
    }
    map += fmt::format("{}\n", fmt::join(places, "\t"));
  }
  return map;
}

}  // namespace

bool makePatchedFolder(const std::string& folder, Report& report, int& status) {
  return folder.empty() || createFolder(folder, folder, report, status);
}

bool writePatched(const std::string& folder, const ShaderPack& pack, Report& report, int& status) {
  return createFolder(folder, folder, report, status) &&
         forEachStage(pack, [&](const std::string& name, const StageText& stage) {
    return writeWholeFile(pathOf(folder, name, stage), stage.text.text, report, status);
  });
}

bool writePatchedWithMap(const std::string& folder, const ShaderPack& pack, Report& report,
                         int& status) {
  const std::string inside = pack.folder == "/" ? folder : folder + pack.folder;
  return createFolder(folder, inside, report, status) &&
         forEachStage(pack, [&](const std::string& name, const StageText& stage) {
    const std::string path = pathOf(inside, name, stage);
    return writeWholeFile(path, stage.text.text, report, status) &&
           writeWholeFile(path + ".map", mapOf(stage.text), report, status);
  });
}

}  // namespace orris
