// Ownership of a GL object name.
#pragma once

#include <utility>

namespace orris::gl {

/// Move-only; the moved-from id is 0. `Delete` must be called with the owning context current.
template <void (*Delete)(unsigned)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(unsigned id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    Handle old(std::exchange(id_, std::exchange(other.id_, 0)));
    return *this;
  }
  ~Handle() {
    if (id_ != 0) Delete(id_);
  }
  unsigned id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  unsigned id_ = 0;
};

void deleteTexture(unsigned id);
void deleteFramebuffer(unsigned id);
void deleteBuffer(unsigned id);
void deleteVertexArray(unsigned id);
void deleteProgram(unsigned id);
void deleteShader(unsigned id);
void deleteQuery(unsigned id);
void deleteSampler(unsigned id);

}  // namespace orris::gl
