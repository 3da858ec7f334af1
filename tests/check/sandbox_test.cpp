#include <orris/check/workers/sandbox.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <orris/check/workers/isolated_jobs.h>
#include <orris/core/files/file_source.h>
#include <orris/core/files/read_places.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

/// What `work` returns in a worker.
std::string inWorker(const std::function<std::string()>& work) {
  std::string result;
  runIsolated({.count = 1, .work = [&](std::size_t) { return work(); }},
              [&](std::size_t, const JobOutcome& outcome) {
                result = outcome.kind == JobOutcome::Kind::Done ? outcome.result : outcome.cause;
                return true;
              });
  return result;
}

std::string readAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return "refused";
  return {std::istreambuf_iterator<char>(file), {}};
}

#define NEEDS_LANDLOCK \
  if (sandboxSupport().landlock == 0) GTEST_SKIP() << "this kernel has no Landlock"
#define NEEDS_SECCOMP \
  if (!sandboxSupport().seccomp) GTEST_SKIP() << "this kernel has no filters of system calls"

TEST(Sandbox, a_worker_has_no_environment) {
  ASSERT_EQ(setenv("ORRIS_TEST_ONLY", "kept", 1), 0);
  ASSERT_EQ(setenv("TOKEN", "hunter2", 1), 0);
  // Also what the process was started with, where the kernel shows it; LD_LIBRARY_PATH, which is kept, ends alike.
  using namespace std::string_literals;
  const auto hasPath = [](const std::string& variables) { return ("\0"s + variables).find("\0PATH="s) != std::string::npos; };
  EXPECT_TRUE(hasPath(readAll("/proc/self/environ")));
  EXPECT_EQ(inWorker([] {
              const char* token = getenv("TOKEN");
              return std::string(token ? token : "none") + " " + getenv("ORRIS_TEST_ONLY");
            }),
            "none kept");
  const std::string environment = inWorker([] { return readAll("/proc/self/environ"); });
  EXPECT_FALSE(hasPath(environment));
  EXPECT_EQ(environment.find("hunter2"), std::string::npos);
  EXPECT_STREQ(getenv("TOKEN"), "hunter2");
  unsetenv("TOKEN");
}

TEST(Sandbox, a_worker_reads_no_file_of_a_person) {
  NEEDS_LANDLOCK;
  const fs::path secret = fs::path(testing::TempDir()) / "orris-sandbox-secret";
  std::ofstream(secret) << "hunter2";
  EXPECT_EQ(readAll(secret), "hunter2");
  EXPECT_EQ(inWorker([&] { return readAll(secret); }), "refused");
  EXPECT_EQ(inWorker([] { return readAll("/etc/passwd"); }), "refused");
  const std::string parent = "/proc/" + std::to_string(getpid()) + "/environ";
  EXPECT_EQ(inWorker([&] { return readAll(parent); }), "refused");
  fs::remove(secret);
}

TEST(Sandbox, a_worker_reads_the_pack_and_the_system) {
  const fs::path folder = fs::path(testing::TempDir()) / "orris-sandbox-pack";
  fs::create_directories(folder);
  std::ofstream(folder / "final.fsh") << "text";
  addReadPlace(folder);
  EXPECT_EQ(inWorker([&] { return readAll(folder / "final.fsh"); }), "text");
  EXPECT_NE(inWorker([] { return readAll("/proc/cpuinfo"); }), "refused");
  EXPECT_EQ(inWorker([] { return std::string(fs::exists("/usr/lib") ? "yes" : "no"); }), "yes");
  fs::remove_all(folder);
}

TEST(Sandbox, a_worker_writes_no_file) {
  NEEDS_LANDLOCK;
  const fs::path file = fs::path(testing::TempDir()) / "orris-sandbox-file";
  std::ofstream(file) << "old";
  const auto tries = [&] {
    std::string done;
    if (open(file.c_str(), O_WRONLY | O_TRUNC) >= 0) done += "write ";
    if (truncate(file.c_str(), 0) == 0) done += "truncate ";
    if (unlink(file.c_str()) == 0) done += "remove ";
    if (rename(file.c_str(), (file.string() + "2").c_str()) == 0) done += "rename ";
    if (open((file.string() + "3").c_str(), O_WRONLY | O_CREAT, 0600) >= 0) done += "create ";
    if (mkdir((file.string() + "4").c_str(), 0700) == 0) done += "folder ";
    if (symlink("/etc", (file.string() + "5").c_str()) == 0) done += "link ";
    if (sandboxSupport().seccomp && chmod(file.c_str(), 0777) == 0) done += "mode ";
    return done;
  };
  EXPECT_EQ(inWorker(tries), "");
  EXPECT_EQ(readAll(file), "old");
  fs::remove(file);
}

TEST(Sandbox, a_worker_has_no_network) {
  NEEDS_SECCOMP;
  EXPECT_GE(socket(AF_INET, SOCK_STREAM, 0), 0);
  EXPECT_EQ(inWorker([] {
              std::string made;
              for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK})
                if (socket(family, SOCK_DGRAM, 0) >= 0) made += "made ";
              return made;
            }),
            "");
}

TEST(Sandbox, a_worker_starts_no_program) {
  NEEDS_SECCOMP;
  EXPECT_EQ(inWorker([] {
              if (fork() >= 0) return std::string("forked");
              char name[] = "true";
              char* words[] = {name, nullptr};
              execv("/bin/true", words);
              return std::string("refused");
            }),
            "refused");
  // Threads are what drivers need.
  EXPECT_EQ(inWorker([] {
              std::string text;
              std::thread([&] { text = "thread"; }).join();
              return text;
            }),
            "thread");
}

/// What a shell says that a process became.
std::string fromShell(const std::string& script) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    enterSandboxToRunProgram({});
    execlp("sh", "sh", "-c", script.c_str(), nullptr);
    _exit(1);
  }
  close(ends[1]);
  std::string text;
  char block[256];
  for (ssize_t count = 0; (count = read(ends[0], block, sizeof block)) > 0;)
    text.append(block, static_cast<std::size_t>(count));
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return text;
}

TEST(Sandbox, a_program_that_a_process_becomes_is_shut_in) {
  const fs::path secret = fs::path(testing::TempDir()) / "orris-sandbox-program";
  std::ofstream(secret) << "hunter2\n";
  ASSERT_EQ(setenv("TOKEN", "hunter2", 1), 0);
  EXPECT_EQ(fromShell("echo $TOKEN."), ".\n");
  unsetenv("TOKEN");
  if (sandboxSupport().seccomp) {
    EXPECT_EQ(fromShell("(echo forked) 2>/dev/null").find("forked"), std::string::npos);
  }
  if (sandboxSupport().landlock > 0) {
    EXPECT_EQ(fromShell("read line < " + secret.string() + "; echo $line").find("hunter2"), std::string::npos);
    fromShell("echo new > " + secret.string());
    EXPECT_EQ(readAll(secret), "hunter2\n");
    // Nor one that is not installed.
    const fs::path own = secret.string() + ".sh";
    std::ofstream(own) << "#!/bin/sh\necho ran\n";
    fs::permissions(own, fs::perms::owner_all);
    EXPECT_EQ(fromShell("exec " + own.string()).find("ran"), std::string::npos);
    fs::remove(own);
  }
  fs::remove(secret);
}

TEST(Sandbox, a_worker_reaches_no_other_process) {
  NEEDS_SECCOMP;
  static int value = 42;
  const pid_t parent = getpid();
  EXPECT_EQ(inWorker([parent] {
              int copy = 0;
              const iovec here{&copy, sizeof copy}, there{&value, sizeof value};
              const bool read = process_vm_readv(parent, &here, 1, &there, 1, 0) > 0;
              return std::string(read || kill(parent, 0) == 0 ? "reached" : "refused");
            }),
            "refused");
  const std::string memory = "/proc/" + std::to_string(parent) + "/mem";
  EXPECT_GE(open(memory.c_str(), O_RDONLY), 0);
  EXPECT_EQ(inWorker([&] { return std::string(open(memory.c_str(), O_RDONLY) < 0 ? "no" : "yes"); }),
            sandboxSupport().landlock > 0 ? "no" : "yes");
  EXPECT_EQ(inWorker([] {
              return std::string(shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600) < 0 ? "no" : "yes");
            }),
            "no");
}

TEST(Sandbox, a_worker_can_end_itself_by_a_signal) {
  EXPECT_EQ(inWorker([]() -> std::string { abort(); }), "signal 6 (Aborted)");
}

TEST(Sandbox, a_worker_types_nothing_into_the_terminal) {
  NEEDS_SECCOMP;
  EXPECT_EQ(inWorker([] {
              char letter = 'x';
              errno = 0;
              ioctl(STDERR_FILENO, TIOCSTI, &letter);
              return std::to_string(errno);
            }),
            std::to_string(EPERM));
}

TEST(Sandbox, what_is_hidden_beside_the_shaders_of_a_pack_is_not_read) {
  NEEDS_LANDLOCK;
  const fs::path folder = fs::path(testing::TempDir()) / "orris-sandbox-checkout";
  for (const char* inside : {"shaders", "assets", ".git"}) {
    fs::create_directories(folder / inside);
    std::ofstream(folder / inside / "file") << "text";
  }
  std::ofstream(folder / "shaders" / "final.fsh") << "";
  Diagnostics diagnostics;
  const auto pack = openPack(folder.string(), diagnostics);
  ASSERT_TRUE(pack);
  EXPECT_EQ(inWorker([&] { return pack->readResource("/../assets/file").value_or("refused"); }), "text");
  EXPECT_EQ(inWorker([&] { return readAll(folder / "shaders" / "file"); }), "text");
  EXPECT_EQ(inWorker([&] { return readAll(folder / ".git" / "file"); }), "refused");
  fs::remove_all(folder);
}

TEST(Sandbox, the_cache_of_a_driver_is_the_one_place_to_write) {
  NEEDS_LANDLOCK;
  const fs::path cache = fs::path(testing::TempDir()) / "orris-sandbox-cache";
  const char* before = getenv("MESA_SHADER_CACHE_DIR");
  const std::string kept = before ? before : "";
  setenv("MESA_SHADER_CACHE_DIR", cache.c_str(), 1);
  std::string result;
  runIsolated({.count = 1,
               .work =
                   [&](std::size_t) {
                     fs::create_directories(cache / "a");
                     std::ofstream(cache / "a" / "b") << "compiled";
                     return readAll(cache / "a" / "b") + readAll("/etc/passwd");
                   },
               .driver = true},
              [&](std::size_t, const JobOutcome& outcome) {
                result = outcome.result;
                return true;
              });
  EXPECT_EQ(result, "compiledrefused");
  before ? setenv("MESA_SHADER_CACHE_DIR", kept.c_str(), 1) : unsetenv("MESA_SHADER_CACHE_DIR");
  fs::remove_all(cache);
}

TEST(Sandbox, a_worker_has_no_open_file_of_its_parent) {
  const int file = open("/etc/passwd", O_RDONLY);
  ASSERT_GE(file, 0);
  EXPECT_EQ(inWorker([file] {
              char byte = 0;
              return std::string(read(file, &byte, 1) == 1 ? "read" : "closed");
            }),
            "closed");
  close(file);
}

}  // namespace
}  // namespace orris
