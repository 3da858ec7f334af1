#include <orris/pack/options/option_line.h>

#include <algorithm>
#include <set>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

/// Takes pieces off the front of a line. Iris: ParsedString.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : rest_(trim(text)) {}
  bool atEnd() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

  bool literal(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  bool blanks() {
    const std::string_view before = rest_;
    rest_ = trim(rest_);
    return rest_.size() != before.size();
  }
  /// "//" and any further slashes.
  bool comment() {
    if (!rest_.starts_with("//")) return false;
    rest_.remove_prefix(std::min(rest_.find_first_not_of('/'), rest_.size()));
    return true;
  }
  std::string_view word() { return take(leadingWord(rest_).size()); }
  std::string_view wordOrNumber() {
    const size_t length = numberLength();
    return length > 0 && parseFloat(rest_.substr(0, length)) ? take(length) : word();
  }

 private:
  std::string_view take(size_t length) {
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }
  /// A sign, dot or exponent letter belongs to the number when a digit follows it.
  size_t numberLength() const {
    const auto isDigit = [&](size_t i) {
      return i < rest_.size() && rest_[i] >= '0' && rest_[i] <= '9';
    };
    size_t length = 0;
    while (isDigit(length) || isDigit(length + 1)) ++length;
    const bool suffix = length > 0 && length < rest_.size() && (rest_[length] | 0x20) == 'f';
    return suffix ? length + 1 : length;
  }

  std::string_view rest_;
};

std::set<std::string, std::less<>> makeConstNames() {
  std::set<std::string, std::less<>> names{"shadowMapResolution",     "shadowDistance",
                                           "voxelDistance",           "shadowDistanceRenderMul",
                                           "entityShadowDistanceMul", "shadowIntervalSize",
                                           "generateShadowMipmap",    "generateShadowColorMipmap",
                                           "shadowHardwareFiltering", "shadowtexMipmap",
                                           "shadowtex0Mipmap",        "shadowtex1Mipmap",
                                           "shadowtexNearest",        "shadowtex0Nearest",
                                           "shadowtex1Nearest",       "shadow0MinMagNearest",
                                           "shadow1MinMagNearest",    "wetnessHalflife",
                                           "drynessHalflife",         "eyeBrightnessHalflife",
                                           "centerDepthHalflife",     "sunPathRotation",
                                           "ambientOcclusionLevel",   "superSamplingLevel",
                                           "noiseTextureResolution"};
  for (int i = 0; i < 8; ++i) {
    const std::string n = std::to_string(i);
    names.insert("shadowHardwareFiltering" + n);
    for (const char* prefix : {"shadowcolor", "shadowColor"}) {
      for (const char* suffix : {"Mipmap", "Nearest", "MinMagNearest"})
        names.insert(prefix + n + suffix);
    }
  }
  return names;
}

bool isConstName(std::string_view name) {
  static const auto kNames = makeConstNames();
  return kNames.contains(name);
}

/// Fills values and comment from "text [a b c] text"; false without a list.
bool readValueList(std::string_view comment, OptionLine& option) {
  const size_t open = comment.find('[');
  const size_t close = open == std::string_view::npos ? open : comment.find(']', open);
  if (close == std::string_view::npos) return false;
  option.values = splitSingleBlanks(comment.substr(open + 1, close - open - 1));
  if (std::find(option.values.begin(), option.values.end(), option.value) == option.values.end()) {
    option.values.push_back(option.value);
  }
  option.comment =
      trim(std::string(comment.substr(0, open)) + std::string(comment.substr(close + 1)));
  return true;
}

void makeBoolean(OptionLine& option, bool on, std::string_view comment) {
  option.isBoolean = true;
  option.value = on ? "true" : "false";
  option.values = {"true", "false"};
  option.comment = trim(comment);
}

std::optional<OptionLine> parseDefine(Cursor line) {
  OptionLine option;
  const bool commentedOut = line.comment();
  line.blanks();
  if (!line.literal("#define") || !line.blanks()) return std::nullopt;
  option.name = line.word();
  if (option.name.empty()) return std::nullopt;
  const bool separated = line.blanks();
  if (line.atEnd() || line.comment()) {
    makeBoolean(option, !commentedOut, line.rest());
    return option;
  }
  if (!separated || commentedOut) return std::nullopt;
  option.value = line.wordOrNumber();
  line.blanks();
  if (option.value.empty() || !line.comment() || !readValueList(line.rest(), option))
    return std::nullopt;
  return option;
}

std::optional<OptionLine> parseConst(Cursor line) {
  OptionLine option;
  option.isConst = true;
  if (!line.blanks()) return std::nullopt;
  const std::string_view type = line.word();
  if ((type != "int" && type != "float" && type != "bool") || !line.blanks()) return std::nullopt;
  option.name = line.word();
  line.blanks();
  if (!isConstName(option.name) || !line.literal("=")) return std::nullopt;
  line.blanks();
  option.value = line.wordOrNumber();
  line.blanks();
  if (option.value.empty() || !line.literal(";")) return std::nullopt;
  line.blanks();
  if (!line.comment() && !line.atEnd()) return std::nullopt;
  if (type == "bool") {
    if (option.value != "true" && option.value != "false") return std::nullopt;
    makeBoolean(option, option.value == "true", line.rest());
    return option;
  }
  return readValueList(line.rest(), option) ? std::optional(option) : std::nullopt;
}

}  // namespace

std::optional<OptionLine> parseOptionLine(std::string_view text) {
  if (text.find("#define") == std::string_view::npos &&
      text.find("const") == std::string_view::npos) {
    return std::nullopt;
  }
  Cursor line(text);
  if (line.literal("#ifdef") || line.literal("#ifndef")) return std::nullopt;
  return line.literal("const") ? parseConst(line) : parseDefine(line);
}

std::string_view definedName(std::string_view text) {
  if (text.find("#define") == std::string_view::npos) return "";
  Cursor line(text);
  line.comment();
  line.blanks();
  return line.literal("#define") && line.blanks() ? line.word() : "";
}

std::string_view booleanReference(std::string_view text) {
  Cursor line(text);
  if ((!line.literal("#ifdef") && !line.literal("#ifndef")) || !line.blanks()) return "";
  const std::string_view name = line.word();
  line.blanks();
  return line.atEnd() ? name : "";
}

std::string_view askedName(std::string_view line) {
  line = trim(line);
  const std::string_view directive = line.substr(0, line.find_first_of(" \t"));
  if (directive != "#ifdef" && directive != "#ifndef") return "";
  return leadingWord(trim(line.substr(directive.size())));
}

std::string editOptionLine(const std::string& line, const OptionLine& option,
                           const std::string& value) {
  if (option.isConst) {
    const size_t equals = line.find('=');
    const size_t at = line.find(option.value, equals);
    return line.substr(0, at) + value + line.substr(at + option.value.size());
  }
  if (!option.isBoolean) return "#define " + option.name + " " + value;
  if (value != "true") return "//" + line;
  const std::string_view commented = trim(line);
  return std::string(
      commented.substr(std::min(commented.find_first_not_of('/'), commented.size())));
}

}  // namespace orris
