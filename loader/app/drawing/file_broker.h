// Files that a process writes and opens for another one, which may not: what is drawn by a driver that runs a
// stranger's program is handed over, and only the outputs of the command line are replaced.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace orris {

inline constexpr std::size_t kMostOutputBytes = std::size_t{4} << 30;  ///< of one file

/// The files of a command. No other is written or opened for the other process.
struct AllowedFiles {
  std::vector<std::string> outputs;
  std::vector<std::string> folders;  ///< outputs in and below them
  std::function<bool(const std::string&)> isOutput{};  ///< of names that are not known before
  /// To be read; what is put in their place later, too, which a sandbox takes for another file. No link may
  /// lead out of the folder of one.
  std::vector<std::string> inputs{};
};

/// Serves one request of the other end of `socket`, a SOCK_SEQPACKET pair, if there is one.
void serveFile(int socket, const AllowedFiles& allowed);

/// From now on replaceFile() of this process asks the other end of `socket`, and so does readFile() for what
/// the system refuses.
void requestFilesFrom(int socket);

}  // namespace orris
