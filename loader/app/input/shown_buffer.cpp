#include "app/input/shown_buffer.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kChannels = "rgba";
constexpr long long kMostSlices = 1 << 15;
constexpr long long kFarthestByte = 1LL << 40;

std::optional<std::pair<float, float>> parseRange(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const auto low = parseFloat(text.substr(0, dots)), high = parseFloat(text.substr(dots + 2));
  const bool usable = low && high && std::isfinite(*low) && std::isfinite(*high) && *low < *high;
  if (!usable) return std::nullopt;
  return std::pair(*low, *high);
}

/// "mip3" with "mip": 3.
std::optional<long long> parseCounted(std::string_view word, std::string_view name, long long most) {
  if (!word.starts_with(name)) return std::nullopt;
  const auto number = parseInteger(word.substr(name.size()));
  return number && *number >= 0 && *number <= most ? number : std::nullopt;
}

bool takeWord(std::string_view word, ShownBuffer& shown) {
  using Side = BufferRequest::Side;
  BufferRequest& what = shown.what;
  ValuePaint& how = shown.how;
  if (word == "main" || word == "alt") {
    what.side = word == "alt" ? Side::Alt : Side::Main;
  } else if (word == "rgb") {
    how.channel = -1;
  } else if (word.size() == 1 && kChannels.find(word[0]) != std::string_view::npos) {
    how.channel = int(kChannels.find(word[0]));
  } else if (word == "false") {
    how.falseColor = true;
  } else if (word == "signed") {
    how.markNegative = false;
  } else if (const auto level = parseCounted(word, "mip", 30)) {
    what.level = int(*level);
  } else if (const auto slice = parseCounted(word, "slice", kMostSlices)) {
    what.slice = int(*slice);
  } else if (const auto at = parseCounted(word, "at", kFarthestByte)) {
    what.offset = std::size_t(*at);
  } else if (const auto range = parseRange(word)) {
    how.range = range;
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::optional<ShownBuffer> parseShown(const std::string& text, std::string& problem) {
  ShownBuffer shown;
  const std::vector<std::string_view> words = splitAt(text, ':');
  const std::string first(words.front());
  const std::size_t at = first.find('@');
  shown.what.buffer = first.substr(0, at);
  if (at != std::string::npos) shown.what.step = first.substr(at + 1);
  if (shown.what.buffer.empty() || (at != std::string::npos && shown.what.step.empty())) {
    problem = fmt::format("\"{}\" names no buffer: write colortex0, or colortex0@composite", first);
    return std::nullopt;
  }
  for (std::size_t i = 1; i < words.size(); ++i)
    if (!takeWord(words[i], shown)) {
      problem = fmt::format(
          "\"{}\" is none of main, alt, mipN, sliceN, atN, rgb, r, g, b, a, LOW..HIGH, false, signed",
          words[i]);
      return std::nullopt;
    }
  return shown;
}

std::string shownText(const ShownBuffer& shown) {
  using Side = BufferRequest::Side;
  const BufferRequest& what = shown.what;
  const ValuePaint& how = shown.how;
  std::string text = what.buffer;
  if (!what.step.empty()) text += "@" + what.step;
  if (what.side != Side::Written) text += what.side == Side::Alt ? ":alt" : ":main";
  if (what.level > 0) text += fmt::format(":mip{}", what.level);
  if (what.slice > 0) text += fmt::format(":slice{}", what.slice);
  if (what.offset > 0) text += fmt::format(":at{}", what.offset);
  if (how.channel >= 0) text += fmt::format(":{}", kChannels[std::size_t(how.channel)]);
  if (how.range) text += fmt::format(":{}..{}", how.range->first, how.range->second);
  if (how.falseColor) text += ":false";
  if (!how.markNegative) text += ":signed";
  return text;
}

nlohmann::json toJson(const BufferView& view, const ValuePaint& how) {
  nlohmann::json json = {{"buffer", view.side.name}};
  if (view.pixels.pixels.empty()) {
    json["bytes"] = view.bytes;
    json["offset"] = view.offset;
    json["words"] = view.words;
    return json;
  }
  const ValueFacts facts = valueFacts(view.pixels);
  const auto channels = std::size_t(facts.channels);
  const auto [low, high] = paintedRange(view.pixels, how);
  json.update({{"side", view.side.alt ? "alt" : "main"},
               {"width", view.pixels.width},
               {"height", view.pixels.height},
               {"mip", view.level},
               {"mips", view.levels},
               {"slice", view.slice},
               {"slices", view.slices},
               {"low", std::vector<float>(facts.low.begin(), facts.low.begin() + std::ptrdiff_t(channels))},
               {"high", std::vector<float>(facts.high.begin(), facts.high.begin() + std::ptrdiff_t(channels))},
               {"nan", facts.nan},
               {"infinite", facts.infinite},
               {"negative", facts.negative},
               {"range", {low, high}}});
  return json;
}

std::string storageTable(const BufferView& view) {
  std::string table = "byte,word,int,float,hexadecimal\n";
  for (std::size_t i = 0; i < view.words.size(); ++i) {
    const std::uint32_t word = view.words[i];
    table += fmt::format("{},{},{},{:.9g},{:#010x}\n", view.offset + i * sizeof word, word,
                         std::int32_t(word), std::bit_cast<float>(word), word);
  }
  return table;
}

}  // namespace orris
