#include <orris/pack/files/extended_graph.h>

#include <gtest/gtest.h>

#include <orris/pack/shader_pack.h>

namespace orris {
namespace {

const std::string kVersion = "#version 330\n";

/// A pack whose one fragment shader includes /a.glsl from /lib.glsl.
ShaderPack loadExtended() {
  Diagnostics diagnostics;
  const std::string use = "void main() { gl_FragColor = vec4(A); }\n";
  return *loadShaderPack(
      memorySource({{"/composite.vsh", kVersion + "void main() { gl_Position = vec4(0.0); }\n"},
                    {"/composite.fsh", kVersion + "#include \"/lib.glsl\"\n" + use},
                    {"/lib.glsl", "// lib\n#include \"/a.glsl\"\n"},
                    {"/a.glsl", "const float A = 1.0;\n"},
                    {"/loop.glsl", "#include \"/lib.glsl\"\n"},
                    {"/b.glsl", "const float B = 2.0;\n#include \"/c.glsl\"\n"},
                    {"/c.glsl", "const float C = 3.0;\n"}}),
      {.environment = standardMacros({})}, diagnostics);
}

std::string fragmentWith(const AddedLine& added) {
  const ShaderPack pack = loadExtended();
  const FolderBuild& build = *pack.builds.front();
  return build.buildWith(*build.entryNamed("composite"), added).stages.back().text.text;
}

TEST(ExtendedGraph, a_file_that_nothing_includes_stands_before_the_line_with_what_it_includes) {
  const std::string text = fragmentWith({"/lib.glsl", 2, "/b.glsl"});
  const auto a = text.find("float A"), b = text.find("float B"), c = text.find("float C");
  EXPECT_LT(b, c);
  EXPECT_LT(c, a);
  EXPECT_NE(a, std::string::npos);
}

TEST(ExtendedGraph, behind_the_last_line) {
  const std::string text = fragmentWith({"/lib.glsl", 3, "/c.glsl"});
  EXPECT_LT(text.find("float A"), text.find("float C"));
  EXPECT_NE(text.find("float C"), std::string::npos);
}

TEST(ExtendedGraph, a_line_of_text_moves_the_includes_behind_it) {
  const std::string text = fragmentWith({"/lib.glsl", 2, "", "const float Z = 0.0;"});
  EXPECT_LT(text.find("float Z"), text.find("float A"));
  EXPECT_NE(text.find("float A"), std::string::npos);
}

TEST(ExtendedGraph, nothing_changes_where_a_file_would_include_itself_or_is_not_there) {
  const std::string before = fragmentWith({"/none.glsl", 1, "/b.glsl"});
  EXPECT_EQ(fragmentWith({"/lib.glsl", 1, "/loop.glsl"}), before);
  EXPECT_EQ(fragmentWith({"/lib.glsl", 1, "/lib.glsl"}), before);
  EXPECT_EQ(fragmentWith({"/lib.glsl", 99, "/b.glsl"}), before);
}

}  // namespace
}  // namespace orris
