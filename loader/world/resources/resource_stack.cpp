#include <orris/world/resources/resource_stack.h>

#include <fmt/core.h>

#include <algorithm>

#include <orris/core/add_diagnostic.h>
#include <orris/core/files/asset_source.h>

namespace orris {
namespace {

bool isNameLetter(char c, bool slash) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.' ||
         (slash && c == '/');
}

/// No empty part, "." or "..".
bool staysInside(std::string_view path) {
  while (true) {
    const std::size_t slash = path.find('/');
    const std::string_view part = path.substr(0, slash);
    if (part.empty() || part == "." || part == "..") return false;
    if (slash == std::string_view::npos) return true;
    path.remove_prefix(slash + 1);
  }
}

std::string pathOf(const ResourceName& name, ResourceKind kind) {
  return fmt::format("/{}/{}/{}{}", name.space, kind.folder, name.path, kind.ending);
}

}  // namespace

std::optional<ResourceName> parseResourceName(std::string_view text) {
  constexpr std::size_t kLongest = 512;
  const std::size_t colon = text.find(':');
  const bool named = colon != std::string_view::npos && colon > 0;
  ResourceName name{named ? std::string(text.substr(0, colon)) : "minecraft",
                    std::string(colon == std::string_view::npos ? text : text.substr(colon + 1))};
  const auto letters = [](const std::string& word, bool slash) {
    return std::all_of(word.begin(), word.end(), [&](char c) { return isNameLetter(c, slash); });
  };
  const bool good = text.size() <= kLongest && letters(name.space, false) &&
                    letters(name.path, true) && staysInside(name.space) && staysInside(name.path);
  return good ? std::optional(std::move(name)) : std::nullopt;
}

void ResourceStack::add(std::string label, std::unique_ptr<FileSource> files) {
  packs_.push_back({std::move(label), std::move(files)});
}

bool ResourceStack::contains(const ResourceName& name, ResourceKind kind) const {
  const std::string path = pathOf(name, kind);
  return std::any_of(packs_.begin(), packs_.end(),
                     [&](const Pack& pack) { return pack.files->contains(path); });
}

std::optional<ResourceFile> ResourceStack::read(const ResourceName& name, ResourceKind kind,
                                                Diagnostics& diagnostics) const {
  const std::string path = pathOf(name, kind);
  for (const Pack& pack : packs_) {
    if (!pack.files->contains(path)) continue;
    const std::string place = pack.label + "/assets" + path;
    if (auto bytes = pack.files->read(path)) return ResourceFile{std::move(*bytes), place};
    addWarning(diagnostics, "resource-unreadable", {place},
               "this file of the resource pack cannot be read, or is too large",
               "zip the pack again without a password, with deflate");
    return std::nullopt;
  }
  return std::nullopt;
}

std::optional<ResourceStack> openResources(const std::vector<std::string>& paths,
                                           Diagnostics& diagnostics) {
  ResourceStack stack;
  for (const std::string& path : paths) {
    auto files = openAssets(path, diagnostics);
    if (!files) return std::nullopt;
    const std::size_t end = path.find_last_not_of('/');
    stack.add(path.substr(0, end == std::string::npos ? path.size() : end + 1), std::move(files));
  }
  return stack;
}

}  // namespace orris
