#include <orris/world/blocks/block_state.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

TEST(BlockState, name_without_namespace_is_minecrafts) {
  EXPECT_EQ(parseBlockState("stone")->toString(), "minecraft:stone");
}

TEST(BlockState, properties_are_read_and_written_in_order_of_key) {
  const auto state = parseBlockState("minecraft:oak_stairs[half=bottom,facing=north]");
  ASSERT_TRUE(state);
  EXPECT_EQ(state->property("facing"), "north");
  EXPECT_EQ(state->property("half"), "bottom");
  EXPECT_EQ(state->property("shape", "straight"), "straight");
  EXPECT_EQ(state->toString(), "minecraft:oak_stairs[facing=north,half=bottom]");
}

TEST(BlockState, other_namespaces_and_empty_brackets_are_kept_simple) {
  EXPECT_EQ(parseBlockState("mod.a:deep/block[]")->toString(), "mod.a:deep/block");
}

TEST(BlockState, text_survives_a_round_trip) {
  for (const char* text : {"minecraft:air", "minecraft:lantern[hanging=true]",
                           "minecraft:water[level=3]", "x:y[a=1,b=2,c=3]"}) {
    EXPECT_EQ(parseBlockState(text)->toString(), text);
  }
}

TEST(BlockState, malformed_text_is_refused) {
  for (const char* text :
       {"",      ":",    "a:",      ":a",    "Stone",   "a b",       "a[",
        "a[]b",  "a[x]", "a[x=]",   "a[=y]", "a[x=1,]", "a[,x=1]",   "a[x=1,x=2]",
        "a[x=1", "a]",   "a[x=1]]", "[x=1]", "a:b:c",   "a[x=1;y=2]"}) {
    EXPECT_FALSE(parseBlockState(text)) << text;
  }
}

}  // namespace
}  // namespace orris
