#include "validate/driver_check.h"

#include <nlohmann/json.hpp>

#include "check/workers/diagnostic_codec.h"
#include "pack/mods/mods.h"
#include "render/gpu_program.h"

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

/// A job's first byte tells whether the verdict is good; what follows are its diagnostics.
std::string encodeVerdict(bool good, const Diagnostics& diagnostics) {
  return std::string(1, good ? '1' : '0') + encodeDiagnostics(diagnostics);
}

// Drivers of graphics cards reserve more addresses than any limit allows.
constexpr std::size_t kNoMemoryLimit = 0;

}  // namespace

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

void checkWithDriver(const ShaderPack& pack, gl::Backend backend, Verdicts& verdicts,
                     Diagnostics& diagnostics) {
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
  runIsolated({.count = units.size(), .work = check, .memoryBytes = kNoMemoryLimit},
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
                           const std::function<void(gl::Context&, Diagnostics&)>& work) {
  Diagnostics result;
  const auto job = [&](std::size_t) {
    Diagnostics found;
    // Never destroyed: the process ends without cleaning up, as drivers may not survive that either.
    gl::Context* context = gl::createContext({.backend = backend}, found).release();
    if (context) work(*context, found);
    return encodeDiagnostics(found);
  };
  runIsolated({.count = 1,
               .work = job,
               .time = std::chrono::seconds(kDrawSeconds),
               .memoryBytes = kNoMemoryLimit},
              [&](std::size_t, const JobOutcome& outcome) {
                result = outcome.kind == JobOutcome::Kind::Done
                             ? decodeDiagnostics(outcome.result)
                             : Diagnostics{lostJob(outcome, kDriver, what, "")};
                return true;
              });
  return result;
}

}  // namespace orris
