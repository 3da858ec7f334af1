#include <fmt/format.h>
#include <gmock/gmock.h>

#include <orris/check/matrix/matrix_causes.h>
#include <orris/check/matrix/matrix_run.h>
#include "text_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A pack as the command loads it, and what its matrix says.
struct Matrix {
  MatrixResult result;
  Diagnostics reported;
  std::vector<std::string> texts() const {
    std::vector<std::string> list;
    for (const Diagnostic& diagnostic : result.diagnostics) {
      list.push_back(formatDiagnostic(diagnostic));
    }
    return list;
  }
};

Matrix run(const Files& files, MatrixRequest request, OptionValues values = {}) {
  Matrix matrix;
  const std::shared_ptr<const FileSource> source = memorySource(files);
  LoadRequest load{.values = std::move(values), .environment = standardMacros({})};
  load.keepGoing = true;
  load.dimension = "/";
  std::vector<ShaderPack> folders;
  Verdicts verdicts;
  std::vector<std::string> names{"/"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    load.dimension = names[i];
    auto pack = loadShaderPack(source, load, matrix.reported);
    EXPECT_TRUE(pack);
    if (!pack) return matrix;
    names = pack->dimensions;
    checkWithGlslang(*pack, 2, verdicts, matrix.reported);
    folders.push_back(std::move(*pack));
  }
  matrix.result = runMatrix({folders, load.environment, verdicts, matrix.reported}, request,
                            [](std::size_t, std::size_t) {});
  return matrix;
}

/// Sixty options; OPT_7 and VAL_3=2 break final together.
Files plantedPack() {
  std::string settings, uses;
  for (int i = 0; i < 40; ++i) {
    settings += fmt::format("//#define OPT_{}\n", i);
    uses += fmt::format("#ifdef OPT_{}\nc += {}.0;\n#endif\n", i, i);
  }
  for (int i = 0; i < 20; ++i) {
    settings += fmt::format("#define VAL_{} 0 // [0 1 2]\n", i);
    uses += fmt::format("c += float(VAL_{});\n", i);
  }
  return {{"/settings.glsl", settings},
          {"/final.fsh", kVersion +
                             "#include \"/settings.glsl\"\nvoid main() {\n"
                             "float c = 0.0;\n" +
                             uses +
                             "#if defined OPT_7 && VAL_3 == 2\nc += lost;\n#endif\n"
                             "gl_FragColor = vec4(c);\n}\n"}};
}

TEST(Matrix, pairwise_finds_and_minimises_what_two_of_sixty_options_break) {
  const Matrix matrix = run(plantedPack(), {.kind = MatrixKind::Pairwise, .jobs = 2});
  ASSERT_EQ(matrix.result.diagnostics.size(), 1u);
  const Diagnostic& found = matrix.result.diagnostics[0];
  EXPECT_EQ(found.at, (SourceLocation{"/final.fsh", 146, 6}));
  EXPECT_EQ(found.message, "'lost' : undeclared identifier");
  ASSERT_EQ(found.notes.size(), 1u);
  EXPECT_THAT(found.notes[0],
              testing::StartsWith("fails if and only if OPT_7=true and VAL_3=2; via /final (1 "
                                  "program, "));
  EXPECT_EQ(matrix.result.tried, matrix.result.configurations);
  EXPECT_LT(matrix.result.configurations, 40u);
  EXPECT_LT(matrix.result.seconds, 10);
}

TEST(Matrix, each_value_alone_does_not_find_it) {
  const Matrix matrix = run(plantedPack(), {.kind = MatrixKind::Each, .jobs = 2});
  EXPECT_THAT(matrix.texts(), IsEmpty());
  EXPECT_EQ(matrix.result.configurations, 40u + 2 * 20u);
  EXPECT_EQ(matrix.result.compiled, 40u + 20u);  // 1 and 2 in the same place make no difference
}

TEST(Matrix, only_named_options_are_varied) {
  const Matrix matrix =
      run(plantedPack(), {.kind = MatrixKind::Pairwise, .options = {"OPT_7", "VAL_3"}});
  EXPECT_EQ(matrix.result.configurations, 5u);
  EXPECT_EQ(matrix.result.diagnostics.size(), 1u);
}

const Files kTwoFolders{
    {"/lib/water.glsl", "#ifdef WATER\nfloat w = wave;\n#endif\n"},
    {"/lib/settings.glsl",
     "//#define WATER\n#define MODE 0 // [0 1 2 3]\n#define SHARP\n#ifdef SHARP\n#endif\n"},
    {"/world0/composite.fsh", kVersion +
                                  "#include \"/lib/settings.glsl\"\n#include \"/lib/water.glsl\"\n"
                                  "void main() { gl_FragColor = vec4(1.0); }\n"},
    {"/world1/composite.fsh", kVersion +
                                  "#define END\n#include \"/lib/settings.glsl\"\n"
                                  "#include \"/lib/water.glsl\"\nvoid main() {\n#if MODE >= 2 && "
                                  "defined SHARP\ngl_FragColor = none;\n#elif MODE == 1\n#error "
                                  "mode 1 needs nothing\n#endif\n}\n"}};

TEST(Matrix, only_what_a_player_can_choose_is_varied) {
  Files files{{"/final.vsh", kVersion + "#define STAGE_A\nvoid main() {\n#ifdef STAGE_A\n"
                                        "  gl_Position = ftransform();\n#endif\n}\n"},
              {"/final.fsh",
               kVersion + "#define SHOWN\n#define PROFILED\n#define HIDDEN\n"
                          "#ifdef SHOWN\n#endif\n#ifdef PROFILED\n#endif\n#ifdef HIDDEN\n#endif\n"
                          "#include \"/lib.glsl\"\n#include \"/lib.glsl\"\n"
                          "void main() { gl_FragColor = vec4(f()); }\n"},
              {"/lib.glsl", "#ifndef GUARD\n#define GUARD\nfloat f() { return 1.0; }\n#endif\n"}};
  // Without screens the game shows all; a guard is none to be chosen.
  EXPECT_EQ(run(files, {.kind = MatrixKind::Each}).result.configurations, 4u);
  EXPECT_THAT(run(files, {.kind = MatrixKind::Each}).texts(), IsEmpty());
  files["/shaders.properties"] = "screen = SHOWN\nprofile.LOW = !PROFILED\n";
  EXPECT_EQ(run(files, {.kind = MatrixKind::Each}).result.configurations, 2u);
  EXPECT_EQ(run(files, {.kind = MatrixKind::Each, .options = {"GUARD"}}).texts().size(), 1u);
}

TEST(Matrix, one_report_for_each_mistake_whatever_the_folder_in_file_order) {
  const Matrix matrix = run(kTwoFolders, {.kind = MatrixKind::Each, .jobs = 2});
  EXPECT_THAT(
      matrix.texts(),
      ElementsAre(
          "/lib/water.glsl:2:11: error: 'wave' : undeclared identifier\n"
          "  included from /world0/composite.fsh:3\n  float w = wave;\n            ^\n"
          "  note: fails if and only if WATER=true; via /world0/composite (2 programs, 1 "
          "configuration)",
          "/world1/composite.fsh:7:16: error: 'none' : undeclared identifier\n"
          "  gl_FragColor = none;\n                 ^\n"
          "  note: fails if and only if MODE is 2 or 3 and SHARP=true; via /world1/composite (1 "
          "program, 2 configurations)",
          "/world1/composite.fsh:9:1: error: #error mode 1 needs nothing\n"
          "  #error mode 1 needs nothing\n  ^\n"
          "  note: fails if and only if MODE=1; via /world1/composite (1 program, 1 "
          "configuration)\n  hint: the pack itself refuses these values with #error"));
}

TEST(Matrix, report_is_the_same_for_any_number_of_processes) {
  const auto one = run(kTwoFolders, {.kind = MatrixKind::Pairwise, .jobs = 1}).texts();
  const auto four = run(kTwoFolders, {.kind = MatrixKind::Pairwise, .jobs = 4}).texts();
  EXPECT_EQ(one, four);
  EXPECT_FALSE(one.empty());
}

TEST(Matrix, what_fails_with_the_values_in_force_is_not_reported_again) {
  const Matrix matrix = run(kTwoFolders, {.kind = MatrixKind::Each}, {{"WATER", "true"}});
  EXPECT_TRUE(hasErrors(matrix.reported));
  for (const Diagnostic& diagnostic : matrix.result.diagnostics) {
    EXPECT_NE(diagnostic.at.file, "/lib/water.glsl");
  }
}

TEST(Matrix, shards_share_the_configurations) {
  std::size_t configurations = 0, failures = 0;
  for (int shard = 1; shard <= 3; ++shard) {
    const Matrix matrix = run(kTwoFolders, {.kind = MatrixKind::Each, .shard = shard, .shards = 3});
    configurations += matrix.result.configurations;
    failures += matrix.result.diagnostics.size();
  }
  EXPECT_EQ(configurations, 5u);
  EXPECT_GE(failures, 3u);
}

TEST(Matrix, properties_under_other_values_are_checked_and_enable_programs) {
  const Matrix matrix =
      run({{"/settings.glsl", "//#define GLOW\n#ifdef GLOW\n#endif\n"},
           {"/final.fsh", kVersion + "#include \"/settings.glsl\"\nvoid main() {}\n"},
           {"/composite.fsh", kVersion + "void main() { lost(); }\n"},
           {"/shaders.properties",
            "program.composite.enabled=GLOW\n#ifdef GLOW\nblend.final=ONE\n#endif\n"}},
          {.kind = MatrixKind::Each});
  std::vector<std::string> places;
  for (const Diagnostic& diagnostic : matrix.result.diagnostics) {
    places.push_back(diagnostic.at.file + " " + diagnostic.notes.at(0));
  }
  EXPECT_THAT(places,
              ElementsAre("/composite.fsh fails if and only if GLOW=true; via /composite (1 "
                          "program, 1 configuration)",
                          "/shaders.properties fails if and only if GLOW=true; 1 configuration"));
}

/// final with twenty values of SIZE, and `text`.
Files sliderPack(const std::string& text) {
  std::string values;
  for (int i = 1; i <= 20; ++i) values += fmt::format(" {}", i);
  return {{"/final.fsh", kVersion + "#define SIZE 3 // [" + values + "]\n" + "void main() {\n" +
                             text + "gl_FragColor = vec4(SIZE);\n}\n"}};
}

TEST(Matrix, numbers_that_cannot_decide_are_not_compiled_again) {
  const Matrix matrix = run(sliderPack(""), {.kind = MatrixKind::Each, .jobs = 2});
  EXPECT_EQ(matrix.result.configurations, 19u);
  EXPECT_EQ(matrix.result.tried, 19u);
  EXPECT_EQ(matrix.result.compiled, 0u);
}

TEST(Matrix, numbers_that_may_decide_are_compiled_each) {
  const Matrix matrix =
      run(sliderPack("float a[SIZE];\na[6] = 1.0;\n"), {.kind = MatrixKind::Each, .jobs = 2});
  EXPECT_EQ(matrix.result.compiled, 19u);
  // With the values in force it fails as well, which is reported there, in other words.
  ASSERT_EQ(matrix.reported.size(), 1u);
  EXPECT_EQ(matrix.reported[0].message, "'[' :  array index out of range '6'");
}

TEST(Matrix, numbers_of_which_a_condition_hears_by_another_name_are_all_tried) {
  const Matrix matrix = run(sliderPack("#define HALF (SIZE / 2)\n#if HALF == 7\nlost;\n#endif\n"),
                            {.kind = MatrixKind::Each, .jobs = 2});
  ASSERT_EQ(matrix.texts().size(), 1u);
  EXPECT_THAT(matrix.result.diagnostics[0].notes.at(0),
              testing::StartsWith("fails if and only if SIZE is 14 or 15; via /final"));
  EXPECT_EQ(matrix.result.compiled, 1u);
}

TEST(Matrix, a_number_pasted_into_a_name_is_seen) {
  const Matrix matrix = run(sliderPack("#define CAT(a, b) a##b\n#define NAME(b) CAT(x, b)\n"
                                       "float x1, x2, x3, x4, x5, x6, x7;\nNAME(SIZE) = 1.0;\n"),
                            {.kind = MatrixKind::Each, .jobs = 2});
  EXPECT_EQ(matrix.result.compiled, 19u);
  EXPECT_EQ(matrix.result.diagnostics.size(), 13u);  // 'x8' : undeclared identifier, ...
}

TEST(Matrix, only_stages_that_an_option_reaches_are_looked_at) {
  const Files files{
      {"/final.fsh", kVersion + "//#define RED\nin float x;\nvoid main() {\n#ifdef RED\n"
                                "gl_FragColor = vec4(x);\n#endif\n}\n"},
      {"/final.vsh", kVersion + "//#define RED\nout float x;\nvoid main() { x = 1.0; }\n"},
      {"/composite.fsh", kVersion + "void main() {}\n"}};
  const Matrix matrix = run(files, {.kind = MatrixKind::Each});
  EXPECT_EQ(matrix.result.variants, 1u);
  EXPECT_EQ(matrix.result.compiled, 1u);
  EXPECT_THAT(matrix.texts(), IsEmpty());
}

/// SLOW makes glslang compare each function with each; LOST is a mistake.
Files stallingPack() {
  constexpr int kFunctions = 20'000;
  std::string functions = "float f0() { return 1.0; }\n";
  for (int i = 1; i < kFunctions; ++i) {
    functions += fmt::format("float f{}() {{ return f{}(); }}\n", i, i - 1);
  }
  return {{"/final.fsh",
           kVersion + "//#define SLOW\n#ifdef SLOW\n" + functions +
               fmt::format("#define F f{}()\n#else\n#define F 1.0\n#endif\n", kFunctions - 1) +
               "void main() { gl_FragColor = vec4(F); }\n"},
          {"/composite.fsh",
           kVersion + "//#define LOST\nvoid main() {\n#ifdef LOST\nlost;\n#endif\n}\n"}};
}

TEST(Matrix, its_time_ends_whatever_the_compiler_does) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  const Matrix matrix = run(stallingPack(), {.kind = MatrixKind::Each, .until = until, .jobs = 2});
  EXPECT_LT(std::chrono::steady_clock::now(), until + std::chrono::seconds(20));  // SLOW: minutes
  EXPECT_EQ(matrix.result.configurations, 2u);
  EXPECT_EQ(matrix.result.tried, 1u);
  ASSERT_EQ(matrix.result.diagnostics.size(), 1u);
  EXPECT_THAT(matrix.result.diagnostics[0].notes.at(0),
              testing::StartsWith("fails if and only if LOST=true; via /composite"));
}

TEST(Matrix, without_time_it_says_that_it_tried_nothing) {
  const Matrix matrix =
      run(plantedPack(), {.kind = MatrixKind::Each, .until = std::chrono::steady_clock::now()});
  EXPECT_EQ(matrix.result.configurations, 80u);
  EXPECT_EQ(matrix.result.tried, 0u);
}

TEST(Matrix, cause_that_time_was_too_short_for_is_reported_as_not_minimised) {
  Diagnostics reported;
  auto pack =
      loadShaderPack(memorySource(plantedPack()), {.environment = standardMacros({})}, reported);
  ASSERT_TRUE(pack);
  const Verdicts verdicts;
  const std::vector<ShaderPack> folders{*pack};
  const MatrixBase base{folders, standardMacros({}), verdicts, reported};
  MatrixPlan plan = planMatrix(base, {.kind = MatrixKind::Each});
  plan.configurations[plan.jobs[0].configuration] = {{"OPT_7", "true"}, {"VAL_3", "2"}};
  const BaseShapes shapes(base, plan);
  SharedHashes seen(100);
  MatrixWorker worker(plan, shapes, base.environment, seen);
  std::vector<MatrixFailure> failures{{.jobs = {0}}};
  explainFailures({.plan = plan, .worker = worker, .until = std::chrono::steady_clock::now()},
                  failures);
  EXPECT_THAT(failures[0].diagnostic.notes,
              ElementsAre("fails with OPT_7=true, VAL_3=2 (not minimised for want of time); via "
                          "/final (1 program, 1 configuration)"));
}

}  // namespace
}  // namespace orris
