#include <orris/check/frame/buffer_mentions.h>

#include <algorithm>
#include <array>

#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/directive_values.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {
namespace {

class Scanner {
 public:
  /// `isRead`: by a program.
  Scanner(const std::string& file, std::string_view text, bool isRead, BufferMentions& out)
      : file_(file), text_(text), isRead_(isRead), out_(out) {}

  void run() {
    while (at_ < text_.size()) {
      if (starts("//")) {
        lineComment();
      } else if (starts("/*")) {
        blockComment();
      } else if (isWordCharacter(text_[at_])) {
        word();
      } else {
        newLine(text_[at_]);
        ++at_;
      }
    }
  }

 private:
  bool starts(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

  void newLine(char c) {
    if (c == '\n' || c == ';') declaration_ = false;
  }

  void lineComment() {
    const size_t end = std::min(text_.find('\n', at_), text_.size());
    directives(text_.substr(at_, end - at_));
    at_ = end;
  }

  void blockComment() {
    const size_t end = std::min(text_.find("*/", at_ + 2), text_.size());
    const std::string_view comment = text_.substr(at_, end - at_);
    directives(comment);
    // Const lines are directives inside a comment too.
    for (size_t i = 0; i < comment.size();) {
      const std::string_view word = leadingWord(comment.substr(i));
      if (!word.empty()) setting(word, comment.substr(i + word.size()));
      i += std::max<size_t>(word.size(), 1);
    }
    at_ = std::min(end + 2, text_.size());
  }

  void directives(std::string_view comment) {
    constexpr std::string_view kList = "RENDERTARGETS:", kDigits = "DRAWBUFFERS:";
    if (const size_t at = comment.find(kList); at != std::string_view::npos)
      for (std::string_view part : splitAt(comment.substr(at + kList.size()), ','))
        draw(parseInteger(leadingWord(trim(part))));
    if (const size_t at = comment.find(kDigits); at != std::string_view::npos)
      for (const char digit : leadingWord(trim(comment.substr(at + kDigits.size()))))
        draw(parseInteger(std::string_view(&digit, 1)));
  }

  void draw(std::optional<long long> index) {
    if (!index || *index < 0 || *index > 31) return;
    out_.drawn[file_].insert(static_cast<int>(*index));
    if (isRead_) out_.drawnAnywhere.insert(static_cast<int>(*index));
  }

  void word() {
    const std::string_view word = leadingWord(text_.substr(at_));
    at_ += word.size();
    if (word == "uniform") declaration_ = true;
    const std::string_view rest = text_.substr(at_, 40);
    setting(word, rest);
    if (declaration_) return;
    const std::string_view after = trim(rest);
    if (after.starts_with("##") && (word.ends_with("tex") || word.ends_with("img") ||
                                    word.ends_with("gaux") || word.ends_with("color")))
      out_.pasted = true;
    const auto buffer = parseBufferName(word, false);
    if (buffer) mention(*buffer);
  }

  void mention(const BufferName& buffer) {
    if (buffer.kind == BufferName::Kind::Color)
      (buffer.image ? out_.colorImages : out_.color).insert(buffer.index);
    if (buffer.kind == BufferName::Kind::ShadowColor)
      (buffer.image ? out_.shadowImages : out_.shadowColor).insert(buffer.index);
  }

  // "colortex4Clear = false", also where the value is a macro or an option.
  void setting(std::string_view word, std::string_view rest) {
    const bool clear = word.ends_with("Clear"), mipmap = word.ends_with("MipmapEnabled"),
               format = word.ends_with("Format");
    if (!clear && !mipmap && !format) return;
    word.remove_suffix(clear ? 5 : mipmap ? 13 : 6);
    const auto buffer = parseBufferName(word, false);
    rest = trim(rest);
    if (!buffer || !rest.starts_with('=')) return;
    const std::string_view value = leadingWord(trim(rest.substr(1)));
    const bool shadow = buffer->kind == BufferName::Kind::ShadowColor;
    if (format)
      (shadow ? out_.shadowFormats : out_.formats)[buffer->index].insert(upperCase(value));
    if (format || value == (clear ? "true" : "false")) return;
    if (clear) (shadow ? out_.keptShadow : out_.keptColor).insert(buffer->index);
    if (mipmap) (shadow ? out_.shadowMipmapped : out_.mipmapped).insert(buffer->index);
  }

  const std::string& file_;
  std::string_view text_;
  bool isRead_;
  BufferMentions& out_;
  size_t at_ = 0;
  bool declaration_ = false;
};

}  // namespace

bool isShaderText(std::string_view path) {
  constexpr std::array<std::string_view, 10> kOther = {
      ".png", ".bin", ".dat", ".raw", ".properties", ".lang", ".md", ".txt", ".json", ".mcmeta"};
  return std::none_of(kOther.begin(), kOther.end(),
                      [&](std::string_view end) { return path.ends_with(end); });
}

namespace {

/// A file that is not there may include any.
bool isReadByPrograms(const ShaderPack& pack, const std::string& file) {
  if (pack.builds.empty()) return true;
  const PackFiles& files = pack.builds.front()->files();
  return !files.broken.empty() || files.graph.files.contains(file);
}

}  // namespace

BufferMentions findBufferMentions(const ShaderPack& pack) {
  BufferMentions mentions;
  if (!pack.source) return mentions;
  for (const std::string& file : pack.source->files()) {
    if (!isShaderText(file)) continue;
    if (const auto text = readText(*pack.source, file))
      Scanner(file, *text, isReadByPrograms(pack, file), mentions).run();
  }
  return mentions;
}

}  // namespace orris
