#include <fmt/format.h>
#include <gmock/gmock.h>

#include "check/matrix_run.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Files = std::map<std::string, std::string>;

constexpr const char* kVersion = "#version 330 compatibility\n";

/// A pack as the command loads it, and what its matrix says.
struct Matrix {
  MatrixResult result;
  Diagnostics told;
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
    auto pack = loadShaderPack(source, load, matrix.told);
    EXPECT_TRUE(pack);
    if (!pack) return matrix;
    names = pack->dimensions;
    checkWithGlslang(*pack, 2, verdicts, matrix.told);
    folders.push_back(std::move(*pack));
  }
  matrix.result = runMatrix({folders, load.environment, verdicts, matrix.told}, request,
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
          {"/final.fsh", std::string(kVersion) +
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
    {"/world0/composite.fsh", std::string(kVersion) +
                                  "#include \"/lib/settings.glsl\"\n#include \"/lib/water.glsl\"\n"
                                  "void main() { gl_FragColor = vec4(1.0); }\n"},
    {"/world1/composite.fsh", std::string(kVersion) +
                                  "#define END\n#include \"/lib/settings.glsl\"\n"
                                  "#include \"/lib/water.glsl\"\nvoid main() {\n#if MODE >= 2 && "
                                  "defined SHARP\ngl_FragColor = none;\n#elif MODE == 1\n#error "
                                  "mode 1 needs nothing\n#endif\n}\n"}};

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

TEST(Matrix, what_fails_with_the_values_in_force_is_not_told_again) {
  const Matrix matrix = run(kTwoFolders, {.kind = MatrixKind::Each}, {{"WATER", "true"}});
  EXPECT_TRUE(hasErrors(matrix.told));
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
           {"/final.fsh", std::string(kVersion) + "#include \"/settings.glsl\"\nvoid main() {}\n"},
           {"/composite.fsh", std::string(kVersion) + "void main() { lost(); }\n"},
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

}  // namespace
}  // namespace orris
