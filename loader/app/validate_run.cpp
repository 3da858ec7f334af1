#include "app/validate_run.h"

#include "app/draw_check.h"
#include "app/inputs.h"
#include "app/patched_sources.h"
#include "check/link_errors.h"
#include "check/pack_checks.h"
#include "frame/render_session.h"
#include "frame/uniforms.h"

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
  checkWithGlslang(pack, checker.jobs, checker.glslang, diagnostics);
  if (!checker.context) return;
  // What glslang refuses has been told; the driver would tell it again in other words.
  for (const auto& [hash, good] : checker.glslang) {
    if (!good) checker.driver[hash] = false;
  }
  checkWithDriver(pack, checker.driver, diagnostics);
}

// The size decides nothing that the checks look at but sizes given in pixels.
constexpr int kScheduleWidth = 1920, kScheduleHeight = 1080;

void checkFrame(const ShaderPack& pack, const TargetLimits& target, Diagnostics& diagnostics) {
  const Schedule schedule = buildSchedule(pack, kScheduleWidth, kScheduleHeight, {}, diagnostics);
  const Diagnostics found = checkFolder({.pack = pack, .schedule = schedule, .target = target});
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
}

std::optional<ShaderPack> checkOne(const std::shared_ptr<const FileSource>& files,
                                   const LoadRequest& request, Checker& checker,
                                   PackVerdict& verdict, Report& report) {
  auto pack = loadPack(files, request, report, verdict.status);
  if (!pack) return std::nullopt;
  Diagnostics diagnostics = ruleNotes(*pack);
  checkPrograms(*pack, checker, diagnostics);
  checkFrame(*pack, checker.target, diagnostics);
  dropRepeatedLinkErrors(diagnostics);
  verdict.dimensions.insert(pack->folder);
  verdict.profiles.insert(request.profile);
  for (const ProgramUnit& unit : programUnits(*pack)) {
    ProgramVerdicts& programs =
        unit.mod.empty() ? verdict.programs : verdict.modPrograms[std::string(unit.mod)];
    programs.all.insert(unit.name);
    if (!checker.passed(unit.hash)) programs.failed.insert(unit.name);
  }
  if (checker.context && !hasErrors(diagnostics)) {
    drawOneFrame(*checker.context, files, request, diagnostics);
  }
  report.add(diagnostics);
  return pack;
}

}  // namespace

MacroDefinitions Checker::environment() const {
  return context ? environmentFor(context->driver()) : standardMacros(hostOf(target));
}

bool Checker::passed(std::uint64_t hash) const {
  return glslang.at(hash) && (!context || driver.at(hash));
}

bool openContext(const ValidateOptions& options, Checker& checker) {
  Report report(options.output);
  Diagnostics diagnostics;
  checker.context = gl::createContext({.backend = options.backend}, diagnostics);
  report.add(diagnostics);
  return checker.context != nullptr;
}

PackVerdict validatePack(const std::string& path, const ValidateOptions& options, Checker& checker,
                         Report& report) {
  PackVerdict verdict{.path = path};
  const auto files = openPackFiles(path, report, verdict.status);
  verdict.files = files;
  if (!files) return verdict;
  auto request =
      makeLoadRequest(files, options.pack, checker.environment(), report, verdict.status);
  if (!request) return verdict;
  request->buildSources = false;
  const auto outline = loadPack(files, *request, report, verdict.status);
  if (!outline) return verdict;

  request->buildSources = true;
  request->buildModPrograms = true;
  request->uniformTypes = uniformTypes();
  for (const std::string& profile :
       chosen(options.profiles, namesOf(outline->properties.profiles))) {
    if (!profile.empty()) request->profile = profile;
    std::vector<ShaderPack> folders;
    for (const std::string& dimension : chosen(options.dimensions, outline->dimensions)) {
      request->dimension = dimension;
      auto pack = checkOne(files, *request, checker, verdict, report);
      if (!pack) continue;
      if (!options.patched.empty()) {
        writePatchedWithMap(options.patched, *pack, report, verdict.status);
      }
      folders.push_back(std::move(*pack));
    }
    if (folders.size() == outline->dimensions.size()) {
      Diagnostics diagnostics = checkWholePack(folders);
      report.add(diagnostics);
    }
  }
  return verdict;
}

}  // namespace orris
