// Files that a process writes for another one, which may not: what is drawn by a driver that runs a
// stranger's program is handed over, and only the outputs of the command line are replaced.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace orris {

inline constexpr std::size_t kMostOutputBytes = std::size_t{4} << 30;  ///< of one file

/// The outputs of a command. Nothing else is written for the other process.
struct AllowedOutputs {
  std::vector<std::string> files;
  std::vector<std::string> folders;  ///< files in and below them
};

/// Serves one request of the other end of `socket`, a SOCK_SEQPACKET pair, if there is one.
void serveOutput(int socket, const AllowedOutputs& allowed);

/// From now on replaceFile() of this process asks the other end of `socket`.
void requestOutputsFrom(int socket);

}  // namespace orris
