#include <orris/check/workers/sandbox.h>

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <orris/check/workers/sandbox_calls.h>
#include <orris/check/workers/sandbox_files.h>

extern char** environ;

namespace orris {
namespace {

namespace fs = std::filesystem;

// The beginnings of the names of variables that a worker keeps.
constexpr std::array<std::string_view, 14> kKeptVariables = {
    "LIBGL_", "MESA_", "GALLIUM_", "GALLIVM_", "LP_",  // Mesa: which driver, threads, cache, debugging
    "EGL_", "__EGL_",                                  // which vendor's EGL
    "LD_",                                             // where libraries lie, for drivers built by hand
    "ORRIS_",                                          // tests
    "ASAN_", "UBSAN_", "LSAN_", "TSAN_",               // sanitizers
    "GLIBC_TUNABLES="};

bool isKept(std::string_view variable) {
  return std::any_of(kKeptVariables.begin(), kKeptVariables.end(),
                     [variable](std::string_view start) { return variable.starts_with(start); });
}

// /proc/self/environ shows the same memory.
void emptyEnvironment() {
  char** kept = environ;
  for (char** variable = environ; variable && *variable; ++variable) {
    if (isKept(*variable))
      *kept++ = *variable;
    else
      std::memset(*variable, 0, std::strlen(*variable));
  }
  if (kept) *kept = nullptr;
}

// In a container everything runs as root. Files of others stay readable, as far as Landlock lets them.
void dropCapabilities() {
  constexpr unsigned kKept = 1u << CAP_DAC_OVERRIDE | 1u << CAP_DAC_READ_SEARCH;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> sets{};
  if (::syscall(SYS_capget, &header, sets.data()) != 0) return;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const unsigned kept = sets[i].permitted & (i == 0 ? kKept : 0u);
    sets[i] = {.effective = kept, .permitted = kept, .inheritable = 0};
  }
  ::syscall(SYS_capset, &header, sets.data());
}

std::string environmentValue(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

void shutIn(const std::vector<std::string>& readable, const std::string& cache, Programs programs) {
  emptyEnvironment();
  dropCapabilities();
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  restrictFiles(readable, cache, programs);
  refuseCalls(programs);
}

}  // namespace

SandboxSupport sandboxSupport() {
  return {.landlock = landlockVersion(), .seccomp = canRefuseCalls()};
}

std::string prepareDriverCache() {
  const std::string disabled = environmentValue("MESA_SHADER_CACHE_DISABLE");
  if (!disabled.empty() && disabled != "0" && disabled != "false") return "";
  std::string folder = environmentValue("MESA_SHADER_CACHE_DIR");
  if (folder.empty()) {
    const std::string home = environmentValue("HOME"), caches = environmentValue("XDG_CACHE_HOME");
    if (home.empty() && caches.empty()) return "";
    folder = (caches.empty() ? home + "/.cache" : caches) + "/orris/driver";
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return "";
  ::setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
  return folder;
}

void closeOpenFiles(std::vector<int> keep) {
  const int null = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (null >= 0 && std::ranges::find(keep, STDIN_FILENO) == keep.end()) ::dup2(null, STDIN_FILENO);
  constexpr long kCloseRange = 436;
  std::ranges::sort(keep);
  unsigned first = STDERR_FILENO + 1;
  for (const int file : keep) {
    const auto own = static_cast<unsigned>(file);
    if (file < 0 || own < first) continue;
    if (own > first) ::syscall(kCloseRange, first, own - 1, 0U);
    first = own + 1;
  }
  ::syscall(kCloseRange, first, ~0U, 0U);
}

void enterSandbox(const std::vector<std::string>& readable, const std::string& cache) {
  shutIn(readable, cache, Programs::Refused);
}

void enterSandboxToRunProgram(const std::vector<std::string>& readable) {
  const std::string path = environmentValue("PATH");
  shutIn(readable, "", Programs::Installed);
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace orris
