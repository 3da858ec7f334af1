#include <orris/gl/buffer.h>

#include <cassert>

#include <orris/gl/functions.h>

namespace orris::gl {

namespace {

Buffer makeBuffer(std::size_t size, const void* data, const std::string& label) {
  Buffer buffer;
  GLuint id = 0;
  CreateBuffers(1, &id);
  buffer.handle = Handle<deleteBuffer>(id);
  buffer.size = size;
  NamedBufferData(id, GLsizeiptr(size), data, GL_DYNAMIC_DRAW);
  if (!label.empty()) ObjectLabel(GL_BUFFER, id, GLsizei(label.size()), label.data());
  return buffer;
}

}  // namespace

Buffer createBuffer(std::size_t size, const void* data, const std::string& label) {
  Buffer buffer = makeBuffer(size, data, label);
  if (data == nullptr && size > 0) clearToZero(buffer);
  return buffer;
}

Buffer createUnfilledBuffer(std::size_t size, const std::string& label) {
  return makeBuffer(size, nullptr, label);
}

void upload(const Buffer& buffer, std::size_t offset, std::size_t size, const void* data) {
  assert(offset + size <= buffer.size);
  NamedBufferSubData(buffer.id(), GLintptr(offset), GLsizeiptr(size), data);
}

void clearToZero(const Buffer& buffer) {
  if (buffer.size == 0) return;
  ClearNamedBufferData(buffer.id(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
}

void read(const Buffer& buffer, std::size_t offset, std::size_t size, void* data) {
  assert(offset + size <= buffer.size);
  MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  GetNamedBufferSubData(buffer.id(), GLintptr(offset), GLsizeiptr(size), data);
}

}  // namespace orris::gl
