#include <orris/render/inspect/step_clock.h>

#include <ctime>
#include <utility>

#include <orris/gl/functions.h>

namespace orris {
namespace {

/// Of all threads.
double processorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

gl::Handle<gl::deleteQuery> makeQuery() {
  unsigned id = 0;
  gl::CreateQueries(GL_TIMESTAMP, 1, &id);
  return gl::Handle<gl::deleteQuery>(id);
}

}  // namespace

StepClock::StepClock(bool hasCard) {
  if (!hasCard) return;
  first_ = makeQuery();
  last_ = makeQuery();
}

void StepClock::start() {
  start_ = std::chrono::steady_clock::now();
  processorStart_ = processorSeconds();
  if (first_) gl::QueryCounter(first_.id(), GL_TIMESTAMP);
}

StepTime StepClock::stop(std::string name) {
  if (last_) gl::QueryCounter(last_.id(), GL_TIMESTAMP);
  gl::Finish();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  StepTime time{std::move(name), passed.count(), processorSeconds() - processorStart_, {}};
  if (!last_) return time;
  GLuint64 first = 0, last = 0;
  gl::GetQueryObjectui64v(first_.id(), GL_QUERY_RESULT, &first);
  gl::GetQueryObjectui64v(last_.id(), GL_QUERY_RESULT, &last);
  time.cardSeconds = double(last - first) * 1e-9;
  return time;
}

}  // namespace orris
