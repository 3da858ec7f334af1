#include <orris/pack/shader_pack.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include <orris/core/files/text_file.h>
#include <orris/core/work_stage.h>
#include <orris/pack/files/text.h>
#include <orris/pack/options/chosen_values.h>
#include <orris/pack/programs/folder_build.h>
#include <orris/pack/programs/program_reuse.h>
#include <orris/pack/rebuild.h>
#include <orris/pack/versions/features.h>

namespace orris {
namespace {

/// What splitLines() has at `index`, "" when it has less: thousands of messages may name one file.
std::string lineOf(std::string_view text, size_t index) {
  for (; index > 0 && !text.empty(); --index) {
    const size_t end = text.find_first_of("\r\n");
    if (end == text.npos) return "";
    text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
  }
  std::string line(text.substr(0, text.find_first_of("\r\n")));
  std::erase(line, '\0');
  return line;
}

int scanRank(const ProgramSource& program) {
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

void append(const Diagnostics& found, Diagnostics& diagnostics) {
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
}

/// Contract: constants.csv "(precedence)"; the last directive wins.
void readDirectives(ShaderPack& pack, Diagnostics& diagnostics) {
  std::vector<const ProgramSource*> order;
  for (const ProgramSource& program : pack.programs) order.push_back(&program);
  std::stable_sort(order.begin(), order.end(),
                   [](auto* a, auto* b) { return scanRank(*a) < scanRank(*b); });
  Diagnostics found;
  for (const ProgramSource* program : order) {
    readPackDirectives(program->constLines, program->constSites, pack.directives, found);
  }
  pack.refused = refusesPack(found);
  append(found, diagnostics);
}

/// All that `reusable` does not give, on two threads; the result does not depend on which thread did
/// what. Returns how many were built.
int buildAll(const FolderBuild& build, const ProgramReuse& reusable, const RebuildScope& scope,
             ProgramList& programs) {
  std::vector<ProgramList::Pointer> built;
  std::vector<std::pair<size_t, const ProgramEntry*>> missing;
  for (const ProgramEntry& entry : build.programs()) {
    if (scope.wanted && !scope.wanted(entry)) continue;
    built.push_back(reusable(entry));
    if (!built.back()) missing.emplace_back(built.size() - 1, &entry);
  }
  std::atomic<size_t> next = 0;
  const auto work = [&] {
    for (size_t i = next++; i < missing.size(); i = next++) {
      const ProgramEntry& entry = *missing[i].second;
      const WorkStage stage("reading the program", entry.name.program);
      built[missing[i].first] = std::make_shared<const ProgramSource>(build.build(entry));
    }
  };
  std::exception_ptr failure;  // an exception that leaves a thread would end the process
  {
    std::jthread second;
    if (missing.size() > 1)
      second = std::jthread([&] {
        try {
          work();
        } catch (...) {
          failure = std::current_exception();
        }
      });
    work();
  }
  if (failure) std::rethrow_exception(failure);
  for (ProgramList::Pointer& program : built) programs.push_back(std::move(program));
  return static_cast<int>(missing.size());
}

ShaderPack emptyPack(const PackFiles& files, const LoadRequest& request, const FolderBuild& build) {
  const PackProperties& properties = build.properties();
  ShaderPack pack{.name = request.name,
                  .options = files.options,
                  .values = build.values(),
                  .properties = properties.shader,
                  .blockIds = properties.blockIds,
                  .itemIds = properties.itemIds,
                  .entityIds = properties.entityIds,
                  .languages = files.languages,
                  .folder = build.folder(),
                  .dimensions = files.dimensions.readFolders()};
  pack.hasItemFile = properties.hasItemFile;
  pack.disabledPrograms = build.disabled();
  pack.files = applyOptions(files.graph.files, files.options, build.textValues());
  pack.live = request.live;
  pack.propertyMacros = properties.macros;
  pack.source = files.source;
  return pack;
}

/// The build of the same programs that `previous` was made from.
const FolderBuild* buildOf(const ShaderPack* previous, const ModFamily* mod) {
  if (!previous) return nullptr;
  for (const auto& build : previous->builds) {
    if (build->mod() == mod) return build.get();
  }
  return nullptr;
}

int buildSources(const LoadRequest& request, const RebuildScope& scope, ShaderPack& pack,
                 Diagnostics& diagnostics) {
  static const ProgramList kNone;
  const FolderBuild& host = *pack.builds.front();
  const ShaderPack* earlier = scope.earlier;
  const ProgramReuse reuse(buildOf(earlier, nullptr), earlier ? earlier->programs : kNone, host);
  int built = buildAll(host, reuse, scope, pack.programs);
  readDirectives(pack, diagnostics);
  checkShadowColors(pack.programs, pack.properties, diagnostics);
  for (const ModFamily& mod : modFamilies()) {
    if (!request.buildModPrograms) break;
    const FolderBuild* old = buildOf(earlier, &mod);
    const auto build = std::make_shared<const FolderBuild>(host, mod, request.environment,
                                                           request.uniformTypes, old);
    built += buildAll(*build, ProgramReuse(old, earlier ? earlier->modPrograms : kNone, *build),
                      scope, pack.modPrograms);
    pack.builds.push_back(build);
  }
  for (const ProgramList* programs : {&pack.programs, &pack.modPrograms}) {
    for (const ProgramSource& program : *programs) append(program.diagnostics, diagnostics);
  }
  return built;
}

/// `outline`, of the same files, lends its properties.
std::optional<ShaderPack> buildPack(const std::shared_ptr<const PackFiles>& files,
                                    const LoadRequest& request, const ShaderPack* outline,
                                    const RebuildScope& scope, Diagnostics& diagnostics, int* built) {
  Diagnostics chosen;
  const OptionValues values = chooseValues(request, files->options, files->profiles, chosen);
  append(chosen, diagnostics);
  if (hasErrors(chosen)) return std::nullopt;
  const auto host = std::make_shared<const FolderBuild>(
      files, files->dimensions.resolve(request.dimension), values, request.environment,
      request.irisTexts, buildOf(outline, nullptr), request.live);
  append(host->properties().diagnostics, diagnostics);
  if (host->properties().refused && !request.keepGoing) return std::nullopt;
  ShaderPack pack = emptyPack(*files, request, *host);
  pack.builds.push_back(host);
  if (!request.buildSources) return pack;
  Diagnostics found;
  const int count = buildSources(request, scope, pack, found);
  if (built) *built = count;
  append(found, diagnostics);
  removeDuplicates(diagnostics);
  const bool refused = std::ranges::any_of(
      pack.programs, [](const ProgramSource& program) { return refusesPack(program.diagnostics); });
  if ((refused || pack.refused) && !request.keepGoing) return std::nullopt;
  return pack;
}

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
  const auto text = source ? readText(*source, file) : std::nullopt;
  return lineOf(text.value_or(""), index);
}

std::string ShaderPack::currentProfile() const {
  const Profile* profile = detectProfile(properties.profiles, options, values);
  return profile ? profile->name : "";
}

std::optional<ShaderPack> loadShaderPack(std::shared_ptr<const FileSource> source,
                                         const LoadRequest& request, Diagnostics& diagnostics) {
  return loadShaderPack(std::move(source), request, RebuildScope(), diagnostics);
}

std::optional<ShaderPack> loadShaderPack(std::shared_ptr<const FileSource> source,
                                         const LoadRequest& request, const RebuildScope& scope,
                                         Diagnostics& diagnostics, int* rebuilt) {
  const auto files = readPackFiles(std::move(source), request.environment, diagnostics);
  if (!files->complete && !request.keepGoing) return std::nullopt;
  return buildPack(files, request, nullptr, scope, diagnostics, rebuilt);
}

std::optional<ShaderPack> rebuildShaderPack(const ShaderPack& previous, const LoadRequest& request,
                                            Diagnostics& diagnostics, int* rebuilt) {
  return rebuildShaderPack(previous, request, {.earlier = &previous}, diagnostics, rebuilt);
}

std::optional<ShaderPack> rebuildShaderPack(const ShaderPack& outline, const LoadRequest& request,
                                            const RebuildScope& scope, Diagnostics& diagnostics,
                                            int* rebuilt) {
  return buildPack(outline.builds.front()->sharedFiles(), request, &outline, scope, diagnostics,
                   rebuilt);
}

}  // namespace orris
