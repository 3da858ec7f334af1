// What the frame reads and writes.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> frameRules() {
  static const std::vector<Rule> kRules = {
      {"format-narrow", Severity::Warning,
       "a component is read that the format of the buffer has not"},
      {"image-unused", Severity::Note, "a custom image is made, but no program declares it"},
      {"mipmap-missing", Severity::Warning, "a higher level is read of a buffer without mipmaps"},
      {"mipmap-unused", Severity::Note,
       "mipmaps are made of a buffer that nothing reads from there on"},
      {"output-format", Severity::Warning, "an output does not fit the format of its buffer"},
      {"target-feedback", Severity::Warning,
       "a geometry program samples a buffer that it draws to"},
      {"target-store-lost", Severity::Warning,
       "an image store goes to the side that is left behind"},
      {"target-store-race", Severity::Note, "a program stores to a buffer that it samples"},
      {"target-unbound", Severity::Warning,
       "a geometry program samples a buffer that only fullscreen programs get"},
      {"target-unread", Severity::Warning, "a render target is drawn to, but nothing reads it"},
      {"target-unwritten", Severity::Warning,
       "a render target is read while nothing can be in it but its clear colour"},
      {"texture-unused", Severity::Note, "a custom texture is loaded, but no program declares it"},
  };
  return kRules;
}

}  // namespace orris
