/* The voxel engine's own GL context, which happens to be without a window: OSMesa, and the GL functions that
 * the engine itself calls. */
#ifndef VOXELS_WINDOW_H
#define VOXELS_WINDOW_H

#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>

typedef void (*PFNENGINETEXIMAGE2DPROC)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum,
                                        const void*);
typedef void (*PFNENGINETEXPARAMETERIPROC)(GLenum, GLenum, GLint);
typedef void (*PFNENGINEREADPIXELSPROC)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*);
typedef GLenum (*PFNENGINEGETERRORPROC)(void);
typedef void (*PFNENGINEDRAWARRAYSPROC)(GLenum, GLint, GLsizei);
typedef void (*PFNENGINEGENTEXTURESPROC)(GLsizei, GLuint*);
typedef void (*PFNENGINEBINDTEXTUREPROC)(GLenum, GLuint);

/* Name without the prefix and type of the pointer. */
#define ENGINE_GL(X)                                   \
  X(GenBuffers, PFNGLGENBUFFERSPROC)                   \
  X(BindBuffer, PFNGLBINDBUFFERPROC)                   \
  X(BufferData, PFNGLBUFFERDATAPROC)                   \
  X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)         \
  X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)         \
  X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)         \
  X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)         \
  X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC) \
  X(GenerateMipmap, PFNGLGENERATEMIPMAPPROC)           \
  X(DrawArrays, PFNENGINEDRAWARRAYSPROC)               \
  X(GenTextures, PFNENGINEGENTEXTURESPROC)             \
  X(BindTexture, PFNENGINEBINDTEXTUREPROC)             \
  X(TexImage2D, PFNENGINETEXIMAGE2DPROC)               \
  X(TexParameteri, PFNENGINETEXPARAMETERIPROC)         \
  X(ReadPixels, PFNENGINEREADPIXELSPROC)               \
  X(GetError, PFNENGINEGETERRORPROC)

typedef struct EngineGl {
#define X(name, type) type name;
  ENGINE_GL(X)
#undef X
} EngineGl;
extern EngineGl gl;

/** Makes the context and finds the functions; 0 when there is none. */
int open_window(void);
/** Address of a GL function; `user` is not used. */
void* engine_proc_address(const char* name, void* user);

#endif
