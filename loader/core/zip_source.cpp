#include "core/zip_source.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "core/pack_path.h"

namespace orris {
namespace {

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Entry = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

void fail(const std::string& file, std::string id, std::string message, std::string hint,
          Diagnostics& diagnostics) {
  diagnostics.push_back({.severity = Severity::Error,
                         .id = std::move(id),
                         .at = {.file = file},
                         .message = std::move(message),
                         .hint = std::move(hint)});
}

constexpr const char* kDamagedHint = "the archive is damaged or cut off; fetch or zip it again";

Archive openArchive(const std::string& path, Diagnostics& diagnostics) {
  int code = 0;
  Archive archive(zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code), zip_discard);
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    fail(path, "zip-unreadable", fmt::format("cannot read the zip: {}", zip_error_strerror(&error)),
         code == ZIP_ER_NOZIP || code == ZIP_ER_INCONS ? kDamagedHint : "", diagnostics);
    zip_error_fini(&error);
  }
  return archive;
}

/// "/shaders/" at the top wins over the first one found deeper. nullopt: there is none.
std::optional<std::string> findRoot(zip_t* archive, zip_int64_t count) {
  std::optional<std::string> deeper;
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
    if (!name) continue;
    const std::string path = std::string("/") + name;
    const size_t at = path.find("/shaders/");
    if (at == 0) return "/shaders";
    if (at != std::string::npos && !deeper) deeper = path.substr(0, at) + "/shaders";
  }
  return deeper;
}

std::optional<std::string> readEntry(zip_t* archive, zip_uint64_t index, size_t limit) {
  const Entry entry(zip_fopen_index(archive, index, 0), zip_fclose);
  if (!entry) return std::nullopt;
  std::string bytes;
  char block[1 << 16];
  zip_int64_t got = 0;
  while ((got = zip_fread(entry.get(), block, sizeof block)) > 0) {
    bytes.append(block, static_cast<size_t>(got));
    // The size written in the archive may be a lie.
    if (bytes.size() > limit) return std::nullopt;
  }
  return got < 0 ? std::nullopt : std::optional(std::move(bytes));
}

}  // namespace

std::optional<std::string> readBesideInZip(const std::string& zip, std::string_view path,
                                           const PackLimits& limits) {
  Diagnostics ignored;  // reported when the pack was opened
  const Archive archive = openArchive(zip, ignored);
  if (!archive) return std::nullopt;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  const auto root = findRoot(archive.get(), count);
  const auto wanted = root ? resolvePackPath(*root + "/", path.substr(1)) : std::nullopt;
  for (zip_int64_t i = 0; wanted && i < count; ++i) {
    const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
    if (name && resolvePackPath("/", std::string("/") + name) == wanted)
      return readEntry(archive.get(), static_cast<zip_uint64_t>(i), limits.fileBytes);
  }
  return std::nullopt;
}

std::optional<std::map<std::string, std::string>> readZip(const std::string& path,
                                                          const PackLimits& limits,
                                                          Diagnostics& diagnostics) {
  const Archive archive = openArchive(path, diagnostics);
  if (!archive) return std::nullopt;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  const auto root = findRoot(archive.get(), count);
  if (!root) {
    fail(path, "pack-unreadable", "no shader pack: the zip has no folder named shaders",
         "zip the folder that holds shaders/", diagnostics);
    return std::nullopt;
  }
  std::map<std::string, std::string> files;
  size_t total = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
    const auto inside = name ? resolvePackPath("/", std::string("/") + name) : std::nullopt;
    if (!inside || !inside->starts_with(*root + "/") || std::string_view(name).ends_with('/'))
      continue;
    auto bytes = readEntry(archive.get(), static_cast<zip_uint64_t>(i), limits.fileBytes);
    if (!bytes) {
      fail(path, "zip-unreadable",
           fmt::format("cannot read {} in the zip, or it is larger than {} bytes", *inside,
                       limits.fileBytes),
           kDamagedHint, diagnostics);
      return std::nullopt;
    }
    total += bytes->size();
    if (total > limits.totalBytes || files.size() >= limits.files) {
      fail(path, "pack-too-large",
           fmt::format("the pack has more than {} bytes or {} files", limits.totalBytes,
                       limits.files),
           "", diagnostics);
      return std::nullopt;
    }
    files.emplace(inside->substr(root->size()), std::move(*bytes));
  }
  return files;
}

}  // namespace orris
