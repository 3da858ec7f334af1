#include <orris/glsl/tokens/shape.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

std::uint64_t shape(const std::string& text) {
  TokenStream stream;
  stream.version = 330;
  stream.tokens = tokenize(text);
  return shapeOf(stream, Stage::Fragment);
}

/// `text` with `first` and with `second` in place of N.
bool alike(const std::string& text, const std::string& first, const std::string& second) {
  const auto with = [&](const std::string& value) {
    std::string result = text;
    result.replace(result.find('N'), 1, value);
    return result;
  };
  return shape(with(first)) == shape(with(second));
}

TEST(Shape, numbers_in_expressions_count_by_kind) {
  EXPECT_TRUE(alike("void main() { x = pow(y, N); }", "0.5", "12.25"));
  EXPECT_TRUE(alike("float x = 2.0 * -N;", ".5", "1."));
  EXPECT_TRUE(alike("for (int i = 0; i < N; i++) {}", "4", "16"));
  EXPECT_TRUE(alike("void main() { x = a ? b : N; }", "1.0", "2.0"));
  EXPECT_TRUE(alike("const float a = 1.0; float b = N;", "1.0", "2.0"));
  EXPECT_TRUE(alike("void main() { int a[2]; x = N; }", "1.0", "2.0"));
}

TEST(Shape, kinds_differ) {
  for (const char* other : {"1", "1u", "0", "1.0f", "1.0lf", "1e3", "0x1", "x", "-1.0"}) {
    EXPECT_FALSE(alike("void main() { x = N; }", "1.0", other)) << other;
  }
  EXPECT_FALSE(alike("void main() { x = 7 / N; }", "0", "2"));
  EXPECT_FALSE(alike("void main() { x = N; }", "7", "08"));
  EXPECT_FALSE(alike("void main() { x = N; }", "7", "9999999999"));
}

TEST(Shape, numbers_that_constant_expressions_may_need_count_with_their_value) {
  for (const char* text :
       {"float a[N];", "void main() { x = v[N]; }", "void main() { x = v[int(y) + (N)]; }",
        "const int n = N;", "void main() { const int n = 2 * (1 + N); float a[n]; }",
        "const int n[] = {1, N};", "const int n[2][2] = {{1, 2}, {3, N}};",
        "layout(location = N) out vec4 c;", "layout (local_size_x = N) in;",
        "void main() { switch (x) { case 1 + N: break; } }",
        "void main() { x = textureGather(s, p, N); }",
        "void main() { x = textureLodOffset(s, p, 0, ivec2(0, N)); }",
        "void main() { f(N > 1 ? a : b); }", "void main() { f(a ? N : (N2 ? 2 : b)); }"}) {
    EXPECT_FALSE(alike(text, "3", "4")) << text;
  }
}

TEST(Shape, a_number_that_runs_together_with_its_neighbour_counts_with_its_value) {
  EXPECT_TRUE(alike("float x = N .0;", "1", "2"));
  TokenStream stream;
  stream.tokens = tokenize("float x = 1 .0;");
  stream.tokens[4].spaceBefore = false;
  TokenStream other = stream;
  other.tokens[3].text = "2";
  EXPECT_NE(shapeOf(stream, Stage::Fragment), shapeOf(other, Stage::Fragment));
}

TEST(Shape, every_other_token_the_version_and_the_stage_count) {
  const std::uint64_t base = shape("void main() { x = 1.0; }");
  EXPECT_NE(base, shape("void main() { y = 1.0; }"));
  EXPECT_NE(base, shape("void main() { x = 1.0; /* RENDERTARGETS: 1 */ }"));
  EXPECT_EQ(base, shape("void main(){\n  x=1.0;\n}"));
  TokenStream stream;
  stream.version = 330;
  stream.tokens = tokenize("void main() { x = 1.0; }");
  EXPECT_EQ(base, shapeOf(stream, Stage::Fragment));
  EXPECT_NE(base, shapeOf(stream, Stage::Vertex));
  stream.version = 120;
  EXPECT_NE(base, shapeOf(stream, Stage::Fragment));
}

}  // namespace
}  // namespace orris
