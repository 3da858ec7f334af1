// orris validate: checks packs without a world.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "app/commands.h"
#include "app/draw_check.h"
#include "app/inputs.h"
#include "check/pack_checks.h"
#include "check/program_check.h"
#include "frame/render_session.h"

namespace orris {
namespace {

struct ValidateOptions {
  std::vector<std::string> paths;
  PackOptions pack;
  std::vector<std::string> profiles;  ///< {"all"}, names, or none: the values as they are
  std::vector<std::string> dimensions{"all"};
  int jobs = std::max(1, int(std::thread::hardware_concurrency()));
  std::string format = "text";
  bool draw = false;
  gl::Backend backend = gl::Backend::Auto;
  OutputOptions output;
};

/// What was checked of one pack. Programs are counted once, whatever the number of profiles.
struct PackVerdict {
  std::string path;
  std::set<std::string> programs, failed, dimensions, profiles;
  int status = kClean;
};

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

/// Checks shared by all packs of a run: the driver's context (with --draw), and what was checked.
struct Checker {
  int jobs = 1;
  std::unique_ptr<gl::Context> context;
  Verdicts glslang, driver;

  MacroDefinitions environment() const {
    return context ? environmentFor(context->driver()) : standardMacros({});
  }
  bool passed(std::uint64_t hash) const {
    return glslang.at(hash) && (!context || driver.at(hash));
  }
};

bool openContext(const ValidateOptions& options, Checker& checker) {
  Report report(options.output);
  Diagnostics diagnostics;
  checker.context = gl::createContext({.backend = options.backend}, diagnostics);
  report.add(diagnostics);
  return checker.context != nullptr;
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

void checkFrame(const ShaderPack& pack, Diagnostics& diagnostics) {
  const Schedule schedule = buildSchedule(pack, kScheduleWidth, kScheduleHeight, {}, diagnostics);
  const Diagnostics found =
      checkFolder({.pack = pack, .schedule = schedule, .target = targetTable().front()});
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
}

std::optional<ShaderPack> checkOne(const std::shared_ptr<const FileSource>& files,
                                   const LoadRequest& request, Checker& checker,
                                   PackVerdict& verdict, Report& report) {
  auto pack = loadPack(files, request, report, verdict.status);
  if (!pack) return std::nullopt;
  Diagnostics diagnostics = ruleNotes(*pack);
  checkPrograms(*pack, checker, diagnostics);
  checkFrame(*pack, diagnostics);
  verdict.dimensions.insert(pack->folder);
  verdict.profiles.insert(request.profile);
  for (const ProgramUnit& unit : programUnits(*pack)) {
    verdict.programs.insert(unit.name);
    if (!checker.passed(unit.hash)) verdict.failed.insert(unit.name);
  }
  if (checker.context && verdict.failed.empty()) {
    drawOneFrame(*checker.context, files, request, diagnostics);
  }
  report.add(diagnostics);
  return pack;
}

PackVerdict validatePack(const std::string& path, const ValidateOptions& options, Checker& checker,
                         Report& report) {
  PackVerdict verdict{.path = path};
  const auto files = openPackFiles(path, report, verdict.status);
  if (!files) return verdict;
  auto request =
      makeLoadRequest(files, options.pack, checker.environment(), report, verdict.status);
  if (!request) return verdict;
  request->buildSources = false;
  const auto outline = loadPack(files, *request, report, verdict.status);
  if (!outline) return verdict;

  request->buildSources = true;
  for (const std::string& profile :
       chosen(options.profiles, namesOf(outline->properties.profiles))) {
    if (!profile.empty()) request->profile = profile;
    std::vector<ShaderPack> folders;
    for (const std::string& dimension : chosen(options.dimensions, outline->dimensions)) {
      request->dimension = dimension;
      auto pack = checkOne(files, *request, checker, verdict, report);
      if (pack) folders.push_back(std::move(*pack));
    }
    if (folders.size() == outline->dimensions.size()) {
      Diagnostics diagnostics = checkWholePack(folders);
      report.add(diagnostics);
    }
  }
  return verdict;
}

void printText(const PackVerdict& verdict) {
  const size_t good = verdict.programs.size() - verdict.failed.size();
  std::string text = fmt::format("{}: {}/{} programs", verdict.path, good, verdict.programs.size());
  if (verdict.dimensions.size() > 1) text += fmt::format(", {} folders", verdict.dimensions.size());
  if (verdict.profiles.size() > 1) text += fmt::format(", {} profiles", verdict.profiles.size());
  std::cout << text << '\n';
  for (const std::string& name : verdict.failed) std::cout << "  failed: " << name << '\n';
}

nlohmann::json toJson(const PackVerdict& verdict) {
  return {{"path", verdict.path},         {"programs", verdict.programs},
          {"failed", verdict.failed},     {"folders", verdict.dimensions},
          {"profiles", verdict.profiles}, {"status", verdict.status}};
}

int runValidate(const ValidateOptions& options) {
  int status = kClean;
  Checker checker{.jobs = options.jobs};
  if (options.draw && !openContext(options, checker)) return kHostFailed;
  nlohmann::json packs = nlohmann::json::array();
  for (const std::string& path : options.paths) {
    // A report of its own for each pack: equal messages of two packs are two problems.
    Report report(options.output);
    PackVerdict verdict = validatePack(path, options, checker, report);
    verdict.status = std::max<int>(verdict.status, report.status());
    status = std::max(status, verdict.status);
    if (!options.output.json) printText(verdict);
    packs.push_back(toJson(verdict));
    packs.back()["diagnostics"] = toJson(report.all());
  }
  if (options.output.json) printJson({{"packs", packs}, {"status", status}});
  return status;
}

}  // namespace

void addValidateCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand("validate", "check shader packs without a world");
  command->add_option("pack", options->paths, "shader packs: folders or .zip files")
      ->type_name("PACK")
      ->required();
  addPackFlags(*command, options->pack);
  command->add_option("--profiles", options->profiles, "check these profiles: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--dimensions", options->dimensions, "check these folders: all, or NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--draw", options->draw,
                    "compile and link with the GL driver too, and draw one frame");
  addBackendFlag(*command, options->backend);
  command->add_option("--jobs", options->jobs, "threads")->check(CLI::Range(1, 256));
  command->add_option("--format", options->format, "text or json")
      ->check(CLI::IsMember({"text", "json"}));
  addOutputFlags(*command, options->output);
  command->callback([options, &status] {
    options->output.json |= options->format == "json";
    status = runValidate(*options);
  });
}

}  // namespace orris
