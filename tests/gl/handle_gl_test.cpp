#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"
#include <orris/gl/handle.h>

namespace orris::gl {
namespace {

GLuint newTexture() {
  GLuint id = 0;
  CreateTextures(GL_TEXTURE_2D, 1, &id);
  return id;
}

class HandleTest : public GlTest {};

TEST_F(HandleTest, deletes_at_the_end_of_its_scope) {
  const GLuint id = newTexture();
  {
    const Handle<deleteTexture> handle(id);
    EXPECT_EQ(IsTexture(id), GL_TRUE);
  }
  EXPECT_EQ(IsTexture(id), GL_FALSE);
}

TEST_F(HandleTest, moved_from_is_empty_and_deletes_nothing) {
  const GLuint id = newTexture();
  Handle<deleteTexture> to;
  {
    Handle<deleteTexture> from(id);
    to = std::move(from);
    EXPECT_EQ(from.id(), 0u);
    EXPECT_FALSE(bool(from));
  }
  EXPECT_TRUE(bool(to));
  EXPECT_EQ(IsTexture(id), GL_TRUE);
}

TEST_F(HandleTest, assignment_deletes_what_was_held) {
  const GLuint first = newTexture();
  const GLuint second = newTexture();
  Handle<deleteTexture> handle(first);
  handle = Handle<deleteTexture>(second);
  EXPECT_EQ(IsTexture(first), GL_FALSE);
  EXPECT_EQ(handle.id(), second);
}

// Each kind is made, handed over through a move, and gone afterwards.
template <void (*Delete)(unsigned)>
void expectOwned(GLuint id, GLboolean (*isAlive)(GLuint)) {
  ASSERT_NE(id, 0u);
  {
    Handle<Delete> from(id);
    const Handle<Delete> to(std::move(from));
    EXPECT_EQ(to.id(), id);
    EXPECT_EQ(isAlive(id), GL_TRUE);
  }
  EXPECT_EQ(isAlive(id), GL_FALSE);
}

GLboolean isBuffer(GLuint id) {
  GLint size = -1;
  GetNamedBufferSubData(id, 0, 0, nullptr);
  if (GetError() != GL_NO_ERROR) return GL_FALSE;
  BindBuffer(GL_ARRAY_BUFFER, id);
  GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
  BindBuffer(GL_ARRAY_BUFFER, 0);
  return size == 0 ? GL_TRUE : GL_FALSE;
}

GLboolean isProgram(GLuint id) {
  GLint status = -1;
  GetProgramiv(id, GL_DELETE_STATUS, &status);
  return GetError() == GL_NO_ERROR && status == GL_FALSE ? GL_TRUE : GL_FALSE;
}

GLboolean isShader(GLuint id) {
  GLint status = -1;
  GetShaderiv(id, GL_DELETE_STATUS, &status);
  return GetError() == GL_NO_ERROR && status == GL_FALSE ? GL_TRUE : GL_FALSE;
}

GLboolean isVertexArray(GLuint id) {
  BindVertexArray(id);
  const bool alive = GetError() == GL_NO_ERROR;
  BindVertexArray(0);
  return alive ? GL_TRUE : GL_FALSE;
}

GLboolean isSamplerObject(GLuint id) {
  BindSampler(0, id);
  const bool alive = GetError() == GL_NO_ERROR;
  BindSampler(0, 0);
  return alive ? GL_TRUE : GL_FALSE;
}

TEST_F(HandleTest, owns_every_kind_of_object) {
  GLuint id = 0;
  expectOwned<deleteTexture>(newTexture(), IsTexture);
  CreateFramebuffers(1, &id);
  expectOwned<deleteFramebuffer>(id, IsFramebuffer);
  CreateBuffers(1, &id);
  expectOwned<deleteBuffer>(id, isBuffer);
  CreateVertexArrays(1, &id);
  expectOwned<deleteVertexArray>(id, isVertexArray);
  CreateSamplers(1, &id);
  expectOwned<deleteSampler>(id, isSamplerObject);
  expectOwned<deleteProgram>(CreateProgram(), isProgram);
  expectOwned<deleteShader>(CreateShader(GL_VERTEX_SHADER), isShader);
  context_->takeErrors();  // asking for what is gone is an error, and the point
}

}  // namespace
}  // namespace orris::gl
