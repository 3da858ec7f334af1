// Reading files whose place or content a stranger may have chosen: never more than was asked for, never
// what is no file, never outside of the folder in which they are looked for.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace orris {

/// Enough for every text that a person names: option files, baselines, logs, results.
constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20;

enum class ReadFault { Missing, Unreadable, NoFile, TooLarge, Outside, Hidden };
/// "is a folder, device or pipe", to be put behind the name of the file.
const char* describe(ReadFault fault);

/// The bytes of a regular file, at most `limit`; else nullopt and why. Never waits for a writer. Links
/// are followed. Below /dev, which no checkout can fill, pipes and devices are read, too.
std::optional<std::string> readFile(const std::string& path, std::size_t limit, ReadFault& fault);

/// The same where messages will quote what is read: if `path` is a link, it may lead neither out of its folder nor to
/// what is hidden there. A stranger may have put one where a person expects a file.
std::optional<std::string> readQuotedFile(const std::string& path, std::size_t limit, ReadFault& fault);

/// The same for `path` seen from `folder`. Neither it nor a folder of it may be a link out of `folder` or be hidden.
std::optional<std::string> readFileBelow(const std::string& folder, const std::string& path,
                                         std::size_t limit, ReadFault& fault);

/// Whether `path`, which exists, lies in `folder` after all links are resolved.
bool liesBelow(const std::string& folder, const std::string& path);

/// Is a file or folder of this name (".git") hidden? A checkout keeps tokens in one, which are not the author's.
bool isHiddenName(std::string_view name);
/// Whether `path`, which lies in `folder`, is hidden there or is in a hidden folder, after all links are resolved.
bool isHiddenBelow(const std::string& folder, const std::string& path);

/// An open file, -1: it is not to be had.
using FileOpener = std::function<int(const std::string& path)>;

/// For a process that may not: from now on files that the system refuses to open are asked of `opener`, which
/// asks another process. An empty one ends that.
void openFilesBy(FileOpener opener);

}  // namespace orris
