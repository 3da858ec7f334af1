#include <orris/pack/programs/live_check.h>

#include <gmock/gmock.h>

#include "loaded_pack.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kHead = "#version 330 compatibility\n#define A 1.0 // [0.5 1.0 2.0]\n#define N 2 // [1 2 3]\n";

/// Why A, or another option, cannot be live where the final program has this code.
std::string reasonFor(const std::string& code, const std::string& option = "A", const std::string& properties = "") {
  const Loaded loaded =
      loadFiles({{"/final.vsh", kVertex}, {"/final.fsh", kHead + code}, {"/shaders.properties", properties}});
  EXPECT_TRUE(loaded.pack) << loaded.first();
  return loaded.pack ? liveOptions(*loaded.pack).at(option) : "not loaded";
}

std::string inMain(const std::string& code) { return "void main() {\n" + code + "\n}\n"; }

TEST(LiveCheck, numbers_in_code_are_live) {
  EXPECT_EQ(reasonFor(inMain("float x = A * 2.0; gl_FragColor = vec4(x, mix(x, A, 0.5), (A), -A);")), "");
  EXPECT_EQ(reasonFor(inMain("float x = 0.0; for (int i = 0; i < N; ++i) x += 1.0;"), "N"), "");
  EXPECT_EQ(reasonFor("#define TWICE (A * 2.0)\n" + inMain("float x = TWICE;")), "");
}

TEST(LiveCheck, what_asks_for_a_constant_says_so) {
  const std::string place = " (/final.fsh:5)";
  EXPECT_EQ(reasonFor(inMain("const float x = A;")), "a constant is made of it" + place);
  EXPECT_EQ(reasonFor(inMain("float x[N];"), "N"), "it is a size or an index" + place);
  EXPECT_EQ(reasonFor(inMain("switch (3) { case N: break; }"), "N"), "it is the label of a case" + place);
  EXPECT_EQ(reasonFor("uniform sampler2D s;\n" + inMain("textureOffset(s, vec2(0.0), ivec2(N));"), "N"),
            "textureOffset() asks for constants (/final.fsh:6)");
  EXPECT_EQ(reasonFor(inMain("float x = pow(0.5, A);")), "pow() of a constant has other digits" + place);
  EXPECT_EQ(reasonFor("float x = A;\n" + inMain("")), "it stands outside of functions (/final.fsh:4)");
  EXPECT_THAT(reasonFor("layout(location = N) out vec4 color;\n" + inMain(""), "N"), StartsWith("it stands "));
  EXPECT_EQ(reasonFor("#define JOIN(a, b) a##b\n#define WRAP(a) JOIN(x_, a)\n" + inMain("float x = A; WRAP(N);"), "N"),
            "it is a part of another name (/final.fsh:7)");
}

TEST(LiveCheck, a_const_after_the_constant_is_no_matter) {
  EXPECT_EQ(reasonFor(inMain("const float x = 1.0; float y = A * x;")), "");
  EXPECT_EQ(reasonFor("float f(const in float x) { return x * A; }\n" + inMain("")), "");
}

TEST(LiveCheck, conditions_and_properties_and_kinds) {
  EXPECT_EQ(reasonFor("#if N > 1\n#endif\n" + inMain("int x = N;"), "N"), "#if asks for it in final");
  EXPECT_EQ(reasonFor("#define MORE (N > 1)\n#if MORE\n#endif\n" + inMain("int x = N;"), "N"), "#if asks for it in final");
  EXPECT_EQ(reasonFor(inMain("int x = N;"), "N", "#if N == 1\n#endif\n"), "a properties file asks for it");
  EXPECT_EQ(reasonFor(inMain("int x = N;")), "no program reads it");
  EXPECT_EQ(reasonFor("#define M 1 // [0.5 1 2]\n" + inMain("float x = M;"), "M"), "its values are not numbers of one kind");
  EXPECT_EQ(reasonFor("const float sunPathRotation = 1.0; // [0.0 1.0]\n" + inMain("float x = sunPathRotation;"),
                      "sunPathRotation"),
            "it is a const");
}

TEST(LiveCheck, a_live_option_is_a_uniform_in_the_text_and_keeps_its_value) {
  const Files files = {{"/final.vsh", kVertex},
                       {"/composite.fsh", kFragment},
                       {"/final.fsh", kHead + inMain("gl_FragColor = vec4(A, float(N), 0.0, 1.0);")}};
  const Loaded loaded = loadFiles(files, {.values = {{"A", "2.0"}}, .live = {"A"}});
  ASSERT_TRUE(loaded.pack) << loaded.first();
  const std::string& text = loaded.pack->find("final")->stages.back().text.text;
  EXPECT_THAT(text, HasSubstr("uniform float orris_live_A;"));
  EXPECT_THAT(text, HasSubstr("vec4(orris_live_A, float(2)"));
  EXPECT_EQ(loaded.pack->values.at("A"), "2.0");
  EXPECT_THAT(loaded.pack->live, ElementsAre("A"));
  // Another value of it changes no text: all programs are taken over.
  Diagnostics diagnostics;
  int rebuilt = -1;
  LoadRequest request{.values = {{"A", "0.5"}}, .live = {"A"}, .environment = standardMacros({})};
  auto again = rebuildShaderPack(*loaded.pack, request, diagnostics, &rebuilt);
  ASSERT_TRUE(again);
  EXPECT_EQ(rebuilt, 0);
  EXPECT_EQ(again->values.at("A"), "0.5");
  request.live = {};
  again = rebuildShaderPack(*again, request, diagnostics, &rebuilt);
  EXPECT_EQ(rebuilt, 1);
  EXPECT_THAT(again->find("final")->stages.back().text.text, Not(HasSubstr("orris_live_")));
}

}  // namespace
}  // namespace orris
