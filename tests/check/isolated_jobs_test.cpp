#include <orris/check/workers/isolated_jobs.h>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <stdexcept>

namespace orris {
namespace {

using testing::ElementsAre;

using Outcomes = std::map<std::size_t, JobOutcome>;

Outcomes outcomesOf(IsolatedJobs jobs) {
  Outcomes outcomes;
  runIsolated(jobs, [&](std::size_t index, JobOutcome outcome) {
    outcomes[index] = std::move(outcome);
    return true;
  });
  return outcomes;
}

std::string outcomeText(const JobOutcome& outcome) {
  switch (outcome.kind) {
    case JobOutcome::Kind::Done:
      return outcome.result;
    case JobOutcome::Kind::Crashed:
      return "crashed: " + outcome.cause;
    case JobOutcome::Kind::TimedOut:
      return "timed out";
  }
  return "";
}

std::vector<std::string> texts(const Outcomes& outcomes) {
  std::vector<std::string> result;
  for (const auto& [index, outcome] : outcomes) result.push_back(outcomeText(outcome));
  return result;
}

TEST(IsolatedJobs, each_job_gives_its_result_whatever_the_workers) {
  for (const int workers : {1, 3, 9}) {
    const auto outcomes = outcomesOf({.count = 5, .workers = workers, .work = [](std::size_t i) {
                                 return std::string(i * 100'000, 'x');
                               }});
    ASSERT_EQ(outcomes.size(), 5u);
    for (const auto& [i, outcome] : outcomes) EXPECT_EQ(outcome.result.size(), i * 100'000);
  }
}

TEST(IsolatedJobs, without_workers_all_is_done_in_this_process) {
  const auto work = [](std::size_t) { return std::to_string(getpid()); };
  int taken = 0;
  runIsolated({.count = 3, .workers = 0, .work = work}, [&](std::size_t index, JobOutcome outcome) {
    EXPECT_EQ(index, std::size_t(taken));
    EXPECT_EQ(outcomeText(outcome), std::to_string(getpid()));
    return ++taken < 2;
  });
  EXPECT_EQ(taken, 2);
}

TEST(IsolatedJobs, job_that_kills_its_worker_is_reported_and_the_rest_goes_on) {
  const auto outcomes = outcomesOf({.count = 5, .workers = 2, .work = [](std::size_t i) {
                               if (i == 1) raise(SIGKILL);
                               if (i == 2) _exit(9);
                               if (i == 3) throw std::runtime_error("no more");
                               return "job " + std::to_string(i);
                             }});
  EXPECT_THAT(texts(outcomes),
              ElementsAre("job 0", "crashed: signal 9 (Killed)", "crashed: exit status 9",
                          "crashed: an exception, such as out of memory", "job 4"));
}

TEST(IsolatedJobs, job_that_never_ends_is_given_up) {
  const auto outcomes = outcomesOf({.count = 3,
                             .workers = 2,
                             .work =
                                 [](std::size_t i) {
                                   for (volatile bool forever = i == 1; forever;) {
                                   }
                                   return std::string("done");
                                 },
                             .time = std::chrono::seconds(1)});
  EXPECT_THAT(texts(outcomes), ElementsAre("done", "timed out", "done"));
}

TEST(IsolatedJobs, job_that_sleeps_for_ever_is_given_up) {
  const auto outcomes = outcomesOf({.count = 2,
                             .workers = 1,
                             .work =
                                 [](std::size_t i) {
                                   while (i == 0) pause();
                                   return std::string("done");
                                 },
                             .time = std::chrono::seconds(0)});
  EXPECT_THAT(texts(outcomes), ElementsAre("timed out", "done"));
}

TEST(IsolatedJobs, what_is_in_progress_when_the_time_ends_is_given_up) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
  const auto outcomes = outcomesOf({.count = 3,
                             .workers = 2,
                             .work =
                                 [](std::size_t i) {
                                   while (i == 1) pause();
                                   return std::string("done");
                                 },
                             .until = until});
  EXPECT_GE(std::chrono::steady_clock::now(), until);
  EXPECT_THAT(texts(outcomes), ElementsAre("done", "done"));
  EXPECT_FALSE(outcomes.contains(1));
}

TEST(IsolatedJobs, a_result_longer_than_allowed_is_not_taken) {
  const auto outcomes = outcomesOf({.count = 2,
                             .work = [](std::size_t i) { return std::string(i == 0 ? 3000 : 10, 'x'); },
                             .resultBytes = 1000});
  EXPECT_THAT(texts(outcomes), ElementsAre("crashed: a result that is too long", "xxxxxxxxxx"));
}

/// Finds the socket of the worker and sends a length without a result.
std::string lieAboutLength(std::uint64_t length) {
  for (int file = 3; file < 64; ++file) send(file, &length, sizeof length, MSG_NOSIGNAL);
  for (;;) pause();
}

TEST(IsolatedJobs, a_worker_that_lies_about_its_result_costs_no_memory_and_no_time) {
  for (const std::uint64_t length : {std::uint64_t{100}, ~std::uint64_t{0}}) {
    const auto outcomes = outcomesOf({.count = 2,
                               .work =
                                   [length](std::size_t i) {
                                     return i == 0 ? lieAboutLength(length) : std::string("done");
                                   },
                               .time = std::chrono::seconds(0)});
    EXPECT_THAT(texts(outcomes), ElementsAre(length == 100 ? "timed out"
                                                           : "crashed: a result that is too long",
                                             "done"));
  }
}

TEST(IsolatedJobs, a_worker_cannot_raise_its_own_limits) {
  const auto outcomes = outcomesOf({.count = 1, .work = [](std::size_t) {
                               std::string raised;
                               for (const auto resource : {RLIMIT_CPU, RLIMIT_NOFILE, RLIMIT_FSIZE,
                                                           RLIMIT_CORE}) {
                                 const rlimit any{RLIM_INFINITY, RLIM_INFINITY};
                                 raised += setrlimit(resource, &any) == 0 ? 'y' : 'n';
                               }
                               return raised;
                             }});
  EXPECT_THAT(texts(outcomes), ElementsAre("nnnn"));
}

TEST(IsolatedJobs, a_job_outside_of_the_sandbox_starts_workers_of_its_own) {
  const auto outcomes = outcomesOf({.count = 1,
                             .work =
                                 [](std::size_t) {
                                   const auto inner = outcomesOf({.count = 2, .work = [](std::size_t i) {
                                                             if (i == 0) raise(SIGKILL);
                                                             return std::string("inner");
                                                           }});
                                   return outcomeText(inner.at(0)) + ", " + outcomeText(inner.at(1));
                                 },
                             .confined = false});
  EXPECT_THAT(texts(outcomes), ElementsAre("crashed: signal 9 (Killed), inner"));
}

TEST(IsolatedJobs, nothing_starts_after_take_said_no) {
  std::size_t taken = 0;
  runIsolated({.count = 100, .workers = 1, .work = [](std::size_t) { return std::string(); }},
              [&](std::size_t, const JobOutcome&) { return ++taken < 3; });
  EXPECT_EQ(taken, 3u);
}

}  // namespace
}  // namespace orris
