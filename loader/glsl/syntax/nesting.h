// Which mark of a nesting (braces, #if blocks) is missing: found by how well the layout fits the pairs
// that remain when it is put back at one place or another.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace orris {

/// The indent of a stretch without lines.
inline constexpr int kNoLines = 1 << 20;

struct NestingMark {
  /// Main is no part of the nesting: main() stands inside a conditional of stages, if there are any.
  enum class Kind { Open, Middle, Close, Main };
  Kind kind = Kind::Open;
  int indent = -1;        ///< -1: the layout says nothing
  int around = -1;        ///< of an open one: the indent of an #if that holds no more than its head
  int depth = 0;          ///< of another nesting around it; a pair is at one depth
  int group = 0;          ///< the text it stands in; layouts of two texts are not compared
  int line = 0;           ///< within all texts
  bool whole = false;     ///< an include guard: its partner is the last mark
  bool ofStages = false;  ///< a conditional that parts stages
  bool inner = false;     ///< of an open one: only inside another
  bool mayElse = false;   ///< of an open one: an "else" can follow its partner
  bool hasElse = false;   ///< of a close one: an "else" follows
  bool last = false;      ///< of a middle one: no other can follow it
  std::size_t condition = 0;  ///< of an open one: equal for equal conditions, 0: unknown
  std::optional<bool> airy;   ///< is a blank line between it and the text inside?
  int shallowest = kNoLines;  ///< least depth since the mark before
  int lowest = kNoLines;      ///< least indent of the lines of its group since the mark before
};

/// A place where the missing mark may be put.
struct NestingPlace {
  std::size_t before = 0;  ///< index of the mark it is put before
  int indent = -1;
  int group = 0;
  int line = 0;
  int cost = 0;            ///< what speaks against it, or for it when negative
  int above = kNoLines;    ///< least indent of the lines of its group since the mark before
  int below = kNoLines;    ///< the same up to the mark behind
  bool takesElse = false;  ///< the "else" behind the mark before would follow it
};

struct MissingMark {
  std::size_t place = 0;    ///< index of the place
  std::size_t partner = 0;  ///< index of the mark that has no other
};

/// The place whose pairs fit best, and of these the one with the shortest (by the sum of logarithms);
/// behind it those of at most two other partners that fit about as well. `kind` is Open or Close.
std::vector<MissingMark> findMissingMarks(std::span<const NestingMark> marks,
                                          std::span<const NestingPlace> places,
                                          NestingMark::Kind kind);

/// At most `most` places with the partners that they give, the likeliest first.
std::vector<MissingMark> rankMissingMarks(std::span<const NestingMark> marks,
                                          std::span<const NestingPlace> places,
                                          NestingMark::Kind kind, std::size_t most);

}  // namespace orris
