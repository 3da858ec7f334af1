#include "app/gallery/gallery_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/input/inputs.h"
#include <orris/chart/measure/setting.h>
#include <orris/chart/study/digest.h>
#include <orris/core/files/read_file.h>
#include <orris/image/encode_png.h>
#include <orris/world/random_room.h>

namespace orris {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostWorldFiles = 4096;

std::uint64_t digestOf(const FileSource& files) {
  Digest digest;
  for (const std::string& file : files.files()) digest.add(file).add(files.read(file).value_or(""));
  return digest.value();
}

void addFile(const std::string& path, Digest& digest) {
  ReadFault fault{};
  digest.add(path).add(readFile(path, kMaxTextBytes, fault).value_or(""));
}

/// By the bytes of all its files; random rooms by their name.
std::uint64_t digestOfWorld(const std::string& path) {
  Digest digest;
  std::error_code error;
  if (path.starts_with(kRandomRoom)) return digest.add(path).value();
  if (!fs::is_directory(path, error)) addFile(path, digest);
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator it(path, error), end; !error && it != end && files.size() < kMostWorldFiles;
       it.increment(error))
    if (it->is_regular_file(error)) files.push_back(it->path().string());
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) addFile(file, digest);
  return digest.value();
}

void addValues(const OptionValues& values, Digest& digest) {
  digest.add(values.size());
  for (const auto& [name, value] : values) digest.add(name).add(value);
}

}  // namespace

GalleryKeys::GalleryKeys(const GalleryOptions& options, const GalleryInput& input)
    : options_(options), input_(input), pack_(digestOf(*input.files)) {
  if (input.filesBefore) packBefore_ = digestOf(*input.filesBefore);
  for (const std::string& world : input.worlds) worlds_.push_back(digestOfWorld(world));
}

std::string GalleryKeys::key(const GalleryJob& job) const {
  const GalleryShot& shot = input_.set.shots[job.shot];
  Digest digest;
  digest.add(std::string_view(ORRIS_VERSION)).add(job.before ? packBefore_ : pack_).add(worlds_[job.shot]);
  digest.add(shot.camera).add(shot.time.value_or(-1)).add(shot.weather).add(shot.profile);
  addValues(shot.values, digest);
  const PackOptions& pack = options_.pack;
  digest.add(pack.profile).add(pack.dimension);
  addValues(pack.values, digest);
  if (!pack.settingsFile.empty()) addFile(pack.settingsFile, digest);
  digest.add(versionNumber(pack.versions.iris)).add(versionNumber(pack.versions.game));
  digest.add(input_.size.width).add(input_.size.height).add(input_.frames);
  digest.add(int(options_.image.context)).add(input_.driver.renderer).add(input_.driver.version);
  return fmt::format("{:016x}", digest.value());
}

std::string GalleryFiles::path(const std::string& name, const char* ending) const {
  return (fs::path(folder_) / "pictures" / (fileStem(name) + ending)).string();
}

bool GalleryFiles::create(Report& report, int& status) const {
  if (folder_.empty()) return true;
  std::error_code error;
  const std::string pictures = (fs::path(folder_) / "pictures").string();
  fs::create_directories(pictures, error);
  if (!error && liesBelow(folder_, pictures)) return true;
  report.error("file-unwritable",
               error ? "the folder cannot be made: " + error.message()
                     : "its folder pictures is a link that leads out of it",
               "name a folder in a place that may be written, or a file that ends in .html", folder_);
  status = kUsage;
  return false;
}

std::optional<GalleryPicture> GalleryFiles::read(const std::string& name, const std::string& key,
                                                 ImageSize size) const {
  if (folder_.empty()) return std::nullopt;
  ReadFault fault{};
  const auto text = readFile(path(name, ".json"), kMaxTextBytes, fault);
  const auto bytes = text ? readFile(path(name, ".png"), kMaxTextBytes, fault) : std::nullopt;
  const json known = bytes ? json::parse(*text, nullptr, false) : json();
  if (!known.is_object() || known.value("key", json()) != key || known.value("name", json()) != name) return std::nullopt;
  auto picture = parseGalleryNumbers(*text);
  Diagnostics damaged;  // drawn again
  const auto image = decodeImage(*bytes, name, damaged);
  if (!picture || !image || image->width != size.width || image->height != size.height) return std::nullopt;
  picture->image = withoutAlpha(*image);
  return picture;
}

bool GalleryFiles::write(const std::string& name, const std::string& key, const GalleryPicture& picture,
                         Report& report, int& status) const {
  if (folder_.empty()) return true;
  json numbers = json::parse(writeGalleryNumbers(picture));
  numbers["name"] = name;
  numbers["key"] = key;
  Diagnostics diagnostics;
  const std::string file = path(name, ".png");
  const auto png = encodePng(picture.image, file, diagnostics);
  report.add(diagnostics);
  // The numbers last: they say that the picture is there.
  const bool written = png && writeWholeFile(file, *png, report) &&
                       writeWholeFile(path(name, ".json"), jsonText(numbers), report);
  if (!written) status = kHostFailed;
  return written;
}

}  // namespace orris
