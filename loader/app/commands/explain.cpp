#include "app/commands/explain.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>

#include <orris/check/logs/log_explainer.h>
#include <orris/check/rules/rules.h>
#include <orris/core/files/named_file.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> readLog(const std::string& path, Diagnostics& diagnostics) {
  if (path != "-") return readNamedFile(path, diagnostics);
  return std::string(std::istreambuf_iterator<char>(std::cin), {});
}

/// The files of Iris's folder, by name.
std::optional<std::vector<PatchedShader>> readPatched(const std::string& folder,
                                                      Diagnostics& diagnostics) {
  std::vector<PatchedShader> files;
  if (folder.empty()) return files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (!it->is_regular_file(error)) continue;
    const auto text = readNamedFileBelow(folder, it->path().filename(), diagnostics);
    if (text) files.push_back({it->path().filename(), *text});
  }
  if (error) {
    diagnostics.push_back({.id = "file-unreadable",
                           .at = {.file = folder},
                           .message = "cannot be read",
                           .hint = "name Iris's folder patched_shaders"});
    return std::nullopt;
  }
  std::ranges::sort(files, {}, &PatchedShader::file);
  return files;
}

std::optional<ShaderPack> loadLogged(const std::shared_ptr<const FileSource>& files,
                                     const ValidateOptions& options, Diagnostics& diagnostics) {
  const HostVersions versions = options.versions ? options.versions->newest : HostVersions();
  const MacroDefinitions environment = standardMacros({.versions = versions});
  auto request = makeLoadRequest(files, options.pack, environment, diagnostics);
  if (!request) return std::nullopt;
  request->buildModPrograms = true;
  return loadShaderPack(files, *request, diagnostics);
}

}  // namespace

PackVerdict explainGameLog(const std::string& packPath, const ValidateFlags& flags,
                           ProblemList& problems) {
  PackVerdict verdict{.path = packPath};
  Diagnostics diagnostics;
  const auto log = readLog(flags.explainLog, diagnostics);
  auto patched = readPatched(flags.patchedShaders, diagnostics);
  if (log && patched) verdict.files = openPack(packPath, diagnostics);
  verdict.status = statusOf(diagnostics);
  problems.add(diagnostics);
  if (!verdict.files) return verdict;
  const auto pack = loadLogged(verdict.files, flags.validate, diagnostics);
  if (!pack) {
    verdict.status = statusOf(diagnostics);
  } else {
    // What is wrong with the pack by itself is for a run without a log.
    diagnostics = explainLog({.pack = *pack,
                              .logName = flags.explainLog == "-" ? "log" : flags.explainLog,
                              .sections = parseGameLog(*log),
                              .patched = std::move(*patched),
                              .stage = flags.stage});
  }
  problems.add(diagnostics);
  return verdict;
}

}  // namespace orris
