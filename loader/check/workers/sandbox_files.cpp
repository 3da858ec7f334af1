#include <orris/check/workers/sandbox_files.h>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>

namespace orris {
namespace {

namespace fs = std::filesystem;

// The kernel's interface, which the headers of older systems lack in part: linux/landlock.h.
struct Ruleset {
  std::uint64_t files = 0, network = 0, scopes = 0;
};
struct [[gnu::packed]] PathRule {
  std::uint64_t allowed = 0;
  std::int32_t place = -1;
};
constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1;
constexpr int kBeneath = 1;
constexpr std::uint64_t kExecute = 1 << 0, kWriteFile = 1 << 1, kReadFile = 1 << 2, kReadFolder = 1 << 3,
                        kRemoveFolder = 1 << 4, kRemoveFile = 1 << 5, kMakeFolder = 1 << 7,
                        kMakeFile = 1 << 8, kTruncate = 1 << 14;
constexpr std::uint64_t kRead = kReadFile | kReadFolder;
constexpr std::uint64_t kOfFiles = kExecute | kReadFile | kWriteFile | kTruncate;

/// All that a version of the interface can refuse.
Ruleset everything(int version) {
  constexpr std::uint64_t kFirst = (1 << 13) - 1, kRefer = 1 << 13, kDeviceControl = 1 << 15;
  Ruleset all{.files = kFirst};
  if (version >= 2) all.files |= kRefer;
  if (version >= 3) all.files |= kTruncate;
  if (version >= 4) all.network = 3;  // bind and connect
  if (version >= 5) all.files |= kDeviceControl;
  if (version >= 6) all.scopes = 3;  // abstract sockets and signals
  return all;
}

std::size_t sizeFor(int version) {
  if (version >= 6) return sizeof(Ruleset);
  return version >= 4 ? 2 * sizeof(std::uint64_t) : sizeof(std::uint64_t);
}

// What the dynamic linker, the C library, Mesa and LLVM read: none of it is of a person.
constexpr std::array kSystemPlaces = {
    "/usr",       "/lib",       "/lib64",     "/lib32",
    "/nix/store", "/gnu/store",          // systems that keep their libraries there
    "/etc/ld.so.cache",                  // where libraries lie
    "/etc/drirc", "/etc/glvnd", "/etc/egl",  // which driver, and how
    "/proc/self",                        // the memory map, for the size of the stack
    "/proc/cpuinfo", "/proc/meminfo", "/proc/stat", "/sys/devices/system/cpu"};  // cores, memory

/// `rights` as far as the rules know them, of a file only those of files.
void allow(int ruleset, const Ruleset& rules, const std::string& path, std::uint64_t rights) {
  const int place = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (place < 0) return;
  std::error_code error;
  if (!fs::is_directory(path, error)) rights &= kOfFiles;
  const PathRule rule{.allowed = rights & rules.files, .place = place};
  ::syscall(kAddRule, ruleset, kBeneath, &rule, 0U);
  ::close(place);
}

/// Beside the program lies its module of codecs, and where it is installed a folder lib.
void allowProgram(int ruleset, const Ruleset& rules) {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (error || folder == "/") return;
  allow(ruleset, rules, folder.string(), kRead);
  allow(ruleset, rules, (folder.parent_path() / "lib").string(), kRead);
}

}  // namespace

int landlockVersion() {
  const long version = ::syscall(kCreateRuleset, nullptr, 0, kAskVersion);
  return version > 0 ? static_cast<int>(version) : 0;
}

void restrictFiles(const std::vector<std::string>& readable, const std::string& cache, Programs programs) {
  const int version = landlockVersion();
  if (version == 0) return;
  const Ruleset rules = everything(version);
  const auto ruleset = static_cast<int>(::syscall(kCreateRuleset, &rules, sizeFor(version), 0U));
  if (ruleset < 0) return;
  const std::uint64_t ofSystem = programs == Programs::Installed ? kRead | kExecute : kRead;
  for (const char* place : kSystemPlaces) allow(ruleset, rules, place, ofSystem);
  for (const char* device : {"/dev/random", "/dev/urandom"}) allow(ruleset, rules, device, kRead);
  allow(ruleset, rules, "/dev/null", kReadFile | kWriteFile | kTruncate);
  allowProgram(ruleset, rules);
  for (const std::string& place : readable) allow(ruleset, rules, place, kRead);
  if (!cache.empty())
    allow(ruleset, rules, cache,
          kRead | kWriteFile | kTruncate | kMakeFile | kMakeFolder | kRemoveFile | kRemoveFolder);
  ::syscall(kRestrictSelf, ruleset, 0U);
  ::close(ruleset);
}

}  // namespace orris
