#include "app/window/rich_text.h"

#include <cctype>
#include <optional>

namespace orris {
namespace {

constexpr std::string_view kSection = "\xC2\xA7";  // § in UTF-8
constexpr std::uint32_t kWhite = 0xFFFFFF;

// The game's sixteen colours, by the hexadecimal digit of their code.
constexpr std::uint32_t kColors[] = {0x000000, 0x0000AA, 0x00AA00, 0x00AAAA, 0xAA0000, 0xAA00AA,
                                     0xFFAA00, 0xAAAAAA, 0x555555, 0x5555FF, 0x55FF55, 0x55FFFF,
                                     0xFF5555, 0xFF55FF, 0xFFFF55, 0xFFFFFF};

std::optional<std::uint32_t> codeColor(char code) {
  if (code >= '0' && code <= '9') return kColors[code - '0'];
  if (code >= 'a' && code <= 'f') return kColors[code - 'a' + 10];
  return std::nullopt;
}

}  // namespace

std::vector<TextRun> textRuns(std::string_view text) {
  std::vector<TextRun> runs;
  TextRun run;
  const auto close = [&] {
    if (!run.text.empty()) runs.push_back(run);
    run.text.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isCode = text.substr(i).starts_with(kSection) && i + kSection.size() < text.size();
    if (!isCode) {
      run.text += text[i];
      continue;
    }
    i += kSection.size();
    const char code = char(std::tolower(static_cast<unsigned char>(text[i])));
    close();
    if (const auto color = codeColor(code)) {
      run.color = *color;
      run.bold = false;
    } else if (code == 'l') {
      run.bold = true;
    } else if (code == 'r') {
      run.color = kWhite;
      run.bold = false;
    }
  }
  close();
  return runs;
}

std::string withoutCodes(std::string_view text) {
  std::string plain;
  for (const TextRun& run : textRuns(text)) plain += run.text;
  return plain;
}

}  // namespace orris
