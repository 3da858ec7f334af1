#include <orris/world/saved_things/saved_text.h>
#include <orris/world/saved_things/saved_things.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace orris {
namespace {

constexpr std::int64_t kFarthestSign = 30'000'000;  // the game's border, blocks

struct TextColour {
  std::string_view dye;
  std::uint32_t rgb;
};
// The game's colours of dyed texts.
constexpr TextColour kTextColours[] = {
    {"white", 0xffffff},      {"orange", 0xff681f}, {"magenta", 0xff00ff}, {"light_blue", 0x9ac0cd},
    {"yellow", 0xffff00},     {"lime", 0xbfff00},   {"pink", 0xff69b4},    {"gray", 0x808080},
    {"light_gray", 0xd3d3d3}, {"cyan", 0x00ffff},   {"purple", 0xa020f0},  {"blue", 0x0000ff},
    {"brown", 0x8b4513},      {"green", 0x00ff00},  {"red", 0xff0000},     {"black", 0x000000}};

/// Text that does not glow is darker.
glm::vec3 dyedColour(const std::string& dye, bool glows) {
  constexpr float kDullShare = 0.4f;
  const auto* found = std::ranges::find(kTextColours, dye, &TextColour::dye);
  if (found == std::end(kTextColours)) return glm::vec3(0);
  const glm::vec3 colour(float(found->rgb >> 16), float(found->rgb >> 8 & 255),
                         float(found->rgb & 255));
  return colour / 255.0f * (glows ? 1.0f : kDullShare);
}

bool isBlank(const SignSide& side) {
  return std::ranges::all_of(side.lines, [](const std::string& line) { return line.empty(); });
}

/// A side of 1.20 and later.
SignSide signSide(const NbtTag& sign, std::string_view name) {
  SignSide side;
  const NbtTag* text = sign.find(name);
  const NbtList* lines = text ? text->listAt("messages") : nullptr;
  if (!lines) return side;
  for (std::size_t i = 0; i < std::min(lines->size(), side.lines.size()); ++i)
    side.lines[i] = drawnText((*lines)[i]);
  side.color = dyedColour(text->stringAt("color"), text->integerAt("has_glowing_text") != 0);
  return side;
}

/// The one side of games before.
SignSide onlySide(const NbtTag& sign) {
  constexpr const char* kLines[] = {"Text1", "Text2", "Text3", "Text4"};
  SignSide side;
  for (std::size_t i = 0; i < side.lines.size(); ++i) {
    if (const NbtTag* line = sign.find(kLines[i])) side.lines[i] = drawnText(*line);
  }
  side.color = dyedColour(sign.stringAt("Color"), sign.integerAt("GlowingText") != 0);
  return side;
}

void readSign(const NbtTag& tag, SavedThings& things) {
  SavedSign sign;
  if (tag.find("front_text") || tag.find("back_text")) {
    sign.front = signSide(tag, "front_text");
    sign.back = signSide(tag, "back_text");
  } else {
    sign.front = onlySide(tag);
  }
  if (isBlank(sign.front) && isBlank(sign.back)) return;
  int axis = 0;
  for (const char* name : {"x", "y", "z"}) {
    const NbtTag* member = tag.find(name);
    if (!member || !member->integer() || *member->integer() < -kFarthestSign ||
        *member->integer() > kFarthestSign) {
      ++things.damaged;
      return;
    }
    sign.at[axis++] = int(*member->integer());
  }
  things.signs.push_back(std::move(sign));
}

/// Where a kind of sign has its text; in blocks, from the middle of the block's floor.
struct SignBoard {
  std::string_view ending;  ///< of the block's name
  float front, back;        ///< of its sides, along where it faces
  float middle;             ///< height
  float line, capital;      ///< heights
  float width;
};
constexpr SignBoard kBoards[] = {
    {"_wall_hanging_sign", 1 / 16.0f, -1 / 16.0f, 5 / 16.0f, 0.1266f, 0.0984f, 0.84f},
    {"_hanging_sign", 1 / 16.0f, -1 / 16.0f, 5 / 16.0f, 0.1266f, 0.0984f, 0.84f},
    {"_wall_sign", -6 / 16.0f, -8 / 16.0f, 8.5f / 16, 0.1042f, 0.0729f, 0.94f},
    {"_sign", 0.75f / 16, -0.75f / 16, 12.5f / 16, 0.1042f, 0.0729f, 0.94f}};

/// As the board is drawn: by quarters.
int facingQuarter(const BlockState& state) {
  constexpr std::string_view kFacings[] = {"south", "west", "north", "east"};
  constexpr int kNorth = 2;
  const std::string_view rotation = state.property("rotation");
  int sixteenths = 0;
  if (std::from_chars(rotation.data(), rotation.data() + rotation.size(), sixteenths).ec ==
          std::errc() &&
      sixteenths >= 0 && sixteenths < 16)
    return (sixteenths + 2) / 4 % 4;
  const auto* found = std::ranges::find(kFacings, state.property("facing"));
  return found == std::end(kFacings) ? kNorth : int(found - std::begin(kFacings));
}

void addSide(const SignSide& side, const SignBoard& board, float distance, float yaw,
             const glm::ivec3& at, std::vector<BlockText>& texts) {
  constexpr double kFirstLine = 1.5;  // over the middle
  const double turn = glm::radians(double(yaw));
  const glm::dvec3 front(-std::sin(turn), 0, std::cos(turn));
  for (std::size_t i = 0; i < side.lines.size(); ++i) {
    const std::string& line = side.lines[i];
    if (line.empty()) continue;
    BlockText text{line,          at,        glm::dvec3(at) + glm::dvec3(0.5, 0, 0.5), yaw,
                   board.capital, side.color};
    text.position += front * double(distance);
    text.position.y += board.middle + (kFirstLine - double(i)) * board.line;
    text.size = std::min(text.size, board.width / (kGlyphAdvance * float(line.size())));
    texts.push_back(std::move(text));
  }
}

}  // namespace

void readSigns(const NbtList& list, SavedThings& things) {
  for (const NbtTag& tag : list) readSign(tag, things);
}

std::vector<BlockText> textsOf(const SavedSign& sign, const BlockState& state) {
  constexpr float kBefore = 0.006f;  // so that the board does not cut the text, blocks
  std::vector<BlockText> texts;
  const auto* board = std::ranges::find_if(
      kBoards, [&](const SignBoard& candidate) { return state.name.ends_with(candidate.ending); });
  if (board == std::end(kBoards)) return texts;
  const float yaw = float(facingQuarter(state)) * 90;
  addSide(sign.front, *board, board->front + kBefore, yaw, sign.at, texts);
  addSide(sign.back, *board, -board->back + kBefore, yaw < 180 ? yaw + 180 : yaw - 180, sign.at,
          texts);
  return texts;
}

}  // namespace orris
