#include "app/drawing/output_broker.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>

#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

using ControlBlock = std::array<char, CMSG_SPACE(sizeof(int))>;

bool sendRequest(int socket, const std::string& path, int bytes) {
  alignas(cmsghdr) ControlBlock control{};
  iovec text{const_cast<char*>(path.data()), path.size()};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof bytes);
  std::memcpy(CMSG_DATA(header), &bytes, sizeof bytes);
  return ::sendmsg(socket, &message, MSG_NOSIGNAL) >= 0;
}

struct OutputRequest {
  std::string path;
  int bytes = -1;  ///< an open file
};

OutputRequest receiveRequest(int socket) {
  alignas(cmsghdr) ControlBlock control{};
  std::array<char, PATH_MAX> text;
  iovec part{text.data(), text.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t got = ::recvmsg(socket, &message, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
  OutputRequest request;
  if (got <= 0) return request;
  request.path.assign(text.data(), static_cast<std::size_t>(got));
  const cmsghdr* header = CMSG_FIRSTHDR(&message);
  if (header && header->cmsg_type == SCM_RIGHTS && header->cmsg_len == CMSG_LEN(sizeof(int)))
    std::memcpy(&request.bytes, CMSG_DATA(header), sizeof request.bytes);
  return request;
}

bool isAllowed(const std::string& path, const AllowedOutputs& allowed) {
  if (std::find(allowed.files.begin(), allowed.files.end(), path) != allowed.files.end()) return true;
  const std::string folder = fs::path(path).parent_path().string();
  return std::any_of(allowed.folders.begin(), allowed.folders.end(), [&](const std::string& outer) {
    std::error_code error;
    return fs::is_directory(folder, error) && liesBelow(outer, folder);
  });
}

/// Copies a regular file; what else the other process may have opened could keep this one waiting.
bool copyBytes(int from, const std::string& to) {
  struct stat facts {};
  if (::fstat(from, &facts) != 0 || !S_ISREG(facts.st_mode) ||
      facts.st_size > off_t(kMostOutputBytes))
    return false;
  std::string bytes(static_cast<std::size_t>(facts.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(from, bytes.data() + done, bytes.size() - done, off_t(done));
    if (got <= 0) return false;
    done += static_cast<std::size_t>(got);
  }
  return writePartial(to, bytes);
}

std::error_code writeFor(const OutputRequest& request, const AllowedOutputs& allowed) {
  if (request.bytes < 0 || !isAllowed(request.path, allowed))
    return std::make_error_code(std::errc::operation_not_permitted);
  return replaceFile(request.path, [&](const std::string& partial) {
    return copyBytes(request.bytes, partial);
  });
}

}  // namespace

void serveOutput(int socket, const AllowedOutputs& allowed) {
  const OutputRequest request = receiveRequest(socket);
  if (request.path.empty()) return;
  const int code = writeFor(request, allowed).value();
  if (request.bytes >= 0) ::close(request.bytes);
  ::send(socket, &code, sizeof code, MSG_NOSIGNAL | MSG_DONTWAIT);
}

void requestOutputsFrom(int socket) {
  replaceFilesBy([socket](const std::string& path, int bytes) -> std::error_code {
    int code = 0;
    const bool answered =
        sendRequest(socket, path, bytes) && ::recv(socket, &code, sizeof code, 0) == sizeof code;
    return {answered ? code : EIO, std::generic_category()};
  });
}

}  // namespace orris
