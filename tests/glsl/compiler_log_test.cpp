#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

const test::Files kFiles = {
    {"/a.fsh",
     "#version 450 compatibility\n#include \"/lib.glsl\"\nvoid main() { int i = foo; }\n"},
    {"/lib.glsl", "#define WRONG(x) (x + bar)\n\n\tfloat f = WRONG( 1.0);\n"}};
// The printed text: line 1 #version, 2 "float f = (1.0 + bar);", 3 "void main() { int i = foo; }".

std::string mappedLog(const std::string& log, Severity fallback = Severity::Error) {
  Diagnostics diagnostics;
  const TokenStream stream = preprocess(test::flatten(kFiles, "/a.fsh"), {}, diagnostics);
  mapDriverLog(log, fallback, {Stage::Fragment, print(stream)}, test::linesOf(kFiles), diagnostics);
  return test::format(diagnostics);
}

const std::string kFoo =
    "\n  void main() { int i = foo; }\n"
    "                        ^\n";
const std::string kBar =
    "\n"
    "  #define WRONG(x) (x + bar)\n"
    "                        ^\n"
    "  note: in the expansion of macro 'WRONG' at /lib.glsl:3\n";

TEST(compiler_log, mesa_gives_line_and_column) {
  EXPECT_EQ(mappedLog("0:3(23): error: `foo' undeclared\n"),
            "/a.fsh:3:23: error: `foo' undeclared" + kFoo);
  EXPECT_EQ(mappedLog("0:2(19): warning: `bar' used uninitialized\n"),
            "/lib.glsl:1:23: warning: `bar' used uninitialized" + kBar);
  EXPECT_EQ(mappedLog("0:3(23): preprocessor error: bad\n"), "/a.fsh:3:23: error: bad" + kFoo);
}

TEST(compiler_log, mesa_candidates_become_notes_of_their_message) {
  EXPECT_EQ(mappedLog("0:3(23): error: no matching function; candidates are:\n"
                   "0:3(23): error:    float mix(float, float)\n"
                   "0:3(23): error:    vec2 mix(vec2, vec2)\n"
                   "0:3(23): warning: type mismatch\n"),
            "/a.fsh:3:23: error: no matching function; candidates are:" + kFoo +
                "  note: float mix(float, float)\n  note: vec2 mix(vec2, vec2)\n"
                "/a.fsh:3:23: warning: type mismatch" +
                kFoo);
}

TEST(compiler_log, extensions_that_glslang_lists_become_notes_of_their_message) {
  EXPECT_EQ(mappedLog("ERROR: 0:3: 'foo' : required extension not requested: Possible extensions include:\n"
                   "GL_EXT_one\nGL_EXT_two\nERROR: 0:4: 'x' : other\n"),
            "/a.fsh:3:23: error: 'foo' : required extension not requested: Possible extensions include:" +
                kFoo + "  note: GL_EXT_one\n  note: GL_EXT_two\n" + "/a.fsh: error: 'x' : other\n"
                "  note: the place is in text added by the host\n");
}

TEST(compiler_log, errors_that_follow_on_the_same_line_are_left_out) {
  EXPECT_EQ(mappedLog("0:3(23): error: `foo' undeclared\n"
                   "0:3(15): error: could not implicitly convert error to int\n"),
            "/a.fsh:3:23: error: `foo' undeclared" + kFoo);
}

TEST(compiler_log, nvidia_gives_a_line_and_quotes_the_word) {
  EXPECT_EQ(mappedLog("0(3) : error C1503: undefined variable \"foo\"\n"),
            "/a.fsh:3:23: error: undefined variable \"foo\"" + kFoo);
  EXPECT_EQ(mappedLog("0(2) : warning C7050: \"bar\" might be used before being initialized\n"),
            "/lib.glsl:1:23: warning: \"bar\" might be used before being initialized" + kBar);
}

TEST(compiler_log, intel_and_apple_give_a_line_and_quote_the_word) {
  EXPECT_EQ(mappedLog("ERROR: 0:3: 'foo' : undeclared identifier \n"),
            "/a.fsh:3:23: error: 'foo' : undeclared identifier" + kFoo);
  EXPECT_EQ(mappedLog("WARNING: 0:2: 'bar' : x\n"), "/lib.glsl:1:23: warning: 'bar' : x" + kBar);
  EXPECT_EQ(mappedLog("ERROR: 0:3: Use of undeclared identifier 'foo'\n"),
            "/a.fsh:3:23: error: Use of undeclared identifier 'foo'" + kFoo);
}

TEST(compiler_log, amd_puts_a_number_after_the_severity) {
  EXPECT_EQ(mappedLog("Fragment shader failed to compile with the following errors:\n"
                   "ERROR: 0:3: error(#143) Undeclared identifier: foo\n"
                   "ERROR: error(#273) 1 compilation errors.  No code generated\n"),
            "/a.fsh:3: error: Undeclared identifier: foo\n  void main() { int i = foo; }\n");
}

TEST(compiler_log, headings_and_summaries_are_left_out) {
  EXPECT_EQ(mappedLog("Fragment info\n-------------\n\n0(3) : error C0000: syntax error\n"
                   "ERROR: 2 compilation errors.  No code generated.\n"),
            "/a.fsh:3: error: syntax error\n  void main() { int i = foo; }\n");
  EXPECT_EQ(mappedLog(""), "");
}

TEST(compiler_log, lines_without_a_place_become_one_message_at_the_entry_file) {
  EXPECT_EQ(mappedLog("error: vertex shader lacks `main'\nerror: unresolved reference\n"),
            "/a.fsh: error: vertex shader lacks `main'; unresolved reference\n");
  EXPECT_EQ(mappedLog("something went by\n", Severity::Warning),
            "/a.fsh: warning: something went by\n");
}

TEST(compiler_log, a_place_outside_the_author_s_text_is_put_at_the_entry_file) {
  EXPECT_EQ(mappedLog("0:99(1): error: odd\n"),
            "/a.fsh: error: odd\n  note: the place is in text added by the host\n");
}

TEST(compiler_log, a_word_is_matched_as_a_whole) {
  EXPECT_EQ(mappedLog("ERROR: 0:3: 'i' : unused\n").substr(0, 14), "/a.fsh:3:19: e");
  EXPECT_EQ(mappedLog("ERROR: 0:3: '' : syntax error\n"),
            "/a.fsh:3: error: '' : syntax error\n  void main() { int i = foo; }\n");
}

}  // namespace
}  // namespace orris
