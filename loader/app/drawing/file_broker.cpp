#include "app/drawing/file_broker.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <mutex>

#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

using ControlBlock = std::array<char, CMSG_SPACE(sizeof(int))>;

/// `file`: an open one to send along, -1: none.
bool sendWith(int socket, const void* data, std::size_t size, int file, int flags) {
  alignas(cmsghdr) ControlBlock control{};
  iovec part{const_cast<void*>(data), size};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (file < 0) return ::sendmsg(socket, &message, MSG_NOSIGNAL | flags) >= 0;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof file);
  std::memcpy(CMSG_DATA(header), &file, sizeof file);
  return ::sendmsg(socket, &message, MSG_NOSIGNAL | flags) >= 0;
}

/// The number of bytes; `file` is the one that came along, -1: none.
ssize_t receiveWith(int socket, void* data, std::size_t size, int& file, int flags) {
  alignas(cmsghdr) ControlBlock control{};
  iovec part{data, size};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  file = -1;
  const ssize_t got = ::recvmsg(socket, &message, flags | MSG_CMSG_CLOEXEC);
  const cmsghdr* header = got < 0 ? nullptr : CMSG_FIRSTHDR(&message);
  if (header && header->cmsg_type == SCM_RIGHTS && header->cmsg_len == CMSG_LEN(sizeof(int)))
    std::memcpy(&file, CMSG_DATA(header), sizeof file);
  return got;
}

/// To write, with the bytes, or to open, without.
struct FileRequest {
  std::string path;
  int bytes = -1;  ///< an open file
};

FileRequest receiveRequest(int socket) {
  std::array<char, PATH_MAX> text;
  FileRequest request;
  const ssize_t got = receiveWith(socket, text.data(), text.size(), request.bytes, MSG_DONTWAIT);
  if (got > 0) request.path.assign(text.data(), static_cast<std::size_t>(got));
  return request;
}

bool isIn(const std::vector<std::string>& paths, const std::string& path) {
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}

bool mayWrite(const std::string& path, const AllowedFiles& allowed) {
  if (isIn(allowed.outputs, path) || (allowed.isOutput && allowed.isOutput(path))) return true;
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

std::error_code writeFor(const FileRequest& request, const AllowedFiles& allowed) {
  if (!mayWrite(request.path, allowed))
    return std::make_error_code(std::errc::operation_not_permitted);
  return replaceFile(request.path, [&](const std::string& partial) {
    return copyBytes(request.bytes, partial);
  });
}

int openFor(const std::string& path, const AllowedFiles& allowed) {
  const std::string folder = fs::path(path).parent_path().string();
  if (!isIn(allowed.inputs, path) || !liesBelow(folder.empty() ? "." : folder, path)) return -1;
  return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

/// What came of a request to the other end of `socket`; `file` comes along or goes along, -1: none.
int askOther(int socket, const std::string& path, int& file) {
  int code = 0, own = file;
  if (!sendWith(socket, path.data(), path.size(), own, 0)) return EIO;
  return receiveWith(socket, &code, sizeof code, file, 0) == sizeof code ? code : EIO;
}

// Files are written by one thread and read by others.
std::mutex askedMutex;

}  // namespace

void serveFile(int socket, const AllowedFiles& allowed) {
  const FileRequest request = receiveRequest(socket);
  if (request.path.empty()) return;
  const bool writes = request.bytes >= 0;
  const int opened = writes ? -1 : openFor(request.path, allowed);
  const int code = writes ? writeFor(request, allowed).value() : opened < 0 ? EACCES : 0;
  sendWith(socket, &code, sizeof code, opened, MSG_DONTWAIT);
  for (const int file : {request.bytes, opened})
    if (file >= 0) ::close(file);
}

void requestFilesFrom(int socket) {
  replaceFilesBy([socket](const std::string& path, int bytes) -> std::error_code {
    const std::lock_guard lock(askedMutex);
    return {askOther(socket, path, bytes), std::generic_category()};
  });
  openFilesBy([socket](const std::string& path) {
    const std::lock_guard lock(askedMutex);
    int file = -1;
    errno = askOther(socket, path, file);
    return file;
  });
}

}  // namespace orris
