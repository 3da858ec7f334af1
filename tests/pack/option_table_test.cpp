// Which lines are options, and how values edit them: tables of cases as real packs write them.
// Contract: options.csv scan.*, bool.*, value.*, const.*, merge.*.
#include <gmock/gmock.h>

#include <orris/pack/files/text.h>
#include <orris/pack/options/option_line.h>
#include <orris/pack/options/options.h>

namespace orris {
namespace {

/// "bool NAME default" or "NAME default [values] comment"; "" for a line that defines no option.
std::string summary(const std::string& line) {
  const auto option = parseOptionLine(line);
  if (!option) return "";
  if (option->isBoolean) return "bool " + option->name + " " + option->value;
  return option->name + " " + option->value + " [" + joinNames(option->values) + "]" +
         (option->comment.empty() ? "" : " " + option->comment);
}

struct OptionLineCase {
  const char* line;
  const char* option;
};

TEST(OptionTable, boolean_defines) {  // Iris: OptionAnnotatedSource.parseDefineOption
  const OptionLineCase kCases[] = {
      {"#define A", "bool A true"},
      {"\t#define\tA\t", "bool A true"},
      {"#define A//text", "bool A true"},
      {"#define A //[1 2]", "bool A true"},  // a list after a name alone says nothing
      {"//#define A", "bool A false"},
      {"// #define A // text", "bool A false"},
      {"////  #define A", "bool A false"},
      {"/ /#define A", ""},
      {"/* #define A", ""},
      {"#define A /* text */", ""},
      {"#define A(x)", ""},
      {"#define A-B", ""},
      {"#define 1A", "bool 1A true"},  // Iris: ParsedString.takeWord takes digits first
      {"# define A", ""},
      {"#defineA", ""},
      {"#define", ""},
      {"code(); #define A", ""},
      {"// see #define A", ""},
  };
  for (const OptionLineCase& test : kCases) EXPECT_EQ(summary(test.line), test.option) << test.line;
}

TEST(OptionTable, value_defines) {  // Iris: StringOption.create, ParsedString.takeWordOrNumber
  const OptionLineCase kCases[] = {
      {"#define A 2 // [1 2 3]", "A 2 [1, 2, 3]"},
      {"  #define   A   2   //   [1 2 3]", "A 2 [1, 2, 3]"},
      {"#define A 2//[1 2]", "A 2 [1, 2]"},
      {"#define A 2 /// [1 2]", "A 2 [1, 2]"},
      {"#define A 2 // before [1 2] after", "A 2 [1, 2] before  after"},
      {"#define A 2 // [1 2] [8 9]", "A 2 [1, 2] [8 9]"},  // the first list counts
      {"#define A 2 // ] [1 2]", "A 2 [1, 2] ]"},
      {"#define A 5 // [1 2]", "A 5 [1, 2, 5]"},
      {"#define A 2 // [2]", "A 2 [2]"},
      {"#define A 2 // []", "A 2 [2]"},
      {"#define A 1.0 // [1.0 1]", "A 1.0 [1.0, 1]"},
      {"#define A 1 // [1.0]", "A 1 [1.0, 1]"},  // values are texts
      {"#define A -1 // [-1 0 1]", "A -1 [-1, 0, 1]"},
      {"#define A -0.25 // [0]", "A -0.25 [0, -0.25]"},
      {"#define A +1 // [+1]", "A +1 [+1]"},
      {"#define A .5 // [.5 1]", "A .5 [.5, 1]"},
      {"#define A 0.5f // [0.5f 1.f]", "A 0.5f [0.5f, 1.f]"},
      {"#define A 1e5 // [1e5]", "A 1e5 [1e5]"},
      {"#define A FAST // [FAST FANCY]", "A FAST [FAST, FANCY]"},
      {"#define A RGBA16F // [RGBA16F]", "A RGBA16F [RGBA16F]"},
      {"#define A 0x10 // [0x10]", "A 0x10 [0x10]"},
      // Values that look like one and are none.
      {"#define A 12. // [12.]", ""},
      {"#define A 1e-5 // [1e-5]", ""},
      {"#define A 8K // [8K]", ""},
      {"#define A 1-2 // [1-2]", ""},
      {"#define A 1.0.0 // [1.0.0]", ""},
      {"#define A (1) // [(1)]", ""},
      {"#define A vec3(1) // [1]", ""},
      {"#define A B C // [B C]", ""},
      {"#define A \"x\" // [1]", ""},
      // No list, no comment, commented out.
      {"#define A 2", ""},
      {"#define A 2 // 1 2 3", ""},
      {"#define A 2 // [1 2 3", ""},
      {"#define A 2 /* [1 2 3] */", ""},
      {"#define A 2 [1 2 3]", ""},
      {"//#define A 2 // [1 2 3]", ""},
      {"#define A(x) 2 // [1 2]", ""},
  };
  for (const OptionLineCase& test : kCases) EXPECT_EQ(summary(test.line), test.option) << test.line;
}

TEST(OptionTable, constants) {  // Iris: OptionAnnotatedSource.parseConst, VALID_CONST_OPTION_NAMES
  const OptionLineCase kCases[] = {
      {"const int shadowMapResolution = 1024; // [512 1024]",
       "shadowMapResolution 1024 [512, 1024]"},
      {"  const float shadowDistance=80.0;//[40.0 80.0]", "shadowDistance 80.0 [40.0, 80.0]"},
      {"const float sunPathRotation = -40.0; // [-40.0 0.0]", "sunPathRotation -40.0 [-40.0, 0.0]"},
      {"const float shadowDistance = 80; // [60]", "shadowDistance 80 [60, 80]"},
      {"const bool shadowHardwareFiltering = true;", "bool shadowHardwareFiltering true"},
      {"const bool shadowcolor0Nearest = false; // text", "bool shadowcolor0Nearest false"},
      {"const int noiseTextureResolution = 64;", ""},
      {"const int noiseTextureResolution = 64; // [64", ""},
      {"const bool shadowHardwareFiltering = on;", ""},
      {"const int colortex0Format = 1; // [1 2]", ""},
      {"const int mySamples = 4; // [4 8]", ""},
      {"const vec3 shadowDistance = 1; // [1]", ""},
      {"const highp float shadowDistance = 1.0; // [1.0]", ""},
      {"const float shadowDistance = 80.0 // [80.0]", ""},
      {"const float shadowDistance = 80.0 * 2; // [80.0]", ""},
      {"const float shadowDistance = 80.0; int x; // [80.0]", ""},
      {"//const float shadowDistance = 80.0; // [80.0]", ""},
      {"static const float shadowDistance = 80.0; // [80.0]", ""},
      {"constfloat shadowDistance = 80.0; // [80.0]", ""},
  };
  for (const OptionLineCase& test : kCases) EXPECT_EQ(summary(test.line), test.option) << test.line;
}

TEST(OptionTable, references) {  // Iris: OptionAnnotatedSource.parseIfdef
  const OptionLineCase kCases[] = {
      {"#ifdef A", "A"},           {"  #ifndef\tA  ", "A"}, {"#ifdef A // text", ""},
      {"#ifdef A /* text */", ""}, {"#ifdef A B", ""},      {"#if defined A", ""},
      {"#if defined(A)", ""},      {"#elif defined A", ""}, {"# ifdef A", ""},
      {"//#ifdef A", ""},          {"#ifdef", ""},          {"#ifdefA", ""},
  };
  for (const OptionLineCase& test : kCases)
    EXPECT_EQ(booleanReference(test.line), test.option) << test.line;
}

struct EditCase {
  const char *line, *value, *edited;
};

TEST(OptionTable, values_edit_lines) {  // Iris: OptionAnnotatedSource.edit
  const EditCase kCases[] = {
      {"#define A // text", "false", "//#define A // text"},
      {"  #define A", "false", "//  #define A"},
      {"//#define A // text", "true", "#define A // text"},
      {"  //// #define A", "true", " #define A"},
      {"  #define A 2 // text [1 2]", "1", "#define A 1"},
      {"#define A 2 // [1 2]", "", "#define A "},
      {"const int shadowMapResolution = 1024; // [1024 2048]", "2048",
       "const int shadowMapResolution = 2048; // [1024 2048]"},
      // The first occurrence of the default behind the equals sign.
      {"const float shadowDistance = 1.0; // [1.0 2.0]", "2.0",
       "const float shadowDistance = 2.0; // [1.0 2.0]"},
      {"const bool shadowtex0Nearest = true; // true", "false",
       "const bool shadowtex0Nearest = false; // true"},
  };
  for (const EditCase& test : kCases) {
    const auto option = parseOptionLine(test.line);
    ASSERT_TRUE(option) << test.line;
    EXPECT_EQ(editOptionLine(test.line, *option, test.value), test.edited) << test.line;
  }
}

using LinesOfFiles = std::map<std::string, FileLines>;

struct SetCase {
  const char* what;
  LinesOfFiles files;
  std::vector<std::string> options;
};

TEST(OptionTable, discovery_over_files) {
  const SetCase kCases[] = {
      {"a reference in any file counts; Iris: IncludeGraph.computeWeaklyConnectedComponents",
       {{"/a", {"#define A"}}, {"/b", {"#ifdef A"}}},
       {"A=true"}},
      {"a boolean that only #if or a comment tests is none",
       {{"/a", {"#define A", "#if defined A", "#ifdef A // on"}}},
       {}},
      {"a constant switch needs a reference, too",
       {{"/a", {"const bool shadowtex0Nearest = true;"}}},
       {}},
      {"value options need none", {{"/a", {"#define A 1 // [1 2]"}}}, {"A=1"}},
      {"inactive lines and block comments count",
       {{"/a", {"#if 0", "#define A 1 // [1 2]", "#endif", "/*", "#define B 1 // [1 2]", "*/"}}},
       {"A=1", "B=1"}},
      {"equal defaults merge",
       {{"/a", {"#define A 1 // [1 2]"}}, {"/b", {"#define A 1 // [1 3]"}}},
       {"A=1"}},
      {"different defaults make none; Iris: OptionSet.Builder",
       {{"/a", {"#define A 1 // [1 2]"}}, {"/b", {"#define A 2 // [1 2]"}}},
       {}},
      {"on here and off there makes none",
       {{"/a", {"#define A", "#ifdef A"}}, {"/b", {"// #define A"}}},
       {}},
  };
  for (const SetCase& test : kCases) {
    Diagnostics diagnostics;
    std::vector<std::string> options;
    const OptionSet found = discoverOptions(test.files, diagnostics);
    for (const auto& [name, option] : found.all()) {
      options.push_back(name + "=" + option.defaultValue);
    }
    EXPECT_EQ(options, test.options) << test.what;
  }
}

TEST(OptionTable, a_define_that_is_no_option_says_why) {
  Diagnostics diagnostics;
  const OptionSet options =
      discoverOptions({{"/a",
                        {"#define FOG", "#define STEPS 4", "#define MODE 1 // [1 2]",
                         "#define MODE 2 // [1 2]", "#define CLOUDS", "#ifdef CLOUDS",
                         "#define DENSITY 2. // [1. 2.] of water", "//#define RAIN 1 // [1 2]",
                         "#define WAVES", "  #ifndef WAVES // still water"}}},
                      diagnostics);
  EXPECT_EQ(missingOptionHint(options, "FOG"),
            "/a:1 defines it, but no line that a program reads is #ifdef FOG or #ifndef FOG");
  EXPECT_EQ(missingOptionHint(options, "STEPS"),
            "/a:2 defines it, but no list of values like // [1 2 3] follows");
  EXPECT_EQ(missingOptionHint(options, "MODE"),
            "/a:3 defines it, but its lines have different defaults");
  EXPECT_EQ(missingOptionHint(options, "DENSITY"),
            "/a:7 defines it, but Iris takes a word or a number for its value, 2.0 and not 2. or (2.0)");
  EXPECT_EQ(missingOptionHint(options, "RAIN"), "/a:8 defines it, but that line is a comment");
  EXPECT_EQ(missingOptionHint(options, "WAVES"),
            "/a:9 defines it, but Iris overlooks /a:10, for the text behind the name: put it on a line of "
            "its own");
  EXPECT_EQ(missingOptionHint(options, "CLOUD"), "did you mean CLOUDS?");
  EXPECT_EQ(missingOptionHint(options, "WATER_WAVES"), "");
}

}  // namespace
}  // namespace orris
