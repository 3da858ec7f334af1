#include <orris/pack/options/language.h>

#include <orris/core/files/text_file.h>
#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>

namespace orris {

std::map<std::string, std::map<std::string, std::string>> readLanguages(const FileSource& source,
                                                                        Diagnostics& diagnostics) {
  constexpr std::string_view kFolder = "/lang/", kSuffix = ".lang";
  std::map<std::string, std::map<std::string, std::string>> languages;
  for (const std::string& path : source.files()) {
    if (!path.starts_with(kFolder)) continue;
    const std::string name = lowerCase(path.substr(kFolder.size()));
    if (!name.ends_with(kSuffix) || name.find('/') != std::string::npos) continue;
    auto& texts = languages[name.substr(0, name.size() - kSuffix.size())];
    for (PropertyEntry& entry : parseProperties(
             path, readText(source, path, diagnostics).value_or(""), Continuation::Java)) {
      texts[entry.key] = std::move(entry.value);
    }
  }
  return languages;
}

}  // namespace orris
