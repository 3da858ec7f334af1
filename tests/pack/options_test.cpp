#include <orris/pack/options/options.h>

#include <gmock/gmock.h>

#include <orris/pack/options/option_line.h>

namespace orris {
namespace {

using testing::ElementsAre;

OptionSet discover(const FileLines& lines, Diagnostics* diagnostics = nullptr) {
  Diagnostics ignored;
  return discoverOptions({{"/a.glsl", lines}}, diagnostics ? *diagnostics : ignored);
}

std::string apply(const FileLines& lines, const std::string& name, const std::string& value) {
  const std::map<std::string, FileLines> files{{"/a.glsl", lines}};
  Diagnostics diagnostics;
  const OptionSet options = discoverOptions(files, diagnostics);
  return applyOptions(files, options, {{name, value}}).at("/a.glsl").at(0);
}

TEST(Options, define_without_value_is_a_boolean_when_it_is_tested) {
  const OptionSet options =
      discover({"  #define SSAO // Ambient occlusion", "//#define BLOOM", "/// #define FOG",
                "#ifdef SSAO", " #ifndef BLOOM ", "#ifdef FOG"});
  ASSERT_TRUE(options.find("SSAO"));
  EXPECT_TRUE(options.find("SSAO")->isBoolean);
  EXPECT_EQ(options.find("SSAO")->defaultValue, "true");
  EXPECT_EQ(options.find("SSAO")->comment, "Ambient occlusion");
  EXPECT_EQ(options.find("SSAO")->at, (std::vector<SourceLocation>{{"/a.glsl", 1, 3}}));
  EXPECT_EQ(options.find("BLOOM")->defaultValue, "false");
  EXPECT_EQ(options.find("FOG")->defaultValue, "false");
}

TEST(Options, boolean_needs_a_plain_ifdef) {
  for (const char* test :
       {"#if defined SSAO", "#ifdef SSAO // why", "#ifdef SSAO2", "#elif SSAO"}) {
    EXPECT_FALSE(discover({"#define SSAO", test}).find("SSAO")) << test;
  }
}

TEST(Options, value_comes_with_a_list) {
  const OptionSet options = discover({"#define Q 2 // Quality [1 2 3] of shadows"});
  ASSERT_TRUE(options.find("Q"));
  EXPECT_FALSE(options.find("Q")->isBoolean);
  EXPECT_EQ(options.find("Q")->defaultValue, "2");
  EXPECT_THAT(options.find("Q")->values, ElementsAre("1", "2", "3"));
  EXPECT_EQ(options.find("Q")->comment, "Quality  of shadows");
}

TEST(Options, default_outside_its_list_is_appended) {
  EXPECT_THAT(discover({"#define Q 5 // [1 2]"}).find("Q")->values, ElementsAre("1", "2", "5"));
}

TEST(Options, numbers_and_words_are_values) {
  for (const char* value : {"-1", "0.5", "-0.25", "2.0f", "12000", "RGBA16F", "0x10"}) {
    const OptionSet options = discover({std::string("#define Q ") + value + " // [1 2]"});
    ASSERT_TRUE(options.find("Q")) << value;
    EXPECT_EQ(options.find("Q")->defaultValue, value);
  }
}

TEST(Options, what_is_no_option) {
  for (const char* line :
       {"#define PI 3.14159", "//#define Q 2 // [1 2]", "#define Q (B+1) // [1 2]",
        "#define Q vec3(1) // [1 2]", "#define Q 12. // [1 2]", "#define Q 2 // 1 2",
        "#define Q(x) 2 // [1 2]", "#defineQ 2 // [1 2]", "x #define Q 2 // [1 2]",
        "#define Q 2 /* [1 2] */", "const int Q = 2; // [1 2]",
        "const vec3 shadowDistance = vec3(1); // [1 2]"}) {
    EXPECT_TRUE(discover({line}).all().empty()) << line;
  }
}

TEST(Options, inactive_lines_count) {
  EXPECT_TRUE(discover({"#if 0", "#define Q 2 // [1 2]", "#endif"}).find("Q"));
}

TEST(Options, const_of_a_known_name_is_an_option) {
  EXPECT_TRUE(discover({"const int shadowMapResolution = 2048; // [1024 2048]"})
                  .find("shadowMapResolution"));
  EXPECT_TRUE(
      discover({"const float sunPathRotation = -40.0; //[0 -40.0]"}).find("sunPathRotation"));
  EXPECT_FALSE(
      discover({"const bool shadowHardwareFiltering = true;"}).find("shadowHardwareFiltering"));
  EXPECT_TRUE(
      discover({"const bool shadowHardwareFiltering = true;", "#ifdef shadowHardwareFiltering"})
          .find("shadowHardwareFiltering"));
}

TEST(Options, applying_edits_the_line) {
  const std::string test = "#ifdef A";
  EXPECT_EQ(apply({"  #define A // text", test}, "A", "false"), "//  #define A // text");
  EXPECT_EQ(apply({"  #define A // text", test}, "A", "true"), "  #define A // text");
  EXPECT_EQ(apply({" /// #define A", test}, "A", "true"), " #define A");
  EXPECT_EQ(apply({"  #define Q 2 // [1 2]"}, "Q", "1"), "#define Q 1");
  EXPECT_EQ(apply({"const int shadowMapResolution = 2048; // [2048 4096]"}, "shadowMapResolution",
                  "4096"),
            "const int shadowMapResolution = 4096; // [2048 4096]");
}

TEST(Options, edited_lines_take_any_value_of_a_file) {
  EXPECT_EQ(apply({"#define Q 2 // [1 2]"}, "Q", "17"), "#define Q 17");
}

TEST(Options, same_default_merges_and_all_lines_are_edited) {
  const std::map<std::string, FileLines> files{{"/a", {"#define Q 2 // [1 2]"}},
                                               {"/b", {"#define Q 2 // two [2 1]"}}};
  Diagnostics diagnostics;
  const OptionSet options = discoverOptions(files, diagnostics);
  EXPECT_EQ(options.find("Q")->at.size(), 2u);
  EXPECT_EQ(options.find("Q")->comment, "two");
  const auto edited = applyOptions(files, options, {{"Q", "1"}});
  EXPECT_EQ(edited.at("/a")[0], "#define Q 1");
  EXPECT_EQ(edited.at("/b")[0], "#define Q 1");
}

TEST(Options, a_third_line_brings_an_ambiguous_option_back) {
  Diagnostics diagnostics;
  const OptionSet options =
      discover({"#define A", "//#define A", "//#define A // late", "#ifdef A"}, &diagnostics);
  ASSERT_TRUE(options.find("A"));
  EXPECT_EQ(options.find("A")->defaultValue, "false");
  EXPECT_EQ(options.find("A")->at.size(), 3u);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message,
            "A is false here and true in /a.glsl:1, so Iris drops it where two differ and takes "
            "false back at a later line");
  EXPECT_EQ(diagnostics[0].severity, Severity::Warning);
}

TEST(Options, the_lines_of_a_file_are_merged_before_those_of_others) {
  // Iris goes over /a, /b, /c in this order.
  const auto inThree = [](FileLines a, FileLines b, FileLines c) {
    Diagnostics diagnostics;
    return discoverOptions({{"/a", std::move(a)}, {"/b", std::move(b)}, {"/c", std::move(c)}},
                           diagnostics);
  };
  EXPECT_FALSE(inThree({"#define A", "#ifdef A"}, {"//#define A"}, {}).find("A"));
  EXPECT_EQ(inThree({"#define A", "#ifdef A"}, {"//#define A"}, {"#define A"}).value({}, "A"),
            "true");
  EXPECT_FALSE(inThree({"#define A", "#ifdef A"}, {"#define A"}, {"//#define A"}).find("A"));
  EXPECT_EQ(inThree({"#define A", "#ifdef A"}, {"//#define A", "#define A"}, {}).value({}, "A"),
            "true");
  EXPECT_EQ(inThree({"#define Q 2 // [1 2]"}, {"#define Q 2 // two [2 4]"}, {}).find("Q")->values,
            (std::vector<std::string>{"2", "4"}));
}

TEST(Options, files_of_other_mods_make_none) {
  Diagnostics diagnostics;
  OptionSet options = discoverOptions({{"/a", {"#define Q 2 // [1 2]"}}}, diagnostics);
  addModFiles({{"/clrwl", {"#define Q 2 // [1 2]", "#define R 1 // [1 2]"}}}, options);
  EXPECT_EQ(options.find("Q")->at.size(), 2u);
  EXPECT_FALSE(options.find("R"));
  EXPECT_EQ(missingOptionHint(options, "R"),
            "/clrwl:2 defines it, but only programs of other mods read that file, which Iris does "
            "not search for options");
}

TEST(Options, two_blanks_make_an_empty_value) {
  EXPECT_THAT(discover({"#define Q 2 // [1  2 3 ]"}).find("Q")->values,
              ElementsAre("1", "", "2", "3"));
  EXPECT_THAT(discover({"#define Q 2 // [ 1 2]"}).find("Q")->values, ElementsAre("", "1", "2"));
}

TEST(Options, chosen_value_goes_before_the_default) {
  const OptionSet options = discover({"#define Q 2 // [1 2]"});
  EXPECT_EQ(options.value({{"Q", "1"}}, "Q"), "1");
  EXPECT_EQ(options.value({}, "Q"), "2");
  EXPECT_EQ(options.value({}, "R"), "");
}

TEST(OptionFile, is_read_and_written) {
  const OptionSet options =
      discover({"#define Q 2 // [1 2]", "#define A", "#ifdef A", "#define R 1 // [1 2]"});
  Diagnostics diagnostics;
  const OptionValues values =
      parseOptionFile("p.txt", "#comment\nQ = 7\nA=false\nR=1\nX=1\n", options, diagnostics);
  EXPECT_EQ(values, (OptionValues{{"A", "false"}, {"Q", "7"}, {"R", "1"}}));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(formatDiagnostic(diagnostics[0]),
            "p.txt:5:1: warning: the pack has no option X\n  X=1\n  ^");
  EXPECT_EQ(writeOptionFile(options, values), "A=false\nQ=7\n");
}

TEST(OptionFile, boolean_that_is_neither_keeps_its_default) {
  const OptionSet options = discover({"#define A", "#ifdef A"});
  Diagnostics diagnostics;
  EXPECT_TRUE(parseOptionFile("p.txt", "A=yes\n", options, diagnostics).empty());
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message, "A is \"yes\", expected true or false; it keeps true");
}

}  // namespace
}  // namespace orris
