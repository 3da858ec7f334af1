// Changes of a final text within its lines, keeping the author's place of every token.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <orris/glsl/tokens/source_map.h>

namespace orris {

class TextEdits {
 public:
  /// Host-made text, without line breaks, in front of the token at `offset`.
  void insert(std::size_t offset, std::string text);
  /// Another text for the token of `length` characters; the author's place stays.
  void rename(std::size_t offset, std::size_t length, std::string text);
  bool empty() const { return edits_.empty(); }
  /// Changes that overlap an earlier one are dropped; those at one offset apply in order of calls.
  MappedText apply(const MappedText& text) const;

 private:
  struct Edit {
    std::size_t offset = 0, length = 0;
    std::string text;
  };
  std::vector<Edit> edits_;
};

}  // namespace orris
