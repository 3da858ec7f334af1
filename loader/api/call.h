// What every function of the C interface does: checks its handles, keeps exceptions inside, has errors in words.
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>

#include <orris/core/diagnostic.h>
#include <orris/orris.h>

namespace orris::api {

/// Ends a call; thrown and caught inside the interface only.
struct Failure {
  OrrisStatus status;
  std::string text;
};
[[noreturn]] void fail(OrrisStatus status, std::string text);
/// fail() with the first error of `diagnostics`, or `otherwise` where there is none.
[[noreturn]] void fail(OrrisStatus status, const Diagnostics& diagnostics,
                       const std::string& otherwise);

/// Keeps the words for orris_last_error(); returns `status`.
OrrisStatus noteFailure(OrrisStatus status, const char* text) noexcept;
const char* lastErrorText() noexcept;

/// Of all functions that may be entered by one thread at a time, and not from a callback. Throws a Failure.
class Entry {
 public:
  Entry();
  ~Entry();
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;
};

/// Runs the body of a function that may be called inside a draw callback.
template <typename Body>
OrrisStatus guardedInside(const Body& body) noexcept {
  try {
    body();
    return ORRIS_OK;
  } catch (const Failure& failure) {
    return noteFailure(failure.status, failure.text.c_str());
  } catch (const std::bad_alloc&) {
    return noteFailure(ORRIS_ERROR_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return noteFailure(ORRIS_ERROR_INTERNAL, error.what());
  } catch (...) {
    return noteFailure(ORRIS_ERROR_INTERNAL, "unknown exception");
  }
}

/// The body of any other function.
template <typename Body>
OrrisStatus guarded(const Body& body) noexcept {
  return guardedInside([&body] {
    const Entry entry;
    body();
  });
}

// Live handles, so that a wrong one is an error and no crash.
void enrol(const void* handle, const char* kind);
void strike(const void* handle);
bool isLive(const void* handle, const char* kind);

/// The handle as a reference; fails where it is none of its kind.
template <typename Handle>
Handle& live(Handle* handle) {
  if (!isLive(handle, Handle::kKind))
    fail(ORRIS_ERROR_HANDLE, std::string("this is no ") + Handle::kKind + ", or it was destroyed");
  return *handle;
}

/// What an argument must not be.
void refuseNull(const void* pointer, const char* name);

/// A struct that was handed in; fails where it has another size than this library's.
template <typename Struct>
const Struct& sized(const Struct* given, const char* name) {
  refuseNull(given, name);
  if (given->struct_size != sizeof(Struct))
    fail(ORRIS_ERROR_ARGUMENT, std::string(name) + "->struct_size is " +
                                   std::to_string(given->struct_size) + " and must be " +
                                   std::to_string(sizeof(Struct)) +
                                   ": call its init function, or set sizeof");
  return *given;
}

/// `defaults` into a caller's struct of `size` bytes, never more than these.
void initialise(void* target, std::size_t size, const void* defaults, std::size_t known);

}  // namespace orris::api
