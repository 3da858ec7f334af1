#include "chart/setting_session.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <numeric>

#include "chart/reference_picture.h"

namespace orris {
namespace {

void addPass(Visit& visit, const StepTime& step, int frames) {
  const double milliseconds = step.seconds * 1e3 / frames;
  const auto found = std::find_if(visit.passes.begin(), visit.passes.end(),
                                  [&](const auto& pass) { return pass.first == step.name; });
  if (found == visit.passes.end())
    visit.passes.emplace_back(step.name, milliseconds);
  else
    found->second += milliseconds;  // a pass may run in several steps
}

}  // namespace

double Visit::mean() const {
  return frames.empty() ? 0
                        : std::accumulate(frames.begin(), frames.end(), 0.0) /
                              static_cast<double>(frames.size());
}

std::unique_ptr<SettingSession> SettingSession::open(gl::Context& context, SessionRequest request,
                                                     World world, Diagnostics& diagnostics) {
  world.events.clear();
  request.renderer.floatScreen = true;
  request.renderer.timings = true;
  auto session = RenderSession::create(context, std::move(request), std::move(world), diagnostics);
  if (session == nullptr) return nullptr;
  return std::unique_ptr<SettingSession>(new SettingSession(std::move(session)));
}

Visit SettingSession::visit(int frames, Diagnostics& diagnostics) {
  Visit visit;
  for (int frame = 0; frame < frames; ++frame) {
    const auto start = std::chrono::steady_clock::now();
    draw(diagnostics);  // ends with its last pass finished
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    visit.frames.push_back(took.count());
    for (const StepTime& step : renderer().stepTimes()) addPass(visit, step, frames);
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
