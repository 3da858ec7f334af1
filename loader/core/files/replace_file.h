// Writing a file whole or not at all, and never through a link or onto a device.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>

namespace orris {

/// Why no file can be written at `path`, to be put behind its name; "" when one can. What is there must
/// be a regular file or nothing: a link that somebody left is not written through, nor one on the way to it below the
/// current folder, a device not replaced.
std::string outputProblem(const std::string& path);

/// Lets `write` fill a file beside `path` and then puts that in its place, so that whoever reads sees
/// the old file or the whole new one, also after a loss of power. `write` gets the path to fill, an empty
/// file of a random name, and returns whether it could. On an error nothing is left beside `path`, and
/// what was there stays; io_error when `write` failed, not_supported for an outputProblem().
std::error_code replaceFile(const std::string& path,
                            const std::function<bool(const std::string& partial)>& write);

/// The same for bytes at hand.
std::error_code replaceFile(const std::string& path, std::string_view bytes);

/// Has a file the name of one that replaceFile() lets be filled, which is there for a moment?
bool isPartial(const std::filesystem::path& file);

/// Fills the file that replaceFile() gives to `write`; false: it could not.
bool writePartial(const std::string& partial, std::string_view bytes);

/// Puts what the open file `bytes` holds at `path`.
using FileReplacer = std::function<std::error_code(const std::string& path, int bytes)>;

/// For a process that may not write: from now on replaceFile() fills a file that is only in memory and
/// hands it to `replacer`, which asks another process to do the rest. An empty one ends that.
void replaceFilesBy(FileReplacer replacer);

}  // namespace orris
