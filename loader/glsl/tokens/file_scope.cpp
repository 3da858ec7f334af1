#include <orris/glsl/tokens/file_scope.h>

#include <algorithm>

#include <orris/core/characters.h>
#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  FileScope read() {
    while (skipBlanks()) {
      if (text_[at_] == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        if (scope_.first == std::string::npos) scope_.first = at_;
        statement();
      }
    }
    return std::move(scope_);
  }

 private:
  bool skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
    return at_ < text_.size();
  }

  /// Up to ';', or to the '}' of a function.
  void statement() {
    const std::size_t begin = at_;
    bool varying = false, block = false;
    char last = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (isWordCharacter(c)) {
        varying |= word();
        last = 'w';
        continue;
      }
      if (c == ';') {
        ++at_;
        if (varying && !block) addVaryings(text_.substr(begin, at_ - begin));
        return;
      }
      if (c == '{') {
        const std::size_t open = at_;
        skipNested('{', '}');
        if (last == ')') return function(begin, open);
        block = true;
      } else if (c == '(') {
        skipNested('(', ')');
        last = ')';
        continue;
      } else {
        ++at_;
      }
      if (!isBlank(c)) last = c;
    }
  }

  /// Is it the qualifier of a varying?
  bool word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && isWordCharacter(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    return word == "in" || word == "out";
  }

  void skipNested(char open, char close) {
    for (int depth = 0; at_ < text_.size(); ++at_) {
      if (text_[at_] == open) ++depth;
      if (text_[at_] == close && --depth == 0) {
        ++at_;
        return;
      }
    }
  }

  void function(std::size_t begin, std::size_t open) {
    const std::string_view head = text_.substr(begin, open - begin);
    const std::size_t parenthesis = head.find('(');
    // "void main) {": a ')' that nothing opens.
    if (parenthesis == std::string_view::npos) return;
    std::size_t end = parenthesis;
    while (end > 0 && isBlank(head[end - 1])) --end;
    std::size_t name = end;
    while (name > 0 && isWordCharacter(head[name - 1])) --name;
    if (head.substr(name, end - name) != "main") return;
    scope_.mainBegin = open + 1;
    scope_.mainEnd = at_ - 1;
  }

  void addVaryings(std::string_view statement) {
    const std::vector<Token> tokens = tokenize(statement);
    OutlineItem item;
    item.end = tokens.size();
    const Declaration declaration = parseDeclaration(tokens, item);
    const std::size_t in = declaration.qualifier(tokens, "in");
    if (in == Declaration::npos && declaration.qualifier(tokens, "out") == Declaration::npos)
      return;
    StageVarying varying{.type = tokens[declaration.type].text};
    varying.input = in != Declaration::npos;
    for (const std::size_t index : declaration.qualifiers) addQualifier(tokens, index, varying);
    const bool arrayType = followedBy(tokens, declaration.type, "[");
    for (const Declarator& declarator : declaration.declarators) {
      varying.name = tokens[declarator.name].text;
      varying.array = arrayType || followedBy(tokens, declarator.name, "[");
      scope_.varyings.push_back(varying);
    }
  }

  static void addQualifier(const std::vector<Token>& tokens, std::size_t index,
                           StageVarying& varying) {
    const std::string& word = tokens[index].text;
    if (word == "layout") varying.layout = true;
    if (word != "in" && word != "out" && word != "layout") varying.qualifiers += word + " ";
  }

  std::string_view text_;
  std::size_t at_ = 0;
  FileScope scope_;
};

}  // namespace

FileScope readFileScope(std::string_view text) { return Reader(text).read(); }

}  // namespace orris
