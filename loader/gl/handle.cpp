#include <orris/gl/handle.h>

#include <orris/gl/functions.h>

namespace orris::gl {

void deleteTexture(unsigned id) { DeleteTextures(1, &id); }
void deleteFramebuffer(unsigned id) { DeleteFramebuffers(1, &id); }
void deleteBuffer(unsigned id) { DeleteBuffers(1, &id); }
void deleteVertexArray(unsigned id) { DeleteVertexArrays(1, &id); }
void deleteProgram(unsigned id) { DeleteProgram(id); }
void deleteShader(unsigned id) { DeleteShader(id); }
void deleteQuery(unsigned id) { DeleteQueries(1, &id); }
void deleteSampler(unsigned id) { DeleteSamplers(1, &id); }

}  // namespace orris::gl
