// libFuzzer target: preprocess, rewrite, print and the properties preprocessor over arbitrary bytes.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/glsl/rewrite/rewrite.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orris;
  if (size == 0) return 0;
  constexpr int kStages = 6;
  const auto stage = static_cast<Stage>(data[0] % kStages);
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  FlatSource source;
  source.sites = {{"/fuzz.fsh", -1, 0}};
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) source.own(line, 0, ++number);

  const MacroDefinitions environment = {{"MC_VERSION", "12101"}, {"IS_IRIS", ""}};
  Diagnostics diagnostics;
  TokenStream tokens = preprocess(source, environment, diagnostics);
  rewrite(tokens, stage);
  const MappedText printed = print(tokens);
  for (int line = 0; line <= static_cast<int>(printed.lines.size()) + 1; ++line) {
    printed.locate(line, 1);
    printed.includedFrom(line, 0);
  }
  preprocessProperties("/fuzz.properties", text, environment, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics) formatDiagnostic(diagnostic);
  return 0;
}
