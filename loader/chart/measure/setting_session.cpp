#include <orris/chart/measure/setting_session.h>

#include <time.h>

#include <algorithm>
#include <fstream>
#include <numeric>

#include <orris/chart/measure/reference_picture.h>

namespace orris {
namespace {

void addPass(Visit& visit, const StepTime& step, FrameClock clock, int frames) {
  const double seconds = clock == FrameClock::Wall ? step.seconds : step.processorSeconds;
  const double milliseconds = seconds * 1e3 / frames;
  const auto found = std::find_if(visit.passes.begin(), visit.passes.end(),
                                  [&](const auto& pass) { return pass.first == step.name; });
  if (found == visit.passes.end())
    visit.passes.emplace_back(step.name, milliseconds);
  else
    found->second += milliseconds;  // a pass may run in several steps
}

}  // namespace

double millisecondsOf(FrameClock clock) {
  timespec time{};
  clock_gettime(clock == FrameClock::Wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double Visit::mean() const {
  return frames.empty() ? 0
                        : std::accumulate(frames.begin(), frames.end(), 0.0) /
                              static_cast<double>(frames.size());
}

std::unique_ptr<SettingSession> SettingSession::open(gl::Context& context, SessionRequest request,
                                                     World world, Diagnostics& diagnostics) {
  request.renderer.floatScreen = true;
  request.renderer.timings = true;
  auto session = RenderSession::create(context, std::move(request), std::move(world), diagnostics);
  if (session == nullptr) return nullptr;
  return std::unique_ptr<SettingSession>(new SettingSession(std::move(session)));
}

Visit SettingSession::visit(int frames, FrameClock clock, Diagnostics& diagnostics) {
  Visit visit;
  draw(diagnostics);
  for (int frame = 0; frame < frames; ++frame) {
    const double start = millisecondsOf(clock);
    draw(diagnostics);  // ends with its last pass finished
    visit.frames.push_back(millisecondsOf(clock) - start);
    for (const StepTime& step : renderer().stepTimes()) addPass(visit, step, clock, frames);
  }
  return visit;
}

std::optional<ImageF> SettingSession::picture(const std::string& buffer) const {
  if (buffer.empty()) return toRgb(renderer().screenshotLinear());
  const std::optional<ImageF> image = renderer().dump(buffer);
  const Schedule& schedule = renderer().schedule();
  if (!image || image->width != schedule.width || image->height != schedule.height)
    return std::nullopt;
  return toRgb(*image);
}

std::vector<std::size_t> turns(std::size_t count) {
  std::vector<std::size_t> order(2 * count);
  std::iota(order.begin(), order.begin() + std::ptrdiff_t(count), std::size_t{0});
  std::reverse_copy(order.begin(), order.begin() + std::ptrdiff_t(count),
                    order.begin() + std::ptrdiff_t(count));
  return order;
}

std::optional<std::size_t> availableMemory() {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    constexpr std::string_view kName = "MemAvailable:";
    if (line.starts_with(kName)) return std::stoull(line.substr(kName.size())) * 1024;
  }
  return std::nullopt;
}

}  // namespace orris
