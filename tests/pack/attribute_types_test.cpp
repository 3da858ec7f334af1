#include <orris/pack/programs/attribute_types.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> refused(const std::string& text, IrisPatch patch) {
  TokenStream stream;
  stream.sites.push_back({"/a.vsh"});
  stream.tokens = tokenize(text);
  for (Token& token : stream.tokens) token.origin.site = 0;
  Diagnostics diagnostics;
  checkAttributeTypes(stream, {.patch = patch}, diagnostics);
  std::vector<std::string> found;
  for (const Diagnostic& d : diagnostics) {
    EXPECT_EQ(d.effect, Effect::RefusesProgram);
    found.push_back(std::to_string(d.at.line) + ":" + std::to_string(d.at.column) + " " +
                    d.message);
  }
  return found;
}

// Iris 1.11.2 itself refuses each of these, and takes those of the test below.
TEST(AttributeTypes, that_iris_has_no_conversion_to_refuse_the_program) {
  EXPECT_THAT(refused("in uint mc_Entity;\nin ivec2 mc_midTexCoord, x;\nattribute ivec4 "
                      "at_midBlock;\nvoid main() {}\n",
                      IrisPatch::Terrain),
              ElementsAre("1:9 Iris has no uint mc_Entity; Iris refuses the program",
                          "2:10 Iris has no ivec2 mc_midTexCoord; Iris refuses the program",
                          "3:17 Iris has no ivec4 at_midBlock; Iris refuses the program"));
  EXPECT_THAT(refused("in uint mc_Entity; in ivec2 mc_midTexCoord; in ivec4 at_midBlock;",
                      IrisPatch::Vanilla),
              ElementsAre("1:54 Iris has no ivec4 at_midBlock; Iris refuses the program"));
}

TEST(AttributeTypes, others_are_free) {
  EXPECT_THAT(refused("in vec2 mc_Entity; in vec4 mc_midTexCoord; in vec3 at_midBlock; "
                      "void main() { uint mc_midTexCoord = 1u; }",
                      IrisPatch::Terrain),
              IsEmpty());
  EXPECT_THAT(refused("in ivec4 mc_Entity;", IrisPatch::Terrain), IsEmpty());
  EXPECT_THAT(refused("in ivec4 at_midBlock;", IrisPatch::Fullscreen), IsEmpty());
}

}  // namespace
}  // namespace orris
