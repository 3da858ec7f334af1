// Loading a pack again under other values: equal to loading it afresh, with less work.
#include <gmock/gmock.h>

#include "loaded_pack.h"
#include <orris/pack/programs/folder_build.h>
#include <orris/pack/rebuild.h>

namespace orris {
namespace {

using testing::ElementsAre;

constexpr const char* kIncludingHead = "#version 330 compatibility\n#include \"/settings.glsl\"\n";
constexpr const char* kMain = "void main() {}\n";

Files threePrograms() {
  return {{"/settings.glsl",
           "#define BLOOM // bloom\n#define Q 2 // [1 2 3]\n#define TINT 5 // [5 6]\n"
           "#define HUE (TINT * 2)\nconst int shadowMapResolution = 1024; // [1024 2048]\n"
           "#define MODE 0 // [0 1]\n"},
          {"/composite.fsh", std::string(kIncludingHead) + "#ifdef BLOOM\nfloat q = Q;\n#endif\n" + kMain},
          {"/composite1.fsh", std::string(kIncludingHead) + "float hue = HUE;\n" + kMain},
          {"/final.fsh", std::string(kIncludingHead) + "#if defined(BLOOM) && MODE == 1\n#endif\n" + kMain},
          {"/shaders.properties",
           "program.final.enabled = BLOOM\n#if MODE == 1\nblend.composite1 = off\n#endif\n"}};
}

LoadRequest requestOf(OptionValues values) {
  return {.values = std::move(values), .environment = standardMacros({})};
}

ShaderPack loadValid(const Files& files, OptionValues values = {}) {
  Diagnostics diagnostics;
  auto pack = loadShaderPack(memorySource(files), requestOf(std::move(values)), diagnostics);
  EXPECT_TRUE(pack) << (diagnostics.empty() ? "" : formatDiagnostic(diagnostics[0]));
  return std::move(*pack);
}

std::vector<std::string> optionsOf(const ShaderPack& pack, const char* program) {
  return pack.find(program)->options;
}

TEST(Rebuild, options_of_a_program_are_those_its_text_asks_for) {
  const ShaderPack pack = loadValid(threePrograms());
  EXPECT_THAT(optionsOf(pack, "composite"), ElementsAre("BLOOM", "Q", "shadowMapResolution"));
  EXPECT_THAT(optionsOf(pack, "composite1"), ElementsAre("TINT", "shadowMapResolution"));
  EXPECT_THAT(optionsOf(pack, "final"), ElementsAre("BLOOM", "MODE", "shadowMapResolution"));
  EXPECT_THAT(pack.find("composite")->conditionOptions, ElementsAre("BLOOM"));
  EXPECT_THAT(pack.builds[0]->properties().options, ElementsAre("BLOOM", "MODE"));
}

TEST(Rebuild, option_behind_another_is_not_asked_for_while_that_is_off) {
  const ShaderPack pack = loadValid(threePrograms(), {{"BLOOM", "false"}});
  EXPECT_THAT(optionsOf(pack, "composite"), ElementsAre("BLOOM", "shadowMapResolution"));
}

TEST(Rebuild, const_line_in_a_comment_counts) {
  const ShaderPack pack = loadValid(
      {{"/final.fsh", "#version 330\n/*\nconst float shadowDistance = 1.0; // [1.0 2.0]\n*/\n" +
                          std::string(kMain)}});
  EXPECT_THAT(optionsOf(pack, "final"), ElementsAre("shadowDistance"));
}

int rebuilt(const ShaderPack& pack, OptionValues values) {
  Diagnostics diagnostics;
  int count = -1;
  EXPECT_TRUE(rebuildShaderPack(pack, requestOf(std::move(values)), diagnostics, &count));
  return count;
}

TEST(Rebuild, switching_an_option_builds_only_the_programs_it_reaches) {
  const ShaderPack pack = loadValid(threePrograms());
  EXPECT_EQ(rebuilt(pack, {}), 0);
  EXPECT_EQ(rebuilt(pack, {{"Q", "3"}}), 1);
  EXPECT_EQ(rebuilt(pack, {{"TINT", "6"}}), 1);
  EXPECT_EQ(rebuilt(pack, {{"shadowMapResolution", "2048"}}), 3);
}

TEST(Rebuild, program_whose_properties_change_is_built_again) {
  const ShaderPack pack = loadValid(threePrograms());
  EXPECT_EQ(rebuilt(pack, {{"MODE", "1"}}), 2) << "final by its text, composite1 by its blend mode";
  EXPECT_EQ(rebuilt(pack, {{"BLOOM", "false"}}), 1) << "final is disabled";
  EXPECT_EQ(rebuilt(loadValid(threePrograms(), {{"BLOOM", "false"}}), {}), 2);
}

std::string packSummary(const ShaderPack& pack, const Diagnostics& diagnostics) {
  std::string text;
  for (const ProgramSource& program : pack.programs) {
    text += program.name + " " + std::to_string(program.hash) + "\n";
  }
  text += std::to_string(pack.directives.shadowMapResolution) + "\n";
  for (const Diagnostic& diagnostic : diagnostics) text += formatDiagnostic(diagnostic) + "\n";
  return text;
}

void expectSameAsFresh(const std::shared_ptr<const FileSource>& source, const ShaderPack& base,
                       const OptionValues& values) {
  Diagnostics fresh, again;
  LoadRequest request = requestOf(values);
  request.dimension = base.folder;
  const auto expected = loadShaderPack(source, request, fresh);
  const auto pack = rebuildShaderPack(base, request, again);
  ASSERT_EQ(bool(expected), bool(pack));
  // What reading the files found is reported once, by the first loadValid.
  std::erase_if(fresh, [](const Diagnostic& d) { return d.id.starts_with("option-"); });
  if (!pack) return;
  EXPECT_EQ(packSummary(*pack, again), packSummary(*expected, fresh));
}

/// Of each `step`th option of our pack, another value than its default.
void expectSameAsFreshForOptions(int step) {
  Diagnostics diagnostics;
  const std::shared_ptr<const FileSource> source =
      openPack(ORRIS_SOURCE_DIR "/shaderpack", diagnostics);
  ASSERT_TRUE(source);
  const auto base = loadShaderPack(source, requestOf({}), diagnostics);
  ASSERT_TRUE(base);
  int index = 0;
  for (const auto& [name, option] : base->options.all()) {
    if (index++ % step != 0) continue;
    const auto other = std::find_if(option.values.begin(), option.values.end(),
                                    [&](auto& value) { return value != option.defaultValue; });
    if (other == option.values.end()) continue;
    SCOPED_TRACE(name + "=" + *other);
    expectSameAsFresh(source, *base, {{name, *other}});
  }
}

TEST(Rebuild, equals_a_fresh_load_for_some_options_of_our_pack) { expectSameAsFreshForOptions(12); }

TEST(Rebuild, equals_a_fresh_load_for_every_option_of_our_pack) { expectSameAsFreshForOptions(1); }

/// Two programs that share a file, and one beside them.
Files sharedFile() {
  return {{"/lib/a.glsl", "#define Q 2 // [1 2 3]\n#include \"/lib/b.glsl\"\n"},
          {"/lib/b.glsl", "const int b = 1;\n"},
          {"/lib/c.glsl", "const int c = 1;\n"},
          {"/composite.fsh", "#version 330\n#include \"/lib/a.glsl\"\nvoid main() {}\n"},
          {"/composite1.fsh", "#version 330\n#include \"/lib/a.glsl\"\nvoid main() {}\n"},
          {"/composite1.vsh", "#version 330\nvoid main() {}\n"},
          {"/final.fsh", "#version 330\n#include \"/lib/c.glsl\"\nfloat q = Q;\nvoid main() {}\n"},
          {"/shaders.properties", "blend.final = off\n"}};
}

/// How many programs are built after an edit, which must give what a fresh load gives.
int builtAfter(Files edit, const std::set<std::string>& gone = {}) {
  Files files = sharedFile();
  LoadRequest request = requestOf({});
  request.keepGoing = true;
  Diagnostics before, fresh, again;
  const auto earlier = loadShaderPack(memorySource(files), request, before);
  for (auto& [file, text] : edit) files[file] = std::move(text);
  for (const std::string& file : gone) files.erase(file);
  const auto expected = loadShaderPack(memorySource(files), request, fresh);
  int built = -1;
  const auto pack =
      loadShaderPack(memorySource(files), request, {.earlier = &*earlier}, again, &built);
  EXPECT_EQ(packSummary(*pack, again), packSummary(*expected, fresh));
  for (std::size_t i = 0; i < expected->programs.size(); ++i) {
    EXPECT_EQ(pack->programs[i].options, expected->programs[i].options);
    EXPECT_EQ(pack->programs[i].incomplete, expected->programs[i].incomplete);
    EXPECT_EQ(pack->programs[i].misnames, expected->programs[i].misnames);
    EXPECT_EQ(pack->programs[i].blend.has_value(), expected->programs[i].blend.has_value());
  }
  return built;
}

TEST(RebuildAfterEdit, builds_the_programs_that_reach_the_edit) {
  EXPECT_EQ(builtAfter({}), 0);
  EXPECT_EQ(builtAfter({{"/lib/b.glsl", "const int b = 2;\n"}}), 2);
  EXPECT_EQ(builtAfter({{"/lib/c.glsl", "const int c = 2;\n"}}), 1);
  EXPECT_EQ(builtAfter({{"/lib/unused.glsl", "const int d = 2;\n"}}), 0);
  EXPECT_EQ(builtAfter({{"/composite1.fsh", "#version 330\n#error stop\nvoid main() {}\n"}}), 1);
}

TEST(RebuildAfterEdit, notices_stages_and_files_that_come_and_go) {
  EXPECT_EQ(builtAfter({{"/final.vsh", "#version 330\nvoid main() {}\n"}}), 1);
  EXPECT_EQ(builtAfter({{"/deferred.fsh", "#version 330\nvoid main() {}\n"}}), 1);
  EXPECT_EQ(builtAfter({}, {"/composite.fsh"}), 0);
  EXPECT_EQ(builtAfter({}, {"/composite1.vsh"}), 1) << "the host's own vertex shader takes its place";
  EXPECT_EQ(builtAfter({}, {"/lib/b.glsl"}), 2) << "both are incomplete";
  EXPECT_EQ(builtAfter({}, {"/lib/c.glsl"}), 1);
  EXPECT_EQ(builtAfter({{"/lib/B.glsl", "const int b = 1;\n"}}, {"/lib/b.glsl"}), 2) << "capitals";
  EXPECT_EQ(builtAfter({{"/lib/b.glsl", "#include \"/lib/c.glsl\"\n"}}), 2);
}

TEST(RebuildAfterEdit, notices_options_and_properties) {
  EXPECT_EQ(builtAfter({{"/lib/c.glsl", "#define Z 1 // [1 2]\n"}}), 3)
      << "what is an option decides of what every program depends on";
  EXPECT_EQ(builtAfter({{"/lib/a.glsl", "#define Q 3 // [1 2 3]\n#include \"/lib/b.glsl\"\n"}}), 2);
  EXPECT_EQ(builtAfter({{"/shaders.properties", ""}}), 1) << "the blend mode is of final";
  EXPECT_EQ(builtAfter({{"/shaders.properties", "blend.final = off\niris.features.optional = SSBO\n"}}), 3)
      << "a feature is a macro of every program";
}

TEST(RebuildAfterEdit, builds_only_what_is_wanted) {
  Diagnostics diagnostics;
  const auto pack = loadShaderPack(
      memorySource(sharedFile()), requestOf({}),
      {.wanted = [](const ProgramEntry& entry) { return entry.name.program == "final"; }}, diagnostics);
  ASSERT_TRUE(pack);
  ASSERT_EQ(pack->programs.size(), 1u);
  EXPECT_EQ(pack->programs[0].name, "final");
}

TEST(Rebuild, broken_files_do_not_hide_each_other_when_the_load_keeps_going) {
  Diagnostics diagnostics;
  LoadRequest request = requestOf({});
  request.keepGoing = true;
  const auto pack = loadShaderPack(
      memorySource({{"/composite.fsh", "#version 330\n#include \"/gone.glsl\"\nvoid main() {}\n"},
                    {"/final.fsh", "#version 330\n#error stop\n"},
                    {"/shaders.properties", "blend.final = ONE\n"}}),
      request, diagnostics);
  ASSERT_TRUE(pack);
  std::vector<std::string> ids;
  for (const Diagnostic& diagnostic : diagnostics) ids.push_back(diagnostic.id);
  EXPECT_THAT(ids, ElementsAre("include-missing", "blend-syntax", "directive-error"));
}

}  // namespace
}  // namespace orris
