#include <orris/validate/driver_check.h>

#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <orris/check/workers/diagnostic_codec.h>
#include <orris/check/workers/isolated_jobs.h>
#include <orris/core/work_record.h>
#include <orris/pack/mods/mods.h>
#include <orris/render/gpu_program.h>

namespace orris {
namespace {

using nlohmann::json;

constexpr const char* kDriver = "the GL driver";

std::string encode(const gl::DriverInfo& driver) {
  std::string bytes;
  json::to_cbor(json::array({driver.vendor, driver.renderer, driver.version, driver.shadingLanguage,
                             driver.glVersion, driver.extensions}),
                bytes);
  return bytes;
}

gl::DriverInfo decodeDriver(const std::string& bytes) {
  const json value = json::from_cbor(bytes);
  gl::DriverInfo driver;
  driver.vendor = value[0];
  driver.renderer = value[1];
  driver.version = value[2];
  driver.shadingLanguage = value[3];
  driver.glVersion = value[4];
  driver.extensions = value[5].get<std::vector<std::string>>();
  return driver;
}

/// A job's first byte says whether the verdict is good; what follows are its diagnostics.
std::string encodeVerdict(bool good, const Diagnostics& diagnostics) {
  return std::string(1, good ? '1' : '0') + encodeDiagnostics(diagnostics);
}

/// Jobs that a driver works for.
IsolatedJobs driverJobs(gl::Backend backend) {
  const bool software = gl::isSoftware(backend);
  IsolatedJobs jobs;
  jobs.memoryBytes = driverMemory(software);
  jobs.confined = software;
  jobs.driver = true;
  return jobs;
}

/// The driver died or did not end while it drew: where, as far as it was noted.
void addPlace(const WorkNote& note, Diagnostic& diagnostic) {
  diagnostic.at.file = note.file;
  if (!note.where().empty()) diagnostic.notes.push_back(note.where());
}

}  // namespace

std::size_t driverMemory(bool software) {
  if (!software) return 0;
  constexpr std::size_t kLeast = std::size_t{4} << 30;
  const long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || bytes <= 0) return kLeast;
  return std::max(kLeast, static_cast<std::size_t>(pages) * static_cast<std::size_t>(bytes));
}

std::optional<gl::DriverInfo> askDriver(gl::Backend backend, Diagnostics& diagnostics) {
  std::optional<gl::DriverInfo> driver;
  Diagnostics found = runWithContext(backend, "", [](gl::Context& context, Diagnostics& out) {
    out.push_back(
        {.severity = Severity::Note, .id = "driver", .message = encode(context.driver())});
  });
  if (!found.empty() && found.back().id == "driver") {
    driver = decodeDriver(found.back().message);
    found.pop_back();
  }
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  return driver;
}

void checkWithDriver(const ShaderPack& pack, gl::Backend backend, std::chrono::seconds time,
                     Verdicts& verdicts, Diagnostics& diagnostics) {
  const std::vector<ProgramUnit> units = unitsWithoutVerdict(pack, verdicts);
  const SourceLines lines = [&pack](const std::string& file, int line) {
    return pack.sourceLine(file, line);
  };
  std::unique_ptr<gl::Context> context;  // made by each worker, never by this process
  const auto check = [&](std::size_t i) {
    Diagnostics found;
    if (!context) context = gl::createContext({.backend = backend}, found);
    const bool linked =
        context && buildGpuProgram(units[i].name, units[i].stages, lines, found).program.linked;
    return encodeVerdict(linked, found);
  };
  std::vector<Diagnostics> found(units.size());
  IsolatedJobs jobs = driverJobs(backend);
  jobs.count = units.size();
  jobs.work = check;
  jobs.time = time;
  runIsolated(jobs,
              [&](std::size_t i, const JobOutcome& outcome) {
                const bool done = outcome.kind == JobOutcome::Kind::Done;
                verdicts[units[i].hash] = done && outcome.result.front() == '1';
                found[i] = done ? decodeDiagnostics(std::string_view(outcome.result).substr(1))
                                : Diagnostics{lostJob(outcome, kDriver, units[i].name,
                                                      entryFile(units[i]))};
                return true;
              });
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (!units[i].mod.empty()) markAsOfMod(units[i].mod, found[i]);
    diagnostics.insert(diagnostics.end(), found[i].begin(), found[i].end());
  }
}

Diagnostics runWithContext(gl::Backend backend, const std::string& what,
                           const std::function<void(gl::Context&, Diagnostics&)>& work,
                           std::chrono::seconds time) {
  Diagnostics result;
  const WorkRecord record;
  IsolatedJobs jobs = driverJobs(backend);
  jobs.count = 1;
  jobs.time = time;
  jobs.work = [&](std::size_t) {
    Diagnostics found;
    // Never destroyed: the process ends without cleaning up, as drivers may not survive that either.
    gl::Context* context = gl::createContext({.backend = backend, .visible = false}, found).release();
    if (context) work(*context, found);
    return encodeDiagnostics(found);
  };
  runIsolated(jobs, [&](std::size_t, const JobOutcome& outcome) {
    if (outcome.kind == JobOutcome::Kind::Done) {
      result = decodeDiagnostics(outcome.result);
    } else {
      result = {lostJob(outcome, kDriver, what, "")};
      addPlace(record.read(), result.front());
    }
    return true;
  });
  return result;
}

}  // namespace orris
