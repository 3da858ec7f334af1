#include "app/commands/explain.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>

#include "app/input/inputs.h"
#include "check/logs/log_explainer.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> readLog(const std::string& path, Report& report, int& status) {
  if (path != "-") return readWholeFile(path, report, status);
  return std::string(std::istreambuf_iterator<char>(std::cin), {});
}

/// The files of Iris's folder, by name.
std::optional<std::vector<PatchedShader>> readPatched(const std::string& folder, Report& report,
                                                      int& status) {
  std::vector<PatchedShader> files;
  if (folder.empty()) return files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (!it->is_regular_file(error)) continue;
    const auto text = readWholeFileBelow(folder, it->path().filename(), report, status);
    if (text) files.push_back({it->path().filename(), *text});
  }
  if (error) {
    report.error("file-unreadable", "cannot be read", "name Iris's folder patched_shaders", folder);
    status = kUsage;
    return std::nullopt;
  }
  std::ranges::sort(files, {}, &PatchedShader::file);
  return files;
}

}  // namespace

PackVerdict explainGameLog(const std::string& packPath, const ValidateOptions& options,
                           Report& report) {
  PackVerdict verdict{.path = packPath};
  const auto log = readLog(options.explainLog, report, verdict.status);
  auto patched = readPatched(options.patchedShaders, report, verdict.status);
  if (!log || !patched) return verdict;
  verdict.files = openPackFiles(packPath, report, verdict.status);
  if (!verdict.files) return verdict;
  const HostVersions versions = options.versions ? options.versions->newest : HostVersions();
  const MacroDefinitions environment = standardMacros({.versions = versions});
  auto request = makeLoadRequest(verdict.files, options.pack, environment, report, verdict.status);
  if (!request) return verdict;
  request->buildModPrograms = true;
  Diagnostics diagnostics;
  const auto pack = loadShaderPack(verdict.files, *request, diagnostics);
  if (!pack) {
    verdict.status = loadFailureStatus(verdict.files, *request);
  } else {
    // What is wrong with the pack by itself is for a run without a log.
    diagnostics = explainLog({.pack = *pack,
                              .logName = options.explainLog == "-" ? "log" : options.explainLog,
                              .sections = parseGameLog(*log),
                              .patched = std::move(*patched),
                              .stage = options.stage});
  }
  report.add(diagnostics);
  return verdict;
}

}  // namespace orris
