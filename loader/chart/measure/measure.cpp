#include <orris/chart/measure/measure.h>

#include <fmt/format.h>

#include <algorithm>

#include <orris/chart/measure/display.h>

namespace orris {
namespace {

// Of the time that is left: what is not measured in pairs cannot be on the chart.
constexpr double kShareOfErrors = 0.6;
// A session that does not fit any more would make the machine swap, and all times with it.
constexpr std::size_t kSpareMemory = std::size_t{1} << 30;

// Writing files between rounds would show in the times of the first setting.
constexpr std::chrono::seconds kKeepInterval{20};

void addVisit(SettingResult& result, const Visit& visit) {
  result.frames.insert(result.frames.end(), visit.frames.begin(), visit.frames.end());
  for (const auto& [name, milliseconds] : visit.passes) {
    const auto found =
        std::find_if(result.passes.begin(), result.passes.end(),
                     [&name = name](const PassTimes& pass) { return pass.name == name; });
    if (found == result.passes.end())
      result.passes.push_back({name, {milliseconds}});
    else
      found->times.push_back(milliseconds);
  }
}

void noBuffer(const std::string& buffer, const SettingJob& job, const FrameRenderer& renderer,
              Diagnostics& diagnostics) {
  diagnostics.push_back({.id = "dump-unknown",
                         .message = fmt::format("{} has no buffer {} as large as the screen",
                                                job.result.label, buffer),
                         .hint = "buffers: " + renderer.bufferNames()});
}

}  // namespace

int framesLeft(const std::vector<SettingJob*>& jobs, const MeasurePlan& plan) {
  int frames = 0;
  for (const SettingJob* job : jobs) {
    const int rounds = std::max(0, plan.rounds - int(job->result.pairs.size()));
    if (!job->done(plan)) frames += plan.warmUp + 2 * (plan.visit + 1) * rounds;
    if (!job->errorDone()) frames += plan.frames;
  }
  return frames;
}

Measuring::Measuring(gl::Context& context, const World& world, const MeasurePlan& plan,
                     const MeasureHooks& hooks, std::optional<Clock::time_point> end)
    : context_(context), world_(world), plan_(plan), hooks_(hooks), end_(end) {}

bool Measuring::timeLeft() const { return !end_ || Clock::now() < *end_; }

bool Measuring::draw(SettingSession& session, int frames, Diagnostics& diagnostics) {
  for (int frame = 0; frame < frames; ++frame) {
    if (errorsEnd_ && Clock::now() >= *errorsEnd_) return false;
    session.draw(diagnostics);
    hooks_.drew(1);
  }
  return true;
}

std::unique_ptr<SettingSession> Measuring::openSettled(const SessionRequest& request,
                                                       Diagnostics& diagnostics) {
  World still = world_;
  still.events.clear();
  auto session = SettingSession::open(context_, request, std::move(still), diagnostics);
  if (!session || !draw(*session, plan_.warmUp, diagnostics)) return nullptr;
  session->stopClock();
  return session;
}

bool Measuring::measureError(Member& member, Diagnostics& diagnostics) {
  SettingJob& job = *member.job;
  ErrorMeter meter(*job.reference, plan_.frames);
  std::optional<ImageF> picture;
  for (int frame = 0; frame < plan_.frames; ++frame) {
    if (!draw(*member.session, 1, diagnostics)) return false;
    picture = member.session->picture(plan_.buffer);
    if (!picture) {
      noBuffer(plan_.buffer, job, member.session->renderer(), diagnostics);
      return false;
    }
    meter.add(*picture);
  }
  job.result.error = meter.summary();
  job.result.ssim = displayedSimilarity(*picture, job.reference->mean, job.exposure);
  hooks_.pictures(job, *picture, meter.meanPicture());
  return true;
}

/// Opens as many of the jobs from `next` on as fit; the number of the first that does not.
std::size_t Measuring::fillGroup(Group& group, const std::vector<SettingJob*>& jobs,
                                 std::size_t next, Diagnostics& diagnostics) {
  const std::optional<std::size_t> before = availableMemory();
  const std::size_t alone = group.size();
  for (; next < jobs.size() && group.size() < alone + plan_.alive; ++next) {
    const std::optional<std::size_t> now = availableMemory();
    const std::size_t opened = group.size() - alone;
    const bool known = now && before && opened > 0 && *before > *now;
    if (known && *now < kSpareMemory + 2 * (*before - *now) / opened) break;
    Member member{jobs[next], openSettled(jobs[next]->request, diagnostics)};
    if (!member.session) continue;
    member.job->result.chosen = member.session->chosen();
    if (!member.job->errorDone() && !measureError(member, diagnostics)) continue;
    hooks_.changed(*member.job);
    group.push_back(std::move(member));
  }
  return next;
}

void Measuring::round(Group& group, Diagnostics& diagnostics) {
  std::vector<double> sums(group.size());
  for (const std::size_t turn : turns(group.size())) {
    const Visit visit = group[turn].session->visit(plan_.visit, plan_.clock, diagnostics);
    hooks_.drew(plan_.visit + 1);
    addVisit(group[turn].job->result, visit);
    sums[turn] += visit.mean() / 2;
  }
  for (std::size_t i = 0; i < group.size(); ++i)
    group[i].job->result.pairs.push_back({sums[i], sums[0]});
}

void Measuring::measureTimes(Group& group, Diagnostics& diagnostics) {
  const auto lacks = [&] {
    return std::any_of(group.begin() + 1, group.end(),
                       [&](const Member& member) { return !member.job->done(plan_); }) ||
           (group.size() == 1 && !group.front().job->done(plan_));
  };
  const auto keep = [&] {
    for (const Member& member : group) hooks_.changed(*member.job);
  };
  Clock::time_point kept = Clock::now();
  while (lacks() && timeLeft()) {
    round(group, diagnostics);
    if (Clock::now() - kept < kKeepInterval) continue;
    keep();
    kept = Clock::now();
  }
  keep();
}

void Measuring::beginErrors(std::size_t groupsLeft) {
  if (!end_) return;
  const Clock::duration left = *end_ - Clock::now();
  const auto share = std::chrono::duration<double>(left) * (kShareOfErrors / double(groupsLeft));
  errorsEnd_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(share);
}

void Measuring::run(const std::vector<SettingJob*>& jobs, Diagnostics& diagnostics) {
  std::vector<SettingJob*> pending;
  for (std::size_t i = 1; i < jobs.size(); ++i)
    if (!jobs[i]->done(plan_)) pending.push_back(jobs[i]);
  if (jobs.empty() || (pending.empty() && jobs.front()->done(plan_))) return;
  beginErrors(1 + pending.size() / plan_.alive);
  Group group;
  if (fillGroup(group, {jobs.front()}, 0, diagnostics) == 0 || group.empty()) return;
  std::size_t next = 0;
  do {
    next = fillGroup(group, pending, next, diagnostics);
    measureTimes(group, diagnostics);
    group.resize(1);
    beginErrors(1 + (pending.size() - next) / plan_.alive);
  } while (next < pending.size() && timeLeft());
}

std::optional<ReferencePicture> Measuring::drawReference(const SessionRequest& request, int frames,
                                                         Diagnostics& diagnostics) {
  errorsEnd_ = end_;
  const auto session = openSettled(request, diagnostics);
  if (!session || !draw(*session, plan_.frames, diagnostics)) return std::nullopt;
  ReferencePicture reference;
  const int half = std::max(frames / 2, 1);
  for (ImageF* part : {&reference.first, &reference.second}) {
    std::vector<double> sum;
    for (int frame = 0; frame < half; ++frame) {
      if (!draw(*session, 1, diagnostics)) return std::nullopt;
      const std::optional<ImageF> picture = session->picture(plan_.buffer);
      if (!picture) {
        SettingJob named;
        named.result.label = "the reference";
        noBuffer(plan_.buffer, named, session->renderer(), diagnostics);
        return std::nullopt;
      }
      *part = *picture;
      sum.resize(picture->pixels.size());
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += picture->pixels[i];
    }
    for (std::size_t i = 0; i < sum.size(); ++i) part->pixels[i] = float(sum[i] / half);
  }
  reference.mean = reference.first;
  for (std::size_t i = 0; i < reference.mean.pixels.size(); ++i)
    reference.mean.pixels[i] = (reference.first.pixels[i] + reference.second.pixels[i]) / 2;
  reference.hasHalves = true;
  return reference;
}

}  // namespace orris
