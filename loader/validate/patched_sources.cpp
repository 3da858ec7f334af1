#include <orris/validate/patched_sources.h>

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <set>

#include <orris/core/files/named_file.h>
#include <orris/core/files/read_file.h>

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
bool createFolder(const std::string& folder, const std::string& inside, Diagnostics& diagnostics) {
  // A folder that cannot be made shows when its first file is written.
  std::error_code error;
  std::filesystem::create_directories(inside, error);
  if (error || liesBelow(folder, inside)) return true;
  diagnostics.push_back({.id = "file-unwritable",
                         .at = {.file = inside},
                         .message = "leads out of the folder that --patched names",
                         .hint = "remove this link, or name another folder"});
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

bool makePatchedFolder(const std::string& folder, Diagnostics& diagnostics) {
  return folder.empty() || createFolder(folder, folder, diagnostics);
}

bool writePatched(const std::string& folder, const ShaderPack& pack, Diagnostics& diagnostics) {
  return createFolder(folder, folder, diagnostics) &&
         forEachStage(pack, [&](const std::string& name, const StageText& stage) {
    return writeNamedFile(pathOf(folder, name, stage), stage.text.text, diagnostics);
  });
}

bool writePatchedWithMap(const std::string& folder, const ShaderPack& pack, Diagnostics& diagnostics) {
  const std::string inside = pack.folder == "/" ? folder : folder + pack.folder;
  return createFolder(folder, inside, diagnostics) &&
         forEachStage(pack, [&](const std::string& name, const StageText& stage) {
    const std::string path = pathOf(inside, name, stage);
    return writeNamedFile(path, stage.text.text, diagnostics) &&
           writeNamedFile(path + ".map", mapOf(stage.text), diagnostics);
  });
}

}  // namespace orris
