#include <orris/glsl/syntax/branch_room.h>

#include <algorithm>

namespace orris {
namespace {

// Packs are untrusted: each may be tried.
constexpr std::size_t kMostParagraphs = 16;

}  // namespace

void BranchText::addConditional(int line) {
  start_ = shallowest_ = depth_;
  first_ = ends_ = line;
  paragraph_ = 0;
  paragraphs_.clear();
  texts_ = 0;
  wasBlank_ = ended_ = false;
  textsBefore_ = {{depth_, 0}};
}

void BranchText::addLine(std::string_view code, bool blank, int line) {
  if (blank) {
    wasBlank_ = true;
    ended_ = ended_ || ends_ > first_;
    return;
  }
  ++texts_;  // a comment is text too
  for (const char c : code) addCharacter(c);
  endLine(line);
}

void BranchText::addDirective(int line) {
  ++texts_;
  endLine(line);
}

void BranchText::addCharacter(char c) {
  if (c == ' ' || c == '\t' || c == '\r') return;
  ++texts_;
  if (c == '{') textsBefore_.try_emplace(++depth_, texts_);
  if (c != '}') return;
  --depth_;
  shallowest_ = std::min(shallowest_, depth_);
  textsBefore_.erase(textsBefore_.upper_bound(depth_), textsBefore_.end());
  textsBefore_.try_emplace(depth_, texts_);
}

void BranchText::endLine(int line) {
  if (wasBlank_ || paragraph_ == 0) {
    paragraph_ = line;
    if (paragraphs_.size() < kMostParagraphs) paragraphs_.emplace_back(line, line);
  }
  if (!paragraphs_.empty() && paragraphs_.back().first == paragraph_)
    paragraphs_.back().second = line;
  wasBlank_ = false;
  if (!ended_ && shallowest_ >= start_ && depth_ == start_) ends_ = line;
}

BranchRoom BranchText::room() const {
  const bool precedes = texts_ > textsBefore_.at(depth_);
  return {ends_ > first_ ? ends_ : 0, precedes ? paragraph_ : 0, wasBlank_, shallowest_,
          paragraphs_};
}

}  // namespace orris
