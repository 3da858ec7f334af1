// Load, compile, first-frame and steady-frame times of the reference pack, per pass, beside the time
// that the driver alone takes to compile and link the same sources; with a cold and with a warm
// shader cache. Every measurement is a process of its own, because Mesa reads its cache once.
//
//   bench_pipeline [WORLD [WIDTHxHEIGHT]]
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <orris/core/files/file_source.h>
#include <orris/gl/context.h>
#include <orris/gl/functions.h>
#include <orris/render/session/render_session.h>
#include <orris/world/world.h>

namespace {

using namespace orris;
using nlohmann::json;

constexpr int kSteadyFrames = 12;
const char* const kPack = ORRIS_SOURCE_DIR "/shaderpack";

struct Setup {
  std::string mode, world, size;
  int width = 320, height = 180;
};

double seconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

[[noreturn]] void fail(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    std::cerr << formatDiagnostic(diagnostic) << '\n';
  std::exit(1);
}

std::optional<ShaderPack> loadPack(const gl::Context& context, const World& world,
                                   Diagnostics& diagnostics) {
  const std::shared_ptr<const FileSource> files = openPack(kPack, diagnostics);
  LoadRequest request;
  request.dimension = world.environment.dimension;
  request.environment = environmentFor(context.driver());
  return files ? loadShaderPack(files, request, diagnostics) : std::nullopt;
}

/// The driver alone: compile and link of every program that the schedule names.
json measureDriver(const Setup& setup, gl::Context& context, const World& world) {
  Diagnostics diagnostics;
  const auto pack = loadPack(context, world, diagnostics);
  if (!pack) fail(diagnostics);
  const SceneData scene = buildScene(world, {}, diagnostics);
  const Schedule schedule =
      buildSchedule(*pack, setup.width, setup.height, scene.contents(), diagnostics);
  std::vector<GpuProgram> programs;  // kept, so that deleting them is not timed
  const double compile = seconds([&] {
    for (const int index : schedule.programs) {
      const ProgramSource& source = pack->programs[index];
      std::vector<const StageText*> stages;
      for (const StageText& stage : source.stages) stages.push_back(&stage);
      if (!stages.empty()) {
        programs.push_back(buildGpuProgram(source.name, stages, {}, diagnostics));
      }
      for (const ComputeSource& compute : source.computes) {
        programs.push_back(buildGpuProgram(compute.name, {&compute.text}, {}, diagnostics));
      }
    }
  });
  return {{"compile", compile}, {"programs", programs.size()}};
}

SessionRequest requestFor(const Setup& setup, const World& world) {
  SessionRequest request;
  request.openPack = [](Diagnostics& diagnostics) {
    return std::shared_ptr<const FileSource>(openPack(kPack, diagnostics));
  };
  request.load.dimension = world.environment.dimension;
  request.renderer = {.width = setup.width, .height = setup.height, .timings = true};
  request.camera = world.cameras.front();
  return request;
}

/// The host: everything from the pack's folder to pixels.
json measureHost(const Setup& setup, gl::Context& context, const World& world) {
  Diagnostics diagnostics;
  const double load = seconds([&] {
    if (!loadPack(context, world, diagnostics)) fail(diagnostics);
  });
  std::unique_ptr<RenderSession> session;
  const double start = seconds([&] {
    session = RenderSession::create(context, requestFor(setup, world), world, diagnostics);
  });
  if (!session) fail(diagnostics);

  std::vector<double> frames;
  std::map<std::string, std::vector<double>> steps;
  std::vector<std::string> order;
  for (int frame = 0; frame <= kSteadyFrames; ++frame) {
    frames.push_back(seconds([&] { session->renderFrame(diagnostics); }));
    std::map<std::string, double> sums;  // a pass may run in several steps
    for (const StepTime& step : session->renderer().stepTimes()) {
      if (frame == 0 && !sums.contains(step.name)) order.push_back(step.name);
      sums[step.name] += step.seconds;
    }
    for (const auto& [name, time] : sums) steps[name].push_back(time);
  }
  json passes = json::array();
  for (const std::string& name : order) passes.push_back({{"name", name}, {"times", steps[name]}});
  return {{"load", load},
          {"start", start},
          {"compile", session->reloads().front().report.compileSeconds},
          {"frames", frames},
          {"passes", passes}};
}

int runChild(const Setup& setup) {
  Diagnostics diagnostics;
  const auto context = gl::createContext({}, diagnostics);
  const auto world = loadWorld(setup.world, 0, diagnostics);
  if (!context || !world) fail(diagnostics);
  const bool driver = setup.mode == "--driver";
  std::cout << (driver ? measureDriver(setup, *context, *world)
                       : measureHost(setup, *context, *world));
  return 0;
}

std::optional<json> runProcess(const std::string& program, const Setup& setup,
                               const std::string& mode, const std::string& cache) {
  std::filesystem::create_directories(cache);
  setenv("MESA_SHADER_CACHE_DIR", cache.c_str(), 1);
  const std::string command =
      fmt::format("'{}' {} '{}' {}", program, mode, setup.world, setup.size);
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string output;
  char buffer[4096];
  while (const size_t count = fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, count);
  if (pclose(pipe) != 0) return std::nullopt;
  return json::parse(output, nullptr, false);
}

double steady(const json& times) {  // median without the first
  std::vector<double> rest = times.get<std::vector<double>>();
  rest.erase(rest.begin());
  if (rest.empty()) return 0;
  std::nth_element(rest.begin(), rest.begin() + rest.size() / 2, rest.end());
  return rest[rest.size() / 2];
}

void printRow(const std::string& name, double cold, double warm) {
  fmt::print("{:<28}{:>10.2f}{:>10.2f}\n", name, cold * 1000, warm * 1000);
}

void print(const Setup& setup, const json (&host)[2], const json (&driver)[2]) {
  fmt::print("{} at {}x{}, milliseconds\n{:<28}{:>10}{:>10}\n", setup.world, setup.width,
             setup.height, "", "cold", "warm");
  for (const char* name : {"load", "compile"}) printRow(name, host[0][name], host[1][name]);
  printRow("driver alone", driver[0]["compile"], driver[1]["compile"]);
  printRow("first frame", host[0]["frames"][0], host[1]["frames"][0]);
  printRow("steady frame", steady(host[0]["frames"]), steady(host[1]["frames"]));
  for (size_t i = 0; i < host[0]["passes"].size(); ++i) {
    const json &cold = host[0]["passes"][i], &warm = host[1]["passes"][i];
    const std::string name = cold["name"];
    printRow("  first  " + name, cold["times"][0], warm["times"][0]);
    printRow("  steady " + name, steady(cold["times"]), steady(warm["times"]));
  }
  for (int i = 0; i < 2; ++i) {
    const double alone = driver[i]["compile"], compile = host[i]["compile"], load = host[i]["load"];
    fmt::print("{} cache: compile is {:.2f} of the driver alone, load and compile {:.2f}\n",
               i == 0 ? "cold" : "warm", compile / alone, (load + compile) / alone);
  }
}

int runParent(const std::string& program, const Setup& setup) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("orris_bench_{}", getpid());
  json host[2], driver[2];
  bool complete = true;
  for (int warm = 0; warm < 2; ++warm) {
    for (const auto& [mode, result] : {std::pair{"--host", host}, std::pair{"--driver", driver}}) {
      const auto measured = runProcess(program, setup, mode, (folder / (mode + 2)).string());
      complete &= measured.has_value();
      if (measured) result[warm] = *measured;
    }
  }
  std::filesystem::remove_all(folder);
  if (complete) print(setup, host, driver);
  return complete ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  Setup setup{.world = ORRIS_SOURCE_DIR "/worlds/cornell", .size = "320x180"};
  if (!arguments.empty() && arguments[0].starts_with("--")) {
    setup.mode = arguments[0];
    arguments.erase(arguments.begin());
  }
  if (!arguments.empty()) setup.world = arguments[0];
  if (arguments.size() > 1) setup.size = arguments[1];
  if (std::sscanf(setup.size.c_str(), "%dx%d", &setup.width, &setup.height) != 2) return 2;
  return setup.mode.empty() ? runParent(argv[0], setup) : runChild(setup);
}
