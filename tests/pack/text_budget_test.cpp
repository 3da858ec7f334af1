// Texts that meet a limit: one located message, and none that follows from what is missing then.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <orris/core/limits.h>
#include "loaded_pack.h"

namespace orris {
namespace {

std::vector<std::string> messages(const Loaded& loaded) {
  std::vector<std::string> result;
  for (const Diagnostic& d : loaded.diagnostics) {
    const std::string text = formatDiagnostic(d);
    result.push_back(text.substr(0, text.find('\n')));
  }
  return result;
}

Loaded load(Files files) {
  files.try_emplace("/composite.vsh", kVertex);
  return loadFiles(std::move(files), {.keepGoing = true});
}

TEST(TextBudget, a_refused_program_is_not_compiled) {
  const Loaded loaded = load({{"/composite.fsh", "\xFF\xFE#"}});
  EXPECT_THAT(
      messages(loaded),
      testing::ElementsAre("/composite.fsh:1:1: error: this file is UTF-16, which no host reads"));
  EXPECT_TRUE(loaded.pack->find("composite")->incomplete);
}

TEST(TextBudget, a_refused_include_names_the_line_that_includes_it) {
  const Loaded loaded = load({{"/composite.fsh", "\n#include \"/data.glsl\"\n"},
                              {"/data.glsl", std::string(limits::kTextFileBytes + 1, ' ')}});
  ASSERT_EQ(loaded.diagnostics.size(), 1u);
  EXPECT_EQ(loaded.diagnostics[0].id, "text-too-large");
  ASSERT_EQ(loaded.diagnostics[0].includedFrom.size(), 1u);
  EXPECT_EQ(loaded.diagnostics[0].includedFrom[0].line, 2);
}

TEST(TextBudget, includes_that_double_are_cut_off_with_one_message) {
  Files files{{"/composite.fsh", "#include \"/i0\"\n"}, {"/i40", "x\n"}};
  for (int i = 0; i < 40; ++i) {
    const std::string next = "#include \"/i" + std::to_string(i + 1) + "\"\n";
    files["/i" + std::to_string(i)] = next + next;
  }
  const Loaded loaded = load(files);
  ASSERT_EQ(loaded.diagnostics.size(), 1u) << loaded.first();
  EXPECT_EQ(loaded.diagnostics[0].id, "source-too-large");
  EXPECT_EQ(loaded.diagnostics[0].at.file, "/i40");
  EXPECT_EQ(loaded.diagnostics[0].includedFrom.back().file, "/composite.fsh");
  EXPECT_TRUE(loaded.pack->find("composite")->incomplete);
}

TEST(TextBudget, macros_that_double_leave_one_message) {
  std::string text = "#define A0 x\n";
  for (int i = 1; i < 60; ++i) {
    const std::string before = "A" + std::to_string(i - 1);
    text += "#define A" + std::to_string(i) + " " + before + " " + before + "\n";
  }
  const Loaded loaded = load({{"/composite.fsh", text + "A59\n"}});
  ASSERT_EQ(loaded.diagnostics.size(), 1u) << loaded.first();
  EXPECT_EQ(loaded.diagnostics[0].id, "macro-expansion-limit");
  EXPECT_EQ(loaded.diagnostics[0].at.line, 61);
}

TEST(TextBudget, all_texts_together_are_limited) {
  Files files;
  std::string includes;
  for (int i = 0; i < 10; ++i) {
    const std::string name = "/data" + std::to_string(i) + ".glsl";
    files[name] = std::string(limits::kTextFileBytes - 10, ' ');
    includes += "#include \"" + name + "\"\n";
  }
  files["/composite.fsh"] = includes;
  EXPECT_THAT(messages(load(files)),
              testing::Contains("/data7.glsl:1: error: with this file, the texts of the pack have "
                                "more than 33554432 bytes; it is not read"));
}

TEST(TextBudget, refused_properties_are_reported_once) {
  std::string many;
  for (std::size_t i = 0; i <= limits::kPropertyLines; ++i)
    many += "block." + std::to_string(i) + "=a\n";
  for (const std::string file :
       {"/shaders.properties", "/block.properties", "/dimension.properties", "/lang/en_us.lang"}) {
    const Loaded loaded = load({{"/composite.fsh", kFragment}, {file, many}});
    EXPECT_THAT(messages(loaded),
                testing::ElementsAre(file + ":20001: error: the file has more than 20000 lines "
                                            "that are not blank; it is not read"));
  }
}

}  // namespace
}  // namespace orris
