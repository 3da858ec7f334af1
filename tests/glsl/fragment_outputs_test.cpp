#include <orris/glsl/syntax/fragment_outputs.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

constexpr std::uint32_t kAll = ~0u;

TEST(FragmentOutputs, are_those_that_gl_FragData_is_indexed_with) {
  EXPECT_EQ(outputsOf("void main() { gl_FragData[1] = vec4(0); gl_FragData[ 3 ].a = 1.0; }"), 0b1010u);
  EXPECT_EQ(outputsOf("void main() { discard; } // gl_FragData[0]\n"), 0u);
}

TEST(FragmentOutputs, are_declared_with_a_location) {
  EXPECT_EQ(outputsOf("layout(location = 0) out vec4 a;\nlayout(location=2) out uvec4 b;\nvoid main() {}"), 0b101u);
  EXPECT_EQ(outputsOf("void split(out vec4 a) {}\nlayout(location = 1) out vec4 b;\nvoid main() {}"), 0b10u);
}

TEST(FragmentOutputs, may_be_any_where_no_number_stands) {
  EXPECT_EQ(outputsOf("void main() { gl_FragColor = vec4(0); }"), kAll);
  EXPECT_EQ(outputsOf("void main() { for (int i = 0; i < 2; ++i) gl_FragData[i] = vec4(0); }"), kAll);
  EXPECT_EQ(outputsOf("out vec4 a;\nvoid main() {}"), kAll);
  EXPECT_EQ(outputsOf("layout(location = 0) out vec4 a[2];\nvoid main() {}"), kAll);
}

}  // namespace
}  // namespace orris
