#include <orris/validate/validate_pack.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/check/compile/link_errors.h>
#include <orris/check/compile/unused_functions.h>
#include <orris/check/hints/conditional_place.h>
#include <orris/check/interface/declaration_checks.h>
#include <orris/check/pack/open_comments.h>
#include <orris/check/pack/pack_checks.h>
#include <orris/check/rules/rules.h>
#include <orris/core/files/snapshot_source.h>
#include <orris/core/work_stage.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/folder_build.h>
#include <orris/pack/rebuild.h>
#include <orris/plan/schedule/auto_choices.h>
#include <orris/plan/frame/uniforms.h>
#include <orris/render/session/render_session.h>
#include <orris/validate/consequences.h>
#include <orris/validate/draw_check.h>
#include <orris/validate/pack_outline.h>
#include <orris/validate/patched_sources.h>
#include <orris/validate/result_cache.h>

namespace orris {
namespace {

std::vector<std::string> namesOf(const std::vector<Profile>& profiles) {
  std::vector<std::string> names;
  for (const Profile& profile : profiles) names.push_back(profile.name);
  return names;
}

std::vector<std::string> chosen(const std::vector<std::string>& request,
                                const std::vector<std::string>& all) {
  const bool everything = request.size() == 1 && request.front() == "all";
  std::vector<std::string> result = everything ? all : request;
  if (result.empty()) result.push_back("");
  return result;
}

void checkPrograms(const ShaderPack& pack, Checker& checker, Diagnostics& diagnostics) {
  checkWithGlslang(pack, checker.jobs, checker.glslang, diagnostics, checker.quiet,
                   checker.trials.get());
  if (!checker.gpu) return;
  // What glslang refuses has been reported; the driver would report it again in other words.
  for (const auto& [hash, good] : checker.glslang) {
    if (!good) checker.driver[hash] = false;
  }
  checkWithDriver(pack, checker.backend, std::min(checker.drawTime, kProgramTime), checker.driver,
                  diagnostics);
}

// The size decides nothing that the checks look at but sizes given in pixels.
constexpr int kScheduleWidth = 1920, kScheduleHeight = 1080;

/// Names of programs whose stages do not link, though each compiles.
std::set<std::string> checkFrame(const ShaderPack& pack, const TargetLimits& target,
                                 Diagnostics& diagnostics) {
  const Schedule schedule = buildSchedule(pack, kScheduleWidth, kScheduleHeight, {}, diagnostics);
  const FolderInput input{.pack = pack, .schedule = schedule, .target = target};
  const Diagnostics found = checkFolder(input);
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  return hasErrors(found) ? programsThatDoNotLink(input) : std::set<std::string>();
}

/// The same folder as the check before had it; nullptr: it had none.
const ShaderPack* sameFolder(const std::vector<ShaderPack>* earlier, const ShaderPack& outline,
                             const std::string& dimension) {
  if (earlier == nullptr) return nullptr;
  const std::string folder = outline.builds.front()->files().dimensions.resolve(dimension);
  const auto found = std::ranges::find(*earlier, folder, &ShaderPack::folder);
  return found == earlier->end() ? nullptr : &*found;
}

/// The folders under the values of `request`, from the files that `outline` was loaded from.
std::vector<ShaderPack> makeFolders(const ShaderPack& outline,
                                    const std::vector<std::string>& dimensions,
                                    LoadRequest& request, const Checker& checker,
                                    const std::vector<ShaderPack>* earlier, PackVerdict& verdict,
                                    ProblemList& problems) {
  std::vector<ShaderPack> folders;
  std::vector<Diagnostics> found;
  for (const std::string& dimension : dimensions) {
    request.dimension = dimension;
    const RebuildScope scope{.earlier = sameFolder(earlier, outline, dimension)};
    auto pack = rebuildShaderPack(outline, request, scope, found.emplace_back());
    // OptiFine takes a stage without #version for GLSL 1.20.
    if (!checker.target.iris)
      std::erase_if(found.back(), [](const Diagnostic& d) { return d.id == "version-missing"; });
    if (pack) {
      folders.push_back(std::move(*pack));
    } else {
      verdict.status = statusOf(found.back());
    }
  }
  settleConditionals(folders, checker.jobs, *checker.trials, found);
  for (Diagnostics& diagnostics : found) problems.add(diagnostics);
  return folders;
}

/// What the host may choose for options that are AUTO: each candidate alone.
void checkCandidates(const ShaderPack& pack, const LoadRequest& request, Checker& checker,
                     Diagnostics& diagnostics) {
  const std::vector<std::string> options = optionsAtAuto(pack);
  for (const AutoCandidate& candidate : autoCandidates(pack)) {
    if (std::find(options.begin(), options.end(), candidate.option) == options.end()) continue;
    LoadRequest chosen = request;
    chosen.dimension = pack.folder;
    chosen.values[candidate.option] = candidate.value;
    if (const auto other = rebuildShaderPack(pack, chosen, diagnostics)) {
      checkPrograms(*other, checker, diagnostics);
      checkFrame(*other, checker.target, diagnostics);
    }
  }
}

void checkOne(const ShaderPack& pack, const LoadRequest& request, Checker& checker,
              PackVerdict& verdict, ProblemList& problems) {
  Diagnostics diagnostics = ruleNotes(pack);
  checkPrograms(pack, checker, diagnostics);
  const std::set<std::string> unlinked = checkFrame(pack, checker.target, diagnostics);
  checkCandidates(pack, request, checker, diagnostics);
  verdict.dimensions.insert(pack.folder);
  verdict.profiles.insert(request.profile);
  for (const ProgramUnit& unit : programUnits(pack)) {
    ProgramVerdicts& programs =
        unit.mod.empty() ? verdict.programs : verdict.modPrograms[std::string(unit.mod)];
    programs.all.insert(unit.name);
    if (!checker.passed(unit.hash) || unlinked.contains(unit.name))
      programs.failed.insert(unit.name);
  }
  reportSwallowedCode(pack, checker.glslang, checker.jobs, diagnostics);
  if (checker.gpu && checker.draw && !hasErrors(diagnostics)) {
    checkDrawing(checker.backend, pack.source, request, checker.drawTime, diagnostics);
  }
  dropRepeatedLinkErrors(diagnostics);
  problems.add(diagnostics);
}

void checkMatrix(const std::vector<ShaderPack>& folders, const LoadRequest& request,
                 const ValidateOptions& options, Checker& checker, PackVerdict& verdict,
                 ProblemList& problems) {
  MatrixRequest matrix = options.matrix;
  matrix.jobs = options.jobs;
  if (matrix.kind == MatrixKind::None || folders.empty()) return;
  matrix.until = checker.budget.beginMatrix();
  MatrixResult result = runMatrix({.folders = folders,
                                   .environment = request.environment,
                                   .verdicts = checker.glslang,
                                   .reported = problems.all()},
                                  matrix, [&](std::size_t done, std::size_t total) {
                                    if (options.progress) options.progress(done, total);
                                  });
  const std::size_t before = problems.all().size();
  problems.add(result.diagnostics);
  for (std::size_t i = before; i < problems.all().size(); ++i) verdict.ofMatrix.insert(i);
  verdict.matrices.push_back({.kind = std::string(matrixKindName(matrix.kind)),
                              .profile = request.profile,
                              .shard = matrix.shard,
                              .shards = matrix.shards,
                              .configurations = result.configurations,
                              .tried = result.tried,
                              .variants = result.variants,
                              .compiled = result.compiled,
                              .all = result.all,
                              .seconds = result.seconds});
}

/// The options that --options names must be the pack's.
bool knowsOptions(const ShaderPack& pack, const std::vector<std::string>& names, ProblemList& problems) {
  bool all = true;
  for (const std::string& name : names) {
    if (pack.options.find(name)) continue;
    std::vector<std::string> known;
    for (const auto& [option, definition] : pack.options.all()) known.push_back(option);
    problems.error("option-unknown", fmt::format("--options: the pack has no option {}", name),
                 suggest(name, known));
    all = false;
  }
  return all;
}

std::string nameOf(const HostVersions& versions) {
  return fmt::format("Iris {} and Minecraft {}", versionText(versions.iris),
                     versionText(versions.game));
}

/// nullptr: reported.
std::shared_ptr<const PackOutline> loadOutline(const HostVersions& versions,
                                               const ValidateOptions& options, const Checker& checker,
                                               PackVerdict& verdict, ProblemList& problems) {
  const bool known = checker.outline && checker.outline->files == verdict.files &&
                     checker.outline->versions == versions;
  const auto outline =
      known ? checker.outline : readOutline(versions, options, checker, verdict.files);
  Diagnostics diagnostics = outline->diagnostics;
  if (!outline->pack) verdict.status = statusOf(diagnostics);
  problems.add(diagnostics);
  if (!outline->pack) return nullptr;
  if (!knowsOptions(*outline->pack, options.matrix.options, problems)) {
    verdict.status = kUsage;
    return nullptr;
  }
  return outline;
}

/// The newest first: what is wrong there is the more urgent.
std::vector<HostVersions> versionsToCheck(const ShaderPack& pack, const ValidateOptions& options) {
  VersionRange range;
  if (options.versions) {
    range = *options.versions;
  } else {
    range.oldest = statedMinimum(pack.properties).value_or(range.newest);
  }
  if (range.oldest == range.newest) return {range.newest};
  return {range.newest, range.oldest};
}

void writeSources(const std::string& to, const ShaderPack& folder, PackVerdict& verdict,
                  ProblemList& problems) {
  Diagnostics diagnostics;
  if (!writePatchedWithMap(to, folder, diagnostics)) verdict.status = statusOf(diagnostics);
  problems.add(diagnostics);
}

void checkVersion(const PackOutline& outline, const std::vector<std::string>& profiles,
                  const std::string& versions, const ValidateOptions& options, Checker& checker,
                  PackVerdict& verdict, ProblemList& problems) {
  LoadRequest request = outline.request;
  for (const std::string& profile : profiles) {
    checker.budget.beginChecks();
    if (!profile.empty()) request.profile = profile;
    const std::string context = profiles.size() > 1 ? "profile " + profile : "";
    const bool both = !context.empty() && !versions.empty();
    problems.setContext(context + (both ? ", " : "") + versions);
    auto& kept = checker.folders[versions];
    kept = std::make_shared<const std::vector<ShaderPack>>(
        makeFolders(*outline.pack, chosen(options.dimensions, outline.pack->dimensions), request,
                    checker, kept.get(), verdict, problems));
    const std::vector<ShaderPack>& folders = *kept;
    for (const ShaderPack& folder : folders) {
      request.dimension = folder.folder;
      checkOne(folder, request, checker, verdict, problems);
      if (!options.patched.empty() && versions.empty())
        writeSources(options.patched, folder, verdict, problems);
    }
    if (folders.size() == outline.pack->dimensions.size()) {
      Diagnostics diagnostics = checkWholePack(folders);
      checkUnusedFunctions(folders, checker.jobs, checker.glslang, diagnostics);
      problems.add(diagnostics);
    }
    checkMatrix(folders, request, options, checker, verdict, problems);
  }
}

/// All that is checked of the files that `verdict` has.
void checkPack(PackVerdict& verdict, const ValidateOptions& options, Checker& checker,
               ProblemList& problems) {
  const HostVersions newest = options.versions ? options.versions->newest : HostVersions();
  std::shared_ptr<const PackOutline> outline =
      loadOutline(newest, options, checker, verdict, problems);
  if (!outline) return;
  const std::vector<HostVersions> all = versionsToCheck(*outline->pack, options);
  const std::vector<std::string> profiles =
      chosen(options.profiles, namesOf(outline->pack->properties.profiles));
  checker.budget.beginPack(profiles.size() * all.size());
  for (const HostVersions& versions : all) {
    const std::string name = versions == newest ? "" : nameOf(versions);
    problems.setContext(name);
    if (!name.empty()) outline = loadOutline(versions, options, checker, verdict, problems);
    if (outline) checkVersion(*outline, profiles, name, options, checker, verdict, problems);
  }
  problems.setContext("");
  problems.noteContexts(profiles.size() * all.size());
}

void checkAgain(const std::shared_ptr<const FileSource>& files, const ValidateOptions& options,
                Checker checker, ProblemList& problems) {
  PackVerdict verdict{.files = files};
  ValidateOptions same = options;
  same.matrix.kind = MatrixKind::None;
  same.patched.clear();
  // What nothing was reported of is as good as it was.
  std::erase_if(checker.glslang, [&](const auto& one) {
    return checker.quiet == nullptr || !checker.quiet->contains(one.first);
  });
  checker.driver.clear();
  checker.quiet = nullptr;
  checker.draw = false;
  checkPack(verdict, same, checker, problems);
}

}  // namespace

MacroDefinitions Checker::environment(const HostVersions& versions) const {
  return gpu ? environmentFor(*gpu, versions) : standardMacros(hostOf(target, versions));
}

bool Checker::passed(std::uint64_t hash) const {
  return glslang.at(hash) && (!gpu || driver.at(hash));
}

std::optional<Checker> makeChecker(const ValidateOptions& options, std::size_t packs,
                                   Diagnostics& diagnostics) {
  Checker checker{.jobs = options.jobs,
                  .target = *options.target,
                  .backend = options.backend,
                  .budget = MatrixBudget(options.matrixTime, packs),
                  .drawTime = options.drawTime};
  if (options.draw) {
    checker.gpu = askDriver(options.backend, diagnostics);
    if (!checker.gpu) return std::nullopt;
  }
  return checker;
}

ValidateResult validatePack(const ValidateOptions& options) {
  ValidateResult result{.baseline = options.baseline, .strict = options.judge.strict};
  ProblemList problems;
  PackVerdict verdict{.path = options.pack.path};
  Diagnostics diagnostics;
  if (auto checker = makeChecker(options, 1, diagnostics)) {
    problems.add(diagnostics);
    verdict = validatePath(options.pack.path, options, ResultCache(options.cache), *checker, problems);
  } else {
    verdict.status = statusOf(diagnostics);
    problems.add(diagnostics);
  }
  addPack(result, std::move(verdict), problems, options.judge);
  return result;
}

PackVerdict validateFiles(const std::string& path, std::shared_ptr<const FileSource> files,
                          const ValidateOptions& options, Checker& checker, ProblemList& problems) {
  const WorkStage stage("checking", path);
  PackVerdict verdict{.path = path, .files = std::move(files)};
  checker.trials = std::make_shared<TrialMemo>();
  checkPack(verdict, options, checker, problems);
  findConsequences(verdict, options, checker, checkAgain, problems);
  return verdict;
}

PackVerdict validatePath(const std::string& path, const ValidateOptions& options,
                         const ResultCache& cache, Checker& checker, ProblemList& problems) {
  const WorkStage stage("checking", path);
  PackVerdict verdict{.path = path};
  Diagnostics diagnostics;
  // What is hashed for the cache is what is checked, and most files are read by many checks.
  if (auto opened = openPack(path, diagnostics)) verdict.files = snapshotOf(std::move(opened));
  if (!verdict.files) verdict.status = statusOf(diagnostics);
  problems.add(diagnostics);
  if (!verdict.files) return verdict;
  // What opening reported is of the file system, and no entry's business.
  std::optional<std::string> key;
  if (problems.all().empty()) key = cache.keyOf(*verdict.files, options);
  if (key && cache.restore(*key, verdict, problems)) return verdict;
  checker.trials = std::make_shared<TrialMemo>();
  checkPack(verdict, options, checker, problems);
  findConsequences(verdict, options, checker, checkAgain, problems);
  checker.folders.clear();  // the next pack is another
  if (key) cache.keep(*key, verdict, problems);
  return verdict;
}

}  // namespace orris
