#include <orris/check/ids/id_checks.h>

#include "pack_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kNothing = " | the first line that fits a block counts, so this one does nothing";

std::vector<std::string> blocks(const std::string& text) {
  return found(checkIdMaps, {{"/block.properties", text}});
}

TEST(IdTwice, a_block_under_a_second_id_is_reported_at_the_word) {
  EXPECT_THAT(blocks("block.1 = stone \\\n  dirt\n# more\nblock.2 = glass \\\n  minecraft:dirt\n"),
              ElementsAre("id-twice /block.properties:5:3: warning: minecraft:dirt has block.1 as "
                          "dirt already, from line 2" +
                          kNothing));
}

TEST(IdBlock, a_slip_of_a_block_is_reported) {
  EXPECT_THAT(blocks("block.1=stone minecraft:oak_leafs\nblock.2=spruce_stairss:half=top\n"
                     "block.3=minecraft:quarzt_ore\n"),
              ElementsAre("id-block /block.properties:1:15: warning: the game has no block "
                          "minecraft:oak_leafs | did you mean oak_leaves?",
                          "id-block /block.properties:2:9: warning: the game has no block "
                          "minecraft:spruce_stairss | did you mean spruce_stairs?",
                          "id-block /block.properties:3:9: warning: the game has no block "
                          "minecraft:quarzt_ore | did you mean quartz_ore?"));
}

TEST(IdBlock, blocks_of_mods_and_of_other_versions_are_left_alone) {
  EXPECT_THAT(blocks("block.1=mod:oak_leafs grass tallgrass nether_brick noteblock log2 %oak_logs\n"
                     "block.2=web shortgrass short_grass iron_chain wholly_unknown\n"),
              IsEmpty());
}

TEST(IdBlock, a_state_after_a_blank_belongs_to_no_block) {
  EXPECT_THAT(blocks("block.1=stone :half=top\nblock.2=dirt :half=top\n"),
              ElementsAre("id-block /block.properties:1:15: warning: :half=top belongs to no block, "
                          "for a blank stands before it | take the blank away",
                          "id-block /block.properties:2:14: warning: :half=top belongs to no block, "
                          "for a blank stands before it | take the blank away"));
}

TEST(IdBlock, what_can_be_no_name_is_one_finding) {
  EXPECT_THAT(blocks("block.1=mod:OreBlock stone mod:a.b-c/d_2\nblock.2=mod:Other a=b\n"),
              ElementsAre(testing::StartsWith(
                  "id-block /block.properties:1:9: warning: mod:OreBlock can be no name of a block, nor "
                  "can others of this file (2): the game refuses it")));
}

TEST(IdTwice, misspelt_blocks_and_states_by_number_are_not_compared) {
  EXPECT_THAT(blocks("block.1=mod:a:0\nblock.2=mod:a:1\n"), IsEmpty());
  EXPECT_THAT(blocks("block.1=oak_leafs\nblock.2=oak_leafs\n"),
              testing::Each(testing::StartsWith("id-block ")));
}

TEST(IdProperty, a_word_that_lost_its_last_letter_is_no_second_finding) {
  EXPECT_THAT(blocks("block.1=stone_button:facing=east \\\n\n# more\nblock.2=dirt\n"), IsEmpty());
}

TEST(IdTwice, words_of_a_line_that_was_meant_as_a_comment_are_left_alone) {
  EXPECT_THAT(blocks("block.1=stone \\\n\n// of shapes\nblock.2=dirt \\\n\n// of shapes\n"),
              IsEmpty());
}

TEST(IdProperty, a_value_that_runs_into_the_next_name_is_said_to_lack_a_blank) {
  EXPECT_THAT(blocks("block.1=iron_door:open=false\\\nspruce_door:open=true\n"),
              ElementsAre("id-property /block.properties:1:1: warning: \"falsespruce_door\" in "
                          "iron_door:open=falsespruce_door:open=true is no value of open | a blank "
                          "seems to be missing after false"));
}

TEST(IdTwice, a_state_after_its_block_is_lost_and_before_it_is_not) {
  EXPECT_THAT(
      blocks("block.1=lantern\nblock.2=lantern:hanging=true\n"),
      ElementsAre("id-twice /block.properties:2:9: warning: lantern:hanging=true has block.1 "
                  "as lantern already, from line 1" +
                  kNothing));
  EXPECT_THAT(blocks("block.2=lantern:hanging=true\nblock.1=lantern\n"), IsEmpty());
}

TEST(IdTwice, states_overlap_when_every_listed_value_is_taken) {
  EXPECT_THAT(blocks("block.1=a:x=1,2\nblock.2=a:x=2:y=3\n"), testing::SizeIs(1));
  EXPECT_THAT(blocks("block.1=a:x=1,2\nblock.2=a:x=2,3\n"), IsEmpty());
  EXPECT_THAT(blocks("block.1=a:x=1:y=3\nblock.2=a:x=1\n"), IsEmpty());
  EXPECT_THAT(blocks("block.1=%logs\nblock.2=logs\n"), IsEmpty());
}

TEST(IdTwice, a_line_of_a_branch_that_may_be_away_takes_nothing) {
  EXPECT_THAT(blocks("#ifdef MC_VERSION\nblock.1=dirt\n#endif\nblock.2=dirt\n"), IsEmpty());
  EXPECT_THAT(blocks("block.1=dirt\n#ifdef MC_VERSION\nblock.2=dirt\n#endif\n"),
              testing::SizeIs(1));
  EXPECT_THAT(blocks("#ifdef MC_VERSION\nblock.1=dirt\n#else\nblock.2=dirt\n#endif\n"), IsEmpty());
}

TEST(IdTwice, within_one_id_it_is_a_note) {
  EXPECT_THAT(
      blocks("block.1=dirt stone dirt\n"),
      ElementsAre("id-repeated /block.properties:1:20: note: dirt is covered by dirt in line "
                  "1, of the same block.1"));
}

TEST(IdTwice, a_block_before_its_states_is_reported_once_where_it_stands) {
  EXPECT_THAT(
      blocks("block.1=dirt stairs\nblock.2=stairs:half=top\nblock.3=stairs:half=bottom a\n"
             "block.4=stairs:shape=straight\n"),
      ElementsAre("id-twice /block.properties:1:14: warning: stairs has block.1 here in all "
                  "its states, so 3 later entries of it do nothing | the first line that "
                  "fits a block counts: name the states that are meant here, or put this "
                  "line last"));
}

TEST(IdTwice, a_copied_line_is_reported_once) {
  EXPECT_THAT(
      blocks("block.1=a b c d e\nblock.2=e d c b x\n"),
      ElementsAre("id-twice /block.properties:2:9: warning: e, d, c and 1 more have block.1 "
                  "already, from line 1 | the first line that fits a block counts, so these "
                  "do nothing"));
  EXPECT_THAT(blocks("block.1=a b\nblock.2=a\nblock.3=b\n"), testing::SizeIs(2));
}

TEST(IdTwice, a_very_long_line_costs_no_more_than_its_length) {
  std::string text = "block.1=";
  for (int i = 0; i < 10000; ++i) text += "a" + std::to_string(i) + ' ';
  EXPECT_THAT(blocks(text + "\nblock.2=a7\n"), testing::SizeIs(1));
}

TEST(IdTwice, states_of_old_versions_were_for_another_host) {
  EXPECT_THAT(blocks("block.1=stone\nblock.2=stone:variant=granite\n"), IsEmpty());
}

TEST(IdKeyTwice, the_earlier_line_is_lost) {
  const std::string hint =
      " | the last line of a key counts: put the names on one, or use another number";
  EXPECT_THAT(
      blocks("block.10=dirt\nblock.11=stone\nblock.10=glass\n"),
      ElementsAre("id-key-twice /block.properties:3:1: warning: block.10 is given again, so "
                  "what line 1 lists is lost" +
                  hint));
  EXPECT_THAT(blocks("block.10=dirt\nblock.10 = dirt\n"),
              ElementsAre("id-key-twice /block.properties:2:1: note: block.10 is given again, so "
                          "what line 1 lists is lost"));
  EXPECT_THAT(found(checkIdMaps, {{"/item.properties", "item.1=a\nitem.1=b\n"}}),
              ElementsAre("id-key-twice /item.properties:2:1: warning: item.1 is given again, so "
                          "what line 1 lists is lost" +
                          hint));
}

TEST(IdKeyTwice, branches_may_replace_a_default) {
  EXPECT_THAT(blocks("block.1=dirt\n#ifdef MC_VERSION\nblock.1=stone\n#endif\n"), IsEmpty());
  EXPECT_THAT(blocks("#ifdef NEVER\nblock.1=dirt\n#else\nblock.1=stone\n#endif\n"), IsEmpty());
}

TEST(IdNames, of_items_the_last_line_counts_so_it_is_a_note) {
  EXPECT_THAT(found(checkIdMaps, {{"/item.properties", "item.1=torch lantern\nitem.2=torch\n"}}),
              ElementsAre("id-repeated /item.properties:2:8: note: torch has item.1 already, from "
                          "line 1; the last line counts"));
}

TEST(IdProperty, misspelt_states_are_reported_at_the_word) {
  EXPECT_THAT(
      blocks("block.1=oak_stairs:half=tpo oak_door:hafl=lower \\\n  furnace:lit=yes\n"),
      ElementsAre(
          "id-property /block.properties:1:9: warning: \"tpo\" in oak_stairs:half=tpo is no "
          "value of half | did you mean top?",
          "id-property /block.properties:1:29: warning: \"hafl\" in oak_door:hafl=lower is no "
          "property of a block | did you mean half?",
          "id-property /block.properties:2:3: warning: \"yes\" in furnace:lit=yes is no value "
          "of lit | its values are true, false"));
}

TEST(IdProperty, mods_and_old_versions_have_states_of_their_own) {
  EXPECT_THAT(
      blocks("block.1=mod:lamp:hafl=1 sponge:wet=true stone:variant=andesite log:axis=none\n"
             "block.2=candle:candles=4 oak_fence:north=true wall:east=low note_block:note=24\n"
             "block.3=piston_head:type=sticky trial_spawner:trial_spawner_state=new_one\n"),
      IsEmpty());
}

}  // namespace
}  // namespace orris
