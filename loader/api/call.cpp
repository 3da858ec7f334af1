#include <orris/api/call.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>
#include <map>
#include <mutex>

namespace orris::api {
namespace {

thread_local std::string lastError;
std::atomic<bool> isEntered = false;

struct Register {
  std::mutex mutex;
  std::map<const void*, const char*> kinds;
};
/// Never destroyed: handles may outlive what ends with the process.
Register& handleRegister() {
  static auto* handles = new Register;
  return *handles;
}

}  // namespace

void fail(OrrisStatus status, std::string text) { throw Failure{status, std::move(text)}; }

void fail(OrrisStatus status, const Diagnostics& diagnostics, const std::string& otherwise) {
  for (const Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == Severity::Error) fail(status, formatDiagnostic(diagnostic));
  fail(status, otherwise);
}

OrrisStatus noteFailure(OrrisStatus status, const char* text) noexcept {
  try {
    lastError = text;
  } catch (...) {
    lastError.clear();  // no memory for the words
  }
  return status;
}

const char* lastErrorText() noexcept { return lastError.c_str(); }

Entry::Entry() {
  if (isEntered.exchange(true))
    fail(ORRIS_ERROR_ORDER,
         "a call of Orris is not finished, of another thread or the one that made this callback");
}
Entry::~Entry() { isEntered = false; }

void enrol(const void* handle, const char* kind) {
  Register& handles = handleRegister();
  const std::lock_guard lock(handles.mutex);
  handles.kinds[handle] = kind;
}

void strike(const void* handle) {
  Register& handles = handleRegister();
  const std::lock_guard lock(handles.mutex);
  handles.kinds.erase(handle);
}

bool isLive(const void* handle, const char* kind) {
  Register& handles = handleRegister();
  const std::lock_guard lock(handles.mutex);
  const auto found = handles.kinds.find(handle);
  return found != handles.kinds.end() && std::strcmp(found->second, kind) == 0;
}

void refuseNull(const void* pointer, const char* name) {
  if (pointer == nullptr) fail(ORRIS_ERROR_ARGUMENT, std::string(name) + " is NULL");
}

void initialise(void* target, std::size_t size, const void* defaults, std::size_t known) {
  std::memset(target, 0, size);
  std::memcpy(target, defaults, std::min(size, known));
  const auto structSize = static_cast<std::uint32_t>(size);
  if (size >= sizeof(structSize)) std::memcpy(target, &structSize, sizeof(structSize));
}

}  // namespace orris::api

using namespace orris::api;

uint32_t orris_api_version(void) { return ORRIS_API_VERSION; }

const char* orris_version(void) { return ORRIS_VERSION; }

const char* orris_status_name(OrrisStatus status) {
  static constexpr const char* kNames[] = {
      "ORRIS_OK",           "ORRIS_ERROR_ARGUMENT", "ORRIS_ERROR_HANDLE", "ORRIS_ERROR_CONTEXT",
      "ORRIS_ERROR_PACK",   "ORRIS_ERROR_WORLD",    "ORRIS_ERROR_ORDER",  "ORRIS_ERROR_NOT_FOUND",
      "ORRIS_ERROR_MEMORY", "ORRIS_ERROR_INTERNAL"};
  const auto index = static_cast<unsigned>(status);
  return index < std::size(kNames) ? kNames[index] : "unknown";
}

const char* orris_last_error(void) { return lastErrorText(); }
