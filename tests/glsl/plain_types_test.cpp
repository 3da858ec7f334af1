#include <orris/glsl/compile/plain_types.h>

#include <gtest/gtest.h>


namespace orris {
namespace {

TEST(PlainTypes, are_those_of_the_language) {
  EXPECT_EQ(withPlainTypes("'=' :  cannot convert from ' const 3-component vector of float' to ' temp float'"),
            "'=' :  cannot convert from 'vec3' to 'float'");
  EXPECT_EQ(withPlainTypes("of type ' const 4-element array of 2-component vector of int' and"),
            "of type 'ivec2[4]' and");
  EXPECT_EQ(withPlainTypes("' uniform 4X4 matrix of float', ' in 3X4 matrix of double'"),
            "'mat4', 'dmat3x4'");
  EXPECT_EQ(withPlainTypes("' layout( location=0) smooth out 4-component vector of bool'"), "'bvec4'");
  EXPECT_EQ(withPlainTypes("' uniform highp sampler2D'"), "'sampler2D'");
}

TEST(PlainTypes, what_is_no_type_stays) {
  for (const char* message : {"'in' : not supported", "'foo' : undeclared identifier", "it's one quote",
                              "' structure{ global float x} S'", "' 3-component vector of colour'", "''", ""})
    EXPECT_EQ(withPlainTypes(message), message);
}

TEST(PlainTypes, an_assignment_is_its_sign) {
  EXPECT_EQ(withPlainTypes("'assign' :  cannot convert from ' const float' to ' out int'"),
            "'=' :  cannot convert from 'float' to 'int'");
}

}  // namespace
}  // namespace orris
