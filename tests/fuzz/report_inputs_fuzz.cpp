// libFuzzer target: what reports read, over arbitrary bytes: ignore comments, baselines, game logs.
#include <cstddef>
#include <cstdint>
#include <string>

#include <orris/check/logs/game_log.h>
#include <orris/check/logs/log_place.h>
#include <orris/check/logs/token_alignment.h>
#include <orris/report/baseline.h>
#include <orris/report/ignore_comments.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orris;
  const std::string text(reinterpret_cast<const char*>(data), size);
  readIgnoreMarks("/a.fsh", text);
  readIgnoreMarks("/a.properties", text);
  IgnoreComments comments(*memorySource({{"/a.fsh", text}, {"/b.lang", text}}));
  comments.silences({.id = "glsl-compile", .at = {"/a.fsh", 1, 1}});
  for (const Diagnostic& problem : comments.problems()) fingerprintOf(problem);

  Diagnostics diagnostics;
  if (auto baseline = Baseline::parse("known", text, diagnostics)) baseline->take(text);
  for (const LogSection& section : parseGameLog(text)) {
    shaderOfLogName(section.name);
    namesInMessage(section.text);
  }
  std::vector<std::string_view> tokens, reversed;
  for (std::size_t i = 0; i < text.size(); ++i)
    tokens.push_back(std::string_view(text).substr(i, 1));
  reversed.assign(tokens.rbegin(), tokens.rend());
  alignTokens(tokens, reversed);
  return 0;
}
