#include <orris/validate/edited_check.h>

#include <algorithm>

#include <orris/pack/programs/folder_build.h>
#include <orris/pack/rebuild.h>
#include <orris/validate/pack_outline.h>

namespace orris {
namespace {

constexpr std::size_t kMostEdited = 8;  // programs

/// Programs that an edit reaches, of each name one: those of other dimensions are mostly alike.
class EditedPrograms {
 public:
  EditedPrograms(const IncludeGraph& graph, const std::set<std::string>& changed)
      : graph_(graph), changed_(changed) {}

  /// Is it one of the first?
  bool take(const ProgramEntry& entry) {
    if (full() || names_.contains(entry.name.program) || !reached(entry)) return false;
    names_.insert(entry.name.program);
    for (const auto& [stage, file] : entry.stages) stages_.insert(file);
    for (const auto& [name, file] : entry.computes) stages_.insert(file);
    stages_.erase("");  // the host's own vertex shader
    return true;
  }
  bool full() const { return names_.size() >= kMostEdited; }
  const std::set<std::string>& stages() const { return stages_; }

 private:
  bool reached(const ProgramEntry& entry) const {
    const auto reads = [&](const auto& named) {
      return std::ranges::any_of(reachableFiles(graph_, named.second),
                                 [&](const std::string& file) { return changed_.contains(file); });
    };
    return std::ranges::any_of(entry.stages, reads) || std::ranges::any_of(entry.computes, reads);
  }

  const IncludeGraph& graph_;
  const std::set<std::string>& changed_;
  std::set<std::string> names_, stages_;
};

}  // namespace

std::set<std::string> compileEdited(const std::shared_ptr<const FileSource>& files,
                                    const std::set<std::string>& changed,
                                    const ValidateOptions& options, Checker& checker,
                                    ProblemList& problems) {
  const HostVersions newest = options.versions ? options.versions->newest : HostVersions();
  checker.outline = readOutline(newest, options, checker, files);
  if (!checker.outline->pack) return {};
  const ShaderPack& pack = *checker.outline->pack;
  EditedPrograms edited(pack.builds.front()->files().graph, changed);
  LoadRequest request = checker.outline->request;
  request.buildModPrograms = false;
  for (const std::string& dimension : pack.dimensions) {
    if (edited.full()) break;
    request.dimension = dimension;
    Diagnostics diagnostics;
    const auto folder = rebuildShaderPack(
        pack, request, {.wanted = [&](const ProgramEntry& entry) { return edited.take(entry); }},
        diagnostics);
    if (folder) checkWithGlslang(*folder, checker.jobs, checker.glslang, diagnostics, checker.quiet);
    problems.add(diagnostics);
  }
  return edited.stages();
}

}  // namespace orris
