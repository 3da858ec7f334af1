#include "app/commands/trace_loop.h"

#include <atomic>
#include <csignal>

#include "app/output/progress.h"

namespace orris {
namespace {

std::atomic<bool> traceInterrupted{false};

class InterruptGuard {
 public:
  InterruptGuard() {
    traceInterrupted = false;
    before_ = std::signal(SIGINT, [](int) {
      traceInterrupted = true;
      std::signal(SIGINT, SIG_DFL);
    });
  }
  ~InterruptGuard() { std::signal(SIGINT, before_); }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  void (*before_)(int) = SIG_DFL;
};

}  // namespace

void withTraceHooks(Report& report, const std::function<void(const TraceHooks& hooks)>& work) {
  const InterruptGuard guard;
  Progress bar("tracing %", 100, report.output());
  work({[&bar](double share) { bar.advanceTo(int(100 * share)); }, [] { return traceInterrupted.load(); }});
}

}  // namespace orris
