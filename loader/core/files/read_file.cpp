#include <orris/core/files/read_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>

namespace orris {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> refuseFile(ReadFault why, ReadFault& fault) {
  fault = why;
  return std::nullopt;
}

std::optional<std::string> readAll(int file, std::size_t limit, ReadFault& fault) {
  std::string bytes;
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t got = ::read(file, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return refuseFile(ReadFault::Unreadable, fault);
    if (got == 0) return bytes;
    bytes.append(block.data(), static_cast<std::size_t>(got));
    // The file may have grown, and what /proc shows has no size.
    if (bytes.size() > limit) return refuseFile(ReadFault::TooLarge, fault);
  }
}

bool isBelowDev(const std::string& path) { return path.starts_with("/dev/"); }

FileOpener openedElsewhere;

int openToRead(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | flags);
  return file < 0 && errno == EACCES && openedElsewhere ? openedElsewhere(path) : file;
}

std::optional<std::string> readOpened(const std::string& path, int flags, bool any,
                                      std::size_t limit, ReadFault& fault) {
  const int file = openToRead(path, flags);
  if (file < 0) {
    const bool missing = errno == ENOENT || errno == ENOTDIR;
    return refuseFile(missing ? ReadFault::Missing : ReadFault::Unreadable, fault);
  }
  struct stat facts {};
  const bool known = ::fstat(file, &facts) == 0;
  std::optional<std::string> bytes;
  if (!known || !(S_ISREG(facts.st_mode) || (any && !S_ISDIR(facts.st_mode))))
    fault = ReadFault::NoFile;
  else if (S_ISREG(facts.st_mode) && static_cast<std::size_t>(facts.st_size) > limit)
    fault = ReadFault::TooLarge;
  else
    bytes = readAll(file, limit, fault);
  ::close(file);
  return bytes;
}

/// What of `place` lies behind `root`, both without links: "/a/b", or "" for `root` itself; nullopt if it lies elsewhere.
std::optional<std::string> restBelow(const std::string& root, const std::string& place) {
  const std::size_t length = root == "/" ? 0 : root.size();
  const bool below = place.starts_with(root) && (place.size() == length || place[length] == '/');
  return below ? std::optional(place.substr(length)) : std::nullopt;
}

std::optional<std::string> resolvedBelow(const std::string& folder, const std::string& path) {
  std::error_code missing, lost;
  const fs::path root = fs::canonical(folder, missing), place = fs::canonical(path, lost);
  return missing || lost ? std::nullopt : restBelow(root.native(), place.native());
}

bool hasHiddenPart(const fs::path& path) {
  return std::ranges::any_of(path, [](const fs::path& part) { return isHiddenName(part.native()); });
}

}  // namespace

const char* describe(ReadFault fault) {
  switch (fault) {
    case ReadFault::Missing:
      return "cannot be read: there is no such file";
    case ReadFault::NoFile:
      return "is a folder, device or pipe, not a file";
    case ReadFault::TooLarge:
      return "is too large";
    case ReadFault::Outside:
      return "is a symbolic link that leads out of its folder; it is not followed";
    case ReadFault::Hidden:
      return "is hidden or lies in a hidden folder; such files are not read";
    case ReadFault::Unreadable:
      break;
  }
  return "cannot be read";
}

std::optional<std::string> readFile(const std::string& path, std::size_t limit, ReadFault& fault) {
  const bool any = isBelowDev(path);
  return readOpened(path, any ? 0 : O_NONBLOCK, any, limit, fault);
}

std::optional<std::string> readQuotedFile(const std::string& path, std::size_t limit, ReadFault& fault) {
  std::error_code error;
  if (isBelowDev(path) || !fs::is_symlink(path, error)) return readFile(path, limit, fault);
  const fs::path folder = fs::path(path).parent_path();
  return readFileBelow(folder.empty() ? "." : folder.string(), fs::path(path).filename(), limit, fault);
}

std::optional<std::string> readFileBelow(const std::string& folder, const std::string& path,
                                         std::size_t limit, ReadFault& fault) {
  std::error_code error;
  const fs::path named = fs::path(folder) / path;
  if (fs::symlink_status(named, error).type() == fs::file_type::not_found)
    return refuseFile(ReadFault::Missing, fault);
  // Resolved once: each time costs a system call for every folder above.
  const fs::path file = fs::canonical(named, error);
  const auto inside = error ? std::nullopt : restBelow(fs::canonical(folder, error).native(), file.native());
  if (error || !inside) return refuseFile(ReadFault::Outside, fault);
  if (hasHiddenPart(*inside)) return refuseFile(ReadFault::Hidden, fault);
  return readOpened(file.string(), O_NONBLOCK | O_NOFOLLOW, false, limit, fault);
}

void openFilesBy(FileOpener opener) { openedElsewhere = std::move(opener); }

bool liesBelow(const std::string& folder, const std::string& path) { return resolvedBelow(folder, path).has_value(); }

bool isHiddenName(std::string_view name) { return name.starts_with('.'); }

bool isHiddenBelow(const std::string& folder, const std::string& path) {
  const auto inside = resolvedBelow(folder, path);
  return !inside || hasHiddenPart(*inside);
}

}  // namespace orris
