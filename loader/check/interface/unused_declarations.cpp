#include <orris/check/interface/unused_declarations.h>

#include <orris/check/compile/text_scanner.h>

namespace orris {

std::map<std::string_view, TextPlace> readUnusedDeclarations(std::string_view text) {
  std::map<std::string_view, int> count;
  std::map<std::string_view, TextPlace> declared;
  TextScanner scanner(text);
  TextToken word, previous;
  for (TextToken token = scanner.next(); token.kind != TextToken::Kind::End;
       token = scanner.next()) {
    // "type name =", "name[2];" and further ones of a list.
    const bool ends =
        token.is('=') || token.is(';') || token.is(',') || token.is('[') || token.is(')');
    const bool begins = previous.isWord() || previous.is(',') || previous.is(']');
    if (ends && begins && word.isWord() && previous.text != "return")
      declared[word.text] = {word.line, word.column};
    if (token.isWord()) ++count[token.text];
    previous = word;
    word = token;
  }
  std::erase_if(declared, [&](const auto& entry) { return count[entry.first] > 1; });
  return declared;
}

}  // namespace orris
