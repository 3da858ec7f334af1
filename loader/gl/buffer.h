// A buffer object that knows its size.
#pragma once

#include <cstddef>
#include <string>

#include <orris/gl/handle.h>

namespace orris::gl {

struct Buffer {
  Handle<deleteBuffer> handle;
  std::size_t size = 0;  ///< bytes
  unsigned id() const { return handle.id(); }
};

/// `data` may be null: then the buffer holds zeros. `size` 0 makes a valid empty buffer. `label` is
/// the object label ("bufferObject.0").
Buffer createBuffer(std::size_t size, const void* data, const std::string& label);
/// The same with any bytes in it, for what is uploaded in parts.
Buffer createUnfilledBuffer(std::size_t size, const std::string& label);
/// `offset + size` must be within the buffer.
void upload(const Buffer& buffer, std::size_t offset, std::size_t size, const void* data);
void clearToZero(const Buffer& buffer);
/// Copies `size` bytes from `offset` into `data`; waits for the commands that write them.
void read(const Buffer& buffer, std::size_t offset, std::size_t size, void* data);

}  // namespace orris::gl
