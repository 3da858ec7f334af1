#include <orris/glsl/tokens/text_edits.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace orris {

void TextEdits::insert(std::size_t offset, std::string text) {
  assert(text.find('\n') == std::string::npos);
  edits_.push_back({offset, 0, std::move(text)});
}

void TextEdits::rename(std::size_t offset, std::size_t length, std::string text) {
  edits_.push_back({offset, length, std::move(text)});
}

MappedText TextEdits::apply(const MappedText& text) const {
  std::vector<Edit> edits = edits_;
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.offset < b.offset; });
  MappedText out = text;
  out.text.clear();
  std::size_t copied = 0, lineStart = 0, line = 0;
  int shift = 0;            // of the columns on the current line
  std::size_t segment = 0;  // next of the current line to shift
  const auto shiftUpTo = [&](int column) {
    if (line >= out.lines.size()) return;
    for (; segment < out.lines[line].size() && out.lines[line][segment].column < column; ++segment)
      out.lines[line][segment].column += shift;
  };
  const auto goTo = [&](std::size_t offset) {
    for (std::size_t end; (end = text.text.find('\n', lineStart)) < offset;) {
      shiftUpTo(1 << 30);
      lineStart = end + 1;
      ++line;
      shift = 0;
      segment = 0;
    }
  };
  for (const Edit& edit : edits) {
    if (edit.offset < copied || edit.offset + edit.length > text.text.size()) continue;
    goTo(edit.offset);
    const int column = static_cast<int>(edit.offset - lineStart) + 1;
    shiftUpTo(column);
    out.text.append(text.text, copied, edit.offset - copied);
    out.text += edit.text;
    copied = edit.offset + edit.length;
    if (edit.length == 0 && line < out.lines.size()) {
      auto& segments = out.lines[line];
      segments.insert(segments.begin() + static_cast<std::ptrdiff_t>(segment),
                      {.column = column + shift});
      ++segment;
    } else {
      shiftUpTo(column + 1);
    }
    shift += static_cast<int>(edit.text.size()) - static_cast<int>(edit.length);
  }
  shiftUpTo(1 << 30);
  out.text.append(text.text, copied, std::string::npos);
  return out;
}

}  // namespace orris
