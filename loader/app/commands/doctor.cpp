// orris doctor: what this machine gives to drawing and to keeping strangers' packs apart from the rest.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands/commands.h"
#include "app/input/shipped_worlds.h"
#include "app/output/report.h"
#include <orris/check/workers/sandbox.h>
#include <orris/image/codecs/image_codecs.h>
#include <orris/validate/driver_check.h>

namespace orris {
namespace {

/// One line: what it is about, and what was found.
struct MachineFact {
  std::string name, text;
};
using MachineFacts = std::vector<MachineFact>;

std::string kernelText(const SandboxSupport& support) {
  utsname name{};
  uname(&name);
  return fmt::format("{} {} {}; Landlock: {}; seccomp: {}", name.sysname, name.release,
                     name.machine,
                     support.landlock > 0 ? fmt::format("version {}", support.landlock) : "none",
                     support.seccomp ? "yes" : "none");
}

std::string sandboxText(const SandboxSupport& support) {
  if (support.landlock > 0 && support.seccomp)
    return support.landlock >= 3 ? "workers reach no file, process or network but what they need"
                                 : "the same, but for lengths of files that this Landlock leaves";
  if (support.landlock > 0)
    return "files only: this kernel or processor has no filters of system calls";
  if (support.seccomp)
    return "system calls only: this kernel has no Landlock, workers can read files";
  return "none: this kernel has neither Landlock nor filters of system calls; limits alone hold";
}

std::string limitText(__rlimit_resource resource, rlim_t unit, const char* name,
                      const char* behind) {
  rlimit limit{};
  getrlimit(resource, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) return fmt::format("{} without limit", name);
  return fmt::format("{} {}{}", name, limit.rlim_cur / unit, behind);
}

std::string limitsText() {
  constexpr rlim_t kMebibyte = rlim_t{1} << 20;
  return limitText(RLIMIT_AS, kMebibyte, "addresses", " MiB") + ", " +
         limitText(RLIMIT_CPU, 1, "processor time", " s") + ", " +
         limitText(RLIMIT_FSIZE, kMebibyte, "files", " MiB each") + ", " +
         limitText(RLIMIT_NOFILE, 1, "open files", "") + ", " +
         limitText(RLIMIT_NPROC, 1, "processes", "");
}

std::string machineText() {
  const auto pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const auto bytes = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  return fmt::format("{} cores, {:.1f} GiB of memory", std::thread::hardware_concurrency(),
                     bytes / (1 << 30));
}

std::string driverText(gl::Backend backend, bool& draws) {
  Diagnostics diagnostics;
  const auto driver = askDriver(backend, diagnostics);
  if (!driver) return diagnostics.empty() ? "does not draw" : diagnostics.front().message;
  draws = true;
  return fmt::format("{}; OpenGL {}; GLSL {}; {}", driver->renderer, driver->version,
                     driver->shadingLanguage,
                     gl::isSoftware(backend) ? "in the sandbox" : "not in the sandbox");
}

/// Only a window says which driver it has.
std::string windowText() {
  Diagnostics diagnostics;
  const auto driver = askDriver(gl::Backend::Glfw, diagnostics);
  if (!driver) return diagnostics.empty() ? "does not open" : diagnostics.front().message;
  const bool apart = gl::isSoftwareRenderer(driver->renderer) && gl::isInstalled(gl::Backend::Egl);
  return fmt::format("{}; view draws {}", driver->renderer,
                     apart ? "in the sandbox, apart from its window" : "in the process of its window, not in the sandbox");
}

std::string dataText() {
  Diagnostics diagnostics;
  const bool codecs = imageCodecs("", diagnostics) != nullptr;
  const std::size_t worlds = shippedWorldNames().size();
  return fmt::format("{} worlds, {}", worlds,
                     codecs ? "picture codecs" : diagnostics.front().message);
}

MachineFacts examine(bool& draws) {
  const SandboxSupport support = sandboxSupport();
  // Before anything starts a thread: drivers are asked in forked processes.
  MachineFacts facts = {{"kernel", kernelText(support)},
                        {"sandbox", sandboxText(support)},
                        {"limits", limitsText()},
                        {"machine", machineText()},
                        {"osmesa", driverText(gl::Backend::OSMesa, draws)},
                        {"egl", driverText(gl::Backend::Egl, draws)},
                        {"window", windowText()}};
  facts.push_back({"data", dataText()});
  return facts;
}

int runDoctor(const OutputOptions& output, Report& report, nlohmann::json& result) {
  bool draws = false;
  const MachineFacts facts = examine(draws);
  for (const MachineFact& fact : facts) {
    result[fact.name] = fact.text;
    if (!output.json) printText(fmt::format("{:8} {}\n", fact.name, fact.text));
  }
  if (draws) return kClean;
  report.error("gl-no-headless-context",
               "no way to draw without a display: neither OSMesa nor EGL gave a context",
               "install libosmesa6, or libegl1 with libegl-mesa0 and libgl1-mesa-dri");
  return kHostFailed;
}

}  // namespace

void addDoctorCommand(CLI::App& app, int& status) {
  const auto output = std::make_shared<OutputOptions>();
  CLI::App* command =
      app.add_subcommand("doctor", "what this machine offers: sandbox, limits, drivers");
  addOutputFlags(*command, *output);
  command->callback([output, &status] {
    Report report(*output);
    nlohmann::json result = nlohmann::json::object();
    status = runDoctor(*output, report, result);
    result["status"] = status;
    printJson(std::move(result), report);
  });
}

}  // namespace orris
