#include <dlfcn.h>

#include <cstdlib>

#include <orris/gl/context.h>
#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"

namespace orris::gl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::unique_ptr<Context> tryContext(Backend backend, Diagnostics& diagnostics) {
  ContextRequest request;
  request.backend = backend;
  request.width = request.height = 16;
  request.visible = false;
  return createContext(request, diagnostics);
}

TEST(BackendNames, parse_and_print_agree) {
  for (const Backend backend : {Backend::Auto, Backend::OSMesa, Backend::Egl, Backend::Glfw}) {
    EXPECT_EQ(parseBackend(backendName(backend)), backend);
  }
}

TEST(BackendNames, unknown_name_is_refused) {
  EXPECT_EQ(parseBackend("vulkan"), std::nullopt);
  EXPECT_EQ(parseBackend("OSMesa"), std::nullopt);
  EXPECT_EQ(parseBackend(""), std::nullopt);
}

TEST(CreateContext, auto_gives_a_compatibility_context) {
  Diagnostics diagnostics;
  const auto context = tryContext(Backend::Auto, diagnostics);
  ASSERT_NE(context, nullptr);
  EXPECT_THAT(diagnostics, IsEmpty());
  EXPECT_GE(context->driver().glVersion, 430);
  EXPECT_GE(context->driver().maxDrawBuffers, 8);
  EXPECT_GE(context->driver().maxTextureUnits, 32);
  EXPECT_GE(context->driver().maxTextureSize, 4096);
  EXPECT_FALSE(context->driver().renderer.empty());
  EXPECT_FALSE(context->driver().extensions.empty());
  EXPECT_EQ(context->window(), nullptr);
  GLint profile = 0;
  GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_EQ(profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT, GL_CONTEXT_COMPATIBILITY_PROFILE_BIT);
}

TEST(CreateContext, backends_follow_one_another_in_one_process) {
  for (const Backend backend : {Backend::OSMesa, Backend::Egl, Backend::OSMesa, Backend::Egl}) {
    Diagnostics diagnostics;
    const auto context = tryContext(backend, diagnostics);
    if (context == nullptr) GTEST_SKIP() << diagnostics.front().message;
    EXPECT_EQ(context->backend(), backend);
    EXPECT_GE(context->driver().glVersion, 430);
    ClearColor(0, 0, 0, 0);
    EXPECT_THAT(context->takeErrors(), IsEmpty());
  }
}

TEST(CreateContext, core_can_be_asked_for) {
  for (const Backend backend : {Backend::OSMesa, Backend::Egl}) {
    ContextRequest request;
    request.backend = backend;
    request.profile = ContextProfile::Core;
    Diagnostics diagnostics;
    const auto context = createContext(request, diagnostics);
    if (context == nullptr) GTEST_SKIP() << diagnostics.front().message;
    EXPECT_TRUE(context->driver().coreProfile);
    EXPECT_TRUE(isCoreProfile());
    EXPECT_THAT(context->takeErrors(), IsEmpty());
  }
  Diagnostics diagnostics;
  const auto other = tryContext(Backend::Auto, diagnostics);
  EXPECT_FALSE(isCoreProfile());
}

// An engine has a context of its own, which stays when Orris is done with it.
TEST(UseCurrentContext, takes_the_profile_of_what_is_current) {
  ContextRequest request;
  request.profile = ContextProfile::Core;
  Diagnostics diagnostics;
  const auto engine = createContext(request, diagnostics);
  ASSERT_NE(engine, nullptr);
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW);
  if (engine->backend() != Backend::OSMesa || library == nullptr) GTEST_SKIP() << "no OSMesa here";
  using Find = void* (*)(const char*);
  const auto find = reinterpret_cast<Find>(dlsym(library, "OSMesaGetProcAddress"));
  {
    const auto context = useCurrentContext(find, diagnostics);
    ASSERT_NE(context, nullptr);
    EXPECT_TRUE(context->driver().coreProfile);
    EXPECT_EQ(context->driver().renderer, engine->driver().renderer);
  }
  EXPECT_THAT(engine->takeErrors(), IsEmpty());
}

unsigned guiltyReset() { return GL_GUILTY_CONTEXT_RESET; }

TEST(UseCurrentContext, a_reset_of_the_gpu_is_an_error) {
  Diagnostics diagnostics;
  const auto engine = createContext({}, diagnostics);
  ASSERT_NE(engine, nullptr);
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW);
  if (engine->backend() != Backend::OSMesa || library == nullptr) GTEST_SKIP() << "no OSMesa here";
  const auto find = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "OSMesaGetProcAddress"));
  const auto context = useCurrentContext(
      [find](const char* name) {
        return std::string_view(name) == "glGetGraphicsResetStatus" ? reinterpret_cast<void*>(guiltyReset) : find(name);
      },
      diagnostics);
  ASSERT_NE(context, nullptr);
  EXPECT_THAT(context->takeErrors(),
              ElementsAre("the GPU was reset and the context is lost: a program ran too long, or read or wrote where it "
                          "has no memory"));
}

TEST(CreateContext, missing_osmesa_names_the_library_and_the_other_backend) {
  ContextRequest request;
  request.backend = Backend::OSMesa;
  request.osmesaLibraries = {"libNoMesa.so.8", "libNoMesa.so.6"};
  Diagnostics diagnostics;
  EXPECT_EQ(createContext(request, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message, "cannot load OSMesa (tried libNoMesa.so.8, libNoMesa.so.6)");
  EXPECT_EQ(diagnostics[0].hint,
            "install libosmesa6 where the system still has it, or run with --backend egl");
}

TEST(CreateContext, missing_egl_names_the_library_and_the_other_backend) {
  ContextRequest request;
  request.backend = Backend::Egl;
  request.eglLibraries = {"libNoEGL.so.1"};
  Diagnostics diagnostics;
  EXPECT_EQ(createContext(request, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message, "cannot load EGL (tried libNoEGL.so.1)");
  EXPECT_EQ(diagnostics[0].hint, "install libegl1 with libegl-mesa0, or run with --backend osmesa");
}

TEST(CreateContext, library_that_is_not_osmesa_is_no_crash) {
  ContextRequest request;
  request.backend = Backend::OSMesa;
  request.osmesaLibraries = {"libm.so.6"};
  Diagnostics diagnostics;
  EXPECT_EQ(createContext(request, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "gl-library-missing");
}

TEST(CreateContext, auto_falls_back_to_egl_without_a_word) {
  ContextRequest request;
  request.osmesaLibraries = {"libNoMesa.so.8"};
  Diagnostics diagnostics;
  const auto context = createContext(request, diagnostics);
  if (context == nullptr) GTEST_SKIP() << "no EGL here: " << diagnostics.front().message;
  EXPECT_EQ(context->backend(), Backend::Egl);
  EXPECT_THAT(diagnostics, IsEmpty());
}

TEST(CreateContext, auto_without_any_library_is_one_message) {
  ContextRequest request;
  request.osmesaLibraries = {"libNoMesa.so.8"};
  request.eglLibraries = {"libNoEGL.so.1"};
  Diagnostics diagnostics;
  EXPECT_EQ(createContext(request, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message,
            "no way to draw without a display: neither OSMesa nor EGL gave a context");
  EXPECT_THAT(diagnostics[0].notes, ElementsAre("cannot load OSMesa (tried libNoMesa.so.8)",
                                                "cannot load EGL (tried libNoEGL.so.1)"));
  EXPECT_EQ(diagnostics[0].hint,
            "install libosmesa6, or libegl1 with libegl-mesa0 and libgl1-mesa-dri");
}

TEST(CreateContext, window_without_a_display_is_one_message) {
  const char* display = std::getenv("DISPLAY");
  const std::string saved = display == nullptr ? "" : display;
  setenv("DISPLAY", ":4093", 1);
  unsetenv("WAYLAND_DISPLAY");
  Diagnostics diagnostics;
  EXPECT_EQ(tryContext(Backend::Glfw, diagnostics), nullptr);
  display == nullptr ? unsetenv("DISPLAY") : setenv("DISPLAY", saved.c_str(), 1);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "gl-no-window");
  EXPECT_THAT(diagnostics[0].message, HasSubstr("cannot start GLFW: X11"));
  EXPECT_EQ(diagnostics[0].hint,
            "a display is needed: set DISPLAY, or run under xvfb-run, or draw without a window "
            "with --backend osmesa or egl");
}

TEST(CreateContext, window_is_made_where_there_is_a_display) {
  if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "needs a display, DISPLAY is not set";
  for (int i = 0; i < 2; ++i) {
    Diagnostics diagnostics;
    const auto context = tryContext(Backend::Glfw, diagnostics);
    ASSERT_NE(context, nullptr) << diagnostics.front().message;
    EXPECT_NE(context->window(), nullptr);
    EXPECT_THAT(context->takeErrors(), IsEmpty());
  }
}

class ErrorsTest : public GlTest {};

TEST_F(ErrorsTest, are_reported_once_and_then_forgotten) {
  Enable(0xBAD);
  Enable(0xBAD);
  EXPECT_THAT(context_->takeErrors(), SizeIs(1));
  EXPECT_THAT(context_->takeErrors(), IsEmpty());
}

TEST_F(ErrorsTest, of_different_calls_are_all_reported) {
  Enable(0xBAD);
  BindTexture(GL_TEXTURE_2D, 12345678);
  UseProgram(4711);
  EXPECT_GE(context_->takeErrors().size(), 2u);
}

TEST_F(ErrorsTest, without_debug_output_come_by_number) {
  Disable(GL_DEBUG_OUTPUT);
  Enable(0xBAD);
  EXPECT_THAT(context_->takeErrors(), ElementsAre("GL_INVALID_ENUM"));
}

TEST_F(ErrorsTest, of_low_severity_are_not_reported) {
  DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_PERFORMANCE, 1,
                     GL_DEBUG_SEVERITY_LOW, -1, "slow");
  EXPECT_THAT(context_->takeErrors(), IsEmpty());
  DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 1, GL_DEBUG_SEVERITY_HIGH,
                     -1, "wrong");
  EXPECT_THAT(context_->takeErrors(), ElementsAre("wrong"));
}

TEST_F(ErrorsTest, of_a_shader_are_left_to_its_log) {
  const GLuint shader = CreateShader(GL_FRAGMENT_SHADER);
  const char* text = "#version 330\nbroken";
  ShaderSource(shader, 1, &text, nullptr);
  CompileShader(shader);
  DeleteShader(shader);
  EXPECT_THAT(context_->takeErrors(), IsEmpty());
}

}  // namespace
}  // namespace orris::gl
