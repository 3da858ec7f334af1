// What the host itself costs in a frame of the reference pack: processor time of the drawing thread outside of GL
// functions, beside that of all threads. Every GL function is called through a timer, so that the same calls are
// measured with and without what the host does between them.
//
//   bench_host [WORLD [WIDTHxHEIGHT [FRAMES]]]
// Exit status 1: the host takes 3 % or more of the median frame.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>
#include <type_traits>
#include <vector>

#include <orris/core/files/file_source.h>
#include <orris/gl/context.h>
#include <orris/gl/functions.h>
#include <orris/render/session/render_session.h>
#include <orris/world/world.h>

namespace {

using namespace orris;

constexpr double kMostShare = 0.03;
constexpr int kFirstFrames = 3;  // drivers make machine code then

double processorTime(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

struct Inside {
  static inline double seconds = 0;
  static inline long calls = 0;
  double began = processorTime(CLOCK_THREAD_CPUTIME_ID);
  ~Inside() {
    seconds += processorTime(CLOCK_THREAD_CPUTIME_ID) - began;
    ++calls;
  }
};

template <typename Function, Function** kSlot>
struct Timed;

template <typename Result, typename... Arguments, Result (**kSlot)(Arguments...)>
struct Timed<Result(Arguments...), kSlot> {
  static inline Result (*driver)(Arguments...) = nullptr;
  static Result call(Arguments... arguments) {
    const Inside inside;
    return driver(arguments...);
  }
  static void put() {
    driver = *kSlot;
    if (driver) *kSlot = call;
  }
};

void timeFunctions() {
#define ORRIS_GL(name) Timed<std::remove_pointer_t<decltype(gl::name)>, &gl::name>::put();
#include <orris/gl/functions.inc>
#undef ORRIS_GL
}

/// What reading the clock twice for each call adds to the time outside.
double clockSeconds() {
  constexpr int kCalls = 20000;
  const double began = processorTime(CLOCK_THREAD_CPUTIME_ID);
  const double before = Inside::seconds;
  for (int i = 0; i < kCalls; ++i) const Inside inside;
  const double all = processorTime(CLOCK_THREAD_CPUTIME_ID) - began;
  const double counted = Inside::seconds - before;
  Inside::seconds = before;
  return std::max(0.0, (all - counted) / kCalls);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

[[noreturn]] void fail(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) std::cerr << formatDiagnostic(diagnostic) << '\n';
  std::exit(1);
}

std::unique_ptr<RenderSession> openSession(gl::Context& context, const World& world, int width, int height) {
  Diagnostics diagnostics;
  SessionRequest request;
  request.openPack = [](Diagnostics& problems) {
    return std::shared_ptr<const FileSource>(openPack(ORRIS_SOURCE_DIR "/shaderpack", problems));
  };
  request.load.dimension = world.environment.dimension;
  request.renderer = {.width = width, .height = height};
  request.camera = world.cameras.front();
  auto session = RenderSession::create(context, std::move(request), world, diagnostics);
  if (!session) fail(diagnostics);
  return session;
}

int measure(const std::string& worldPath, int width, int height, int frames) {
  Diagnostics diagnostics;
  const auto context = gl::createContext({}, diagnostics);
  const auto world = loadWorld(worldPath, 0, diagnostics);
  if (!context || !world) fail(diagnostics);
  const auto session = openSession(*context, *world, width, height);
  timeFunctions();
  const double clock = clockSeconds();
  std::vector<double> outside, inside, all;
  long calls = 0;
  for (int frame = 0; frame < kFirstFrames + frames; ++frame) {
    Inside::seconds = 0;
    Inside::calls = 0;
    const double thread = processorTime(CLOCK_THREAD_CPUTIME_ID);
    const double process = processorTime(CLOCK_PROCESS_CPUTIME_ID);
    session->renderFrame(diagnostics);
    gl::Finish();  // the frame's work, wherever the driver does it
    const double own = processorTime(CLOCK_THREAD_CPUTIME_ID) - thread;
    if (frame < kFirstFrames) continue;
    calls = Inside::calls;
    outside.push_back(std::max(0.0, own - Inside::seconds - clock * double(calls)));
    inside.push_back(Inside::seconds);
    all.push_back(processorTime(CLOCK_PROCESS_CPUTIME_ID) - process);
  }
  const double share = median(outside) / median(all);
  fmt::print("{} at {}x{}, {} frames, {} calls of GL a frame\n", worldPath, width, height, frames, calls);
  fmt::print("drawing thread outside of GL {:.3f} ms, in GL {:.3f} ms; all threads {:.2f} ms; outside {:.2f} % of the frame\n",
             median(outside) * 1e3, median(inside) * 1e3, median(all) * 1e3, share * 100);
  return share < kMostShare ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string world = argc > 1 ? argv[1] : ORRIS_SOURCE_DIR "/worlds/cornell";
  int width = 640, height = 360;
  if (argc > 2 && std::sscanf(argv[2], "%dx%d", &width, &height) != 2) return 2;
  return measure(world, width, height, argc > 3 ? std::max(1, std::atoi(argv[3])) : 20);
}
