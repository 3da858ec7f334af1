#include <orris/pack/files/text.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

std::string nearest(const std::string& name, const std::string& candidate) {
  return nearestName(name, {candidate});
}

TEST(NearestName, is_what_a_slip_of_the_finger_makes) {
  for (const auto& [name, meant] : std::vector<std::pair<std::string, std::string>>{
           {"usnPosition", "sunPosition"},
           {"fgColor", "fogColor"},
           {"camPosition", "cameraPosition"},
           {"rain_stength", "rain_strength"},
           {"isEyInWater", "isEyeInWater"},
           {"vertexPosition", "vaPosition"},
           {"normaltex", "normals"},
           {"polished_diorite_stars", "polished_diorite_stairs"}}) {
    EXPECT_EQ(nearest(name, meant), meant) << name;
  }
}

TEST(NearestName, is_no_other_word_and_no_other_number) {
  for (const auto& [name, other] : std::vector<std::pair<std::string, std::string>>{
           {"windStrength", "rainStrength"},
           {"waveHeight", "viewHeight"},
           {"entityHurt", "entityId"},
           {"cameraDirection", "cameraPosition"},
           {"warped_wood", "warped_door"},
           {"GET_EMISSION", "SET_EMISSION"},
           {"FSR_RCAS_H", "FSR_RCAS_F"},
           {"1.0", "10"}}) {
    EXPECT_EQ(nearest(name, other), "") << name;
  }
}

TEST(NearestName, a_nearer_sibling_does_not_hide_the_name_that_was_meant) {
  EXPECT_EQ(nearestName("GET_EMISION", {"SET_EMISION", "GET_EMISSION"}), "GET_EMISSION");
}

TEST(NearestName, of_nothing_there_is_none) {
  EXPECT_EQ(nearest("", "a"), "");
  EXPECT_EQ(nearest("", ""), "");
}

// Two keep their letters, one has three others in place of its own, which are three slips.
TEST(NearestName, has_at_most_as_many_other_letters_as_slips) {
  EXPECT_EQ(nearest("shdaowMap", "shadowMap"), "shadowMap");
  EXPECT_EQ(nearest("colortxe0", "colortex0"), "colortex0");
  EXPECT_EQ(nearest("xhyduwmap", "shadowmap"), "shadowmap");
}

}  // namespace
}  // namespace orris
