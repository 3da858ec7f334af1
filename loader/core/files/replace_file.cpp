#include <orris/core/files/replace_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPartialBegin = ".orris-", kPartialEnd = ".partial";

std::error_code lastError() { return {errno, std::generic_category()}; }

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The first folder on the way to a file that a symbolic link stands for, below the current one: what is checked out there
/// is not ours. "" for none; links of the machine's own (/tmp, /var/run) are above it, or elsewhere.
std::string linkOnTheWay(const fs::path& path) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  // Not made normal: of "out/../file" the system follows out first.
  const fs::path inside = path.is_absolute() ? path.lexically_relative(here) : path;
  if (error || inside.empty() || *inside.begin() == "..") return "";
  fs::path folder = here;
  for (const fs::path& part : inside.parent_path()) {
    folder /= part;
    if (part != ".." && fs::is_symlink(folder, error)) return folder.lexically_relative(here).string();
  }
  return "";
}

/// A file that nobody could have put there before, removed at the end.
class Partial {
 public:
  explicit Partial(const fs::path& folder) {
    std::uint64_t number = 0;
    if (::getrandom(&number, sizeof number, 0) != ssize_t(sizeof number)) {
      error_ = lastError();
      return;
    }
    path_ = (folder / fmt::format("{}{:016x}{}", kPartialBegin, number, kPartialEnd)).string();
    constexpr int kNew = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const int file = ::open(path_.c_str(), kNew, 0666);
    if (file < 0) {
      error_ = lastError();
      path_.clear();
    } else {
      ::close(file);
    }
  }
  ~Partial() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  Partial(const Partial&) = delete;
  Partial& operator=(const Partial&) = delete;

  const std::string& path() const { return path_; }
  const std::error_code& error() const { return error_; }

  std::error_code moveTo(const std::string& target) {
    const int file = ::open(path_.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) return lastError();
    const bool kept = ::fsync(file) == 0 || errno == EINVAL;  // EINVAL: a file system without it
    const std::error_code problem = kept ? std::error_code() : lastError();
    ::close(file);
    if (problem) return problem;
    if (::rename(path_.c_str(), target.c_str()) != 0) return lastError();
    path_.clear();
    return {};
  }

 private:
  std::string path_;
  std::error_code error_;
};

FileReplacer otherProcess;

/// Lets `write` fill a file that has no place on a disk.
std::error_code replaceByOther(const std::string& path,
                               const std::function<bool(const std::string&)>& write) {
  const int file = ::memfd_create("orris output", MFD_CLOEXEC);
  if (file < 0) return lastError();
  const bool filled = write(fmt::format("/proc/self/fd/{}", file));
  const std::error_code error =
      filled ? otherProcess(path, file) : std::make_error_code(std::errc::io_error);
  ::close(file);
  return error;
}

}  // namespace

std::string outputProblem(const std::string& path) {
  struct stat facts {};
  if (::lstat(path.c_str(), &facts) == 0) {
    if (S_ISLNK(facts.st_mode)) return "is a symbolic link; outputs are not written through links";
    if (S_ISDIR(facts.st_mode)) return "is a folder";
    if (!S_ISREG(facts.st_mode)) return "is a device or pipe, not a file";
  }
  if (const std::string link = linkOnTheWay(path); !link.empty())
    return fmt::format("lies behind the symbolic link {}; outputs are not written through links: name the folder itself", link);
  std::error_code error;
  const fs::path folder = folderOf(path);
  if (!fs::is_directory(folder, error)) return "cannot be written: there is no such folder";
  const bool allowed = ::access(folder.c_str(), W_OK | X_OK) == 0;
  return allowed ? "" : "cannot be written: " + lastError().message();
}

std::error_code replaceFile(const std::string& path,
                            const std::function<bool(const std::string& partial)>& write) {
  if (!outputProblem(path).empty()) return std::make_error_code(std::errc::not_supported);
  if (otherProcess) return replaceByOther(path, write);
  Partial partial(folderOf(path));
  if (partial.error()) return partial.error();
  if (!write(partial.path())) return std::make_error_code(std::errc::io_error);
  return partial.moveTo(path);
}

bool isPartial(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with(kPartialBegin) && name.ends_with(kPartialEnd);
}

bool writePartial(const std::string& path, std::string_view bytes) {
  // The name of a file in memory is a link to it.
  const int noLink = otherProcess ? 0 : O_NOFOLLOW;
  const int file = ::open(path.c_str(), O_WRONLY | noLink | O_CLOEXEC);
  if (file < 0) return false;
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) break;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return (::close(file) == 0) && bytes.empty();
}

std::error_code replaceFile(const std::string& path, std::string_view bytes) {
  return replaceFile(path, [bytes](const std::string& partial) { return writePartial(partial, bytes); });
}

void replaceFilesBy(FileReplacer replacer) { otherProcess = std::move(replacer); }

}  // namespace orris
