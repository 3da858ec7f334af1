#include "app/window/option_pages.h"

#include <gmock/gmock.h>

#include "app/view/files/open_editor.h"
#include "app/window/rich_text.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Kind = OptionCell::Kind;

ShaderPack packOf(const std::string& properties, const std::string& language,
                  const LoadRequest& request = {.buildSources = false}) {
  Diagnostics diagnostics;
  auto pack = loadShaderPack(
      memorySource({{"/shaders.properties", properties},
                    {"/lang/en_us.lang", language},
                    {"/final.vsh", "#version 120\nvoid main() { gl_Position = ftransform(); }\n"},
                    {"/final.fsh",
                     "#version 120\n"
                     "#define SHADOWS // cast them\n"
                     "#define SIZE 2 // [1 2 4] how large\n"
                     "#define MODE 0 // [0 1 2]\n"
                     "#ifdef SHADOWS\n#endif\n#if SIZE == 2 && MODE == 1\n#endif\n"
                     "void main() { gl_FragColor = vec4(1.0); }\n"}}),
      request, diagnostics);
  return pack ? std::move(*pack) : ShaderPack();
}

std::vector<std::string> namesIn(const OptionPage& page) {
  std::vector<std::string> names;
  for (const OptionCell& cell : page.cells) names.push_back(cell.name);
  return names;
}

std::vector<Kind> kindsIn(const OptionPage& page) {
  std::vector<Kind> kinds;
  for (const OptionCell& cell : page.cells) kinds.push_back(cell.kind);
  return kinds;
}

TEST(OptionPages, a_screen_shows_its_words_in_order) {
  const ShaderPack pack = packOf(
      "screen = <profile> SHADOWS <empty> [SUB] NOTHING *\nscreen.SUB = SIZE\nscreen.SUB.columns = 1\n"
      "sliders = SIZE\nprofile.LOW = SIZE=1\n",
      "screen.SUB=\xC2\xA7" "eSub page\n");
  const OptionPage main = optionPage(pack, "");
  EXPECT_THAT(kindsIn(main), ElementsAre(Kind::Profile, Kind::Boolean, Kind::Empty, Kind::Screen,
                                         Kind::Missing, Kind::Choice));
  EXPECT_EQ(main.cells.back().name, "MODE");
  EXPECT_EQ(main.columns, 2);
  const OptionPage sub = optionPage(pack, "SUB");
  EXPECT_THAT(kindsIn(sub), ElementsAre(Kind::Slider));
  EXPECT_EQ(sub.columns, 1);
  EXPECT_EQ(withoutCodes(sub.title), "Sub page");
  EXPECT_EQ(optionPage(pack, "GONE").name, "");
}

TEST(OptionPages, a_pack_without_screens_shows_all_options) {
  const ShaderPack pack = packOf("", "");
  EXPECT_THAT(namesIn(optionPage(pack, "")), ElementsAre("MODE", "SHADOWS", "SIZE"));
}

TEST(OptionPages, texts_come_from_the_language_file_and_missing_ones_are_marked) {
  const ShaderPack pack = packOf("screen = SIZE MODE SHADOWS\n",
                                 "option.SIZE=Size\noption.SIZE.comment=In blocks\nvalue.SIZE.2=two\n"
                                 "prefix.SIZE=~\nsuffix.SIZE=m\n");
  const OptionPage page = optionPage(pack, "");
  EXPECT_EQ(page.cells[0].label, "Size");
  EXPECT_EQ(page.cells[0].comment, "In blocks");
  EXPECT_EQ(page.cells[0].valueLabel, "~two");
  EXPECT_EQ(valueLabelOf(pack, *pack.options.find("SIZE"), "4"), "~4m");
  EXPECT_FALSE(page.cells[0].labelMissing);
  EXPECT_TRUE(page.cells[1].labelMissing);
  EXPECT_EQ(page.cells[1].label, "MODE");
  EXPECT_EQ(page.cells[2].valueLabel, "ON");
}

TEST(OptionPages, changed_values_mark_their_cells_and_the_screens_that_lead_there) {
  const ShaderPack pack =
      packOf("screen = [SUB] MODE\nscreen.SUB = [DEEP] [SUB]\nscreen.DEEP = SIZE\n", "",
             {.values = {{"SIZE", "4"}}, .buildSources = false});
  const OptionPage main = optionPage(pack, "");
  EXPECT_TRUE(main.cells[0].changed);
  EXPECT_FALSE(main.cells[1].changed);
  EXPECT_TRUE(optionPage(pack, "DEEP").cells[0].changed);
}

TEST(OptionPages, search_finds_names_labels_and_values) {
  const ShaderPack pack = packOf("screen = MODE\n", "option.SIZE=Block edge\n");
  EXPECT_THAT(namesIn(searchOptions(pack, "edge")), ElementsAre("SIZE"));
  EXPECT_THAT(namesIn(searchOptions(pack, "cast")), ElementsAre("SHADOWS"));
  EXPECT_THAT(namesIn(searchOptions(pack, "nothing of it")), IsEmpty());
}

TEST(OptionPages, values_go_round) {
  const Option option{.name = "SIZE", .values = {"1", "2", "4"}};
  EXPECT_EQ(valueBeside(option, "4", 1), "1");
  EXPECT_EQ(valueBeside(option, "1", -1), "4");
  EXPECT_EQ(valueBeside(option, "9", 1), "2");
  EXPECT_EQ(valueBeside({}, "9", 1), "9");
}

TEST(RichText, codes_colour_what_follows_until_they_are_reset) {
  EXPECT_THAT(textRuns("a\xC2\xA7" "cb\xC2\xA7" "l!\xC2\xA7rd"),
              ElementsAre(TextRun{"a"}, TextRun{"b", 0xFF5555}, TextRun{"!", 0xFF5555, true},
                          TextRun{"d"}));
  EXPECT_EQ(withoutCodes("\xC2\xA7" "aON"), "ON");
  EXPECT_EQ(withoutCodes("end \xC2\xA7"), "end \xC2\xA7");
  EXPECT_THAT(textRuns(""), IsEmpty());
}

TEST(OpenEditor, each_editor_gets_the_line_as_it_wants_it) {
  EXPECT_THAT(editorCommand("vim", "/a b.fsh", 7), ElementsAre("vim", "+7", "/a b.fsh"));
  EXPECT_THAT(editorCommand("/usr/bin/code -n", "/a.fsh", 7),
              ElementsAre("/usr/bin/code", "-n", "-g", "/a.fsh:7"));
  EXPECT_THAT(editorCommand("subl", "/a.fsh", 7), ElementsAre("subl", "/a.fsh:7"));
  EXPECT_THAT(editorCommand(" ", "/a.fsh", 7), IsEmpty());
}

}  // namespace
}  // namespace orris
