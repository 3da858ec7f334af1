#include <orris/chart/gallery/gallery_change.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <orris/image/image_compare.h>

namespace orris {
namespace {

constexpr float kStep = 1.0f / 255;
constexpr float kDifferenceGain = 8;  // of orris compare
constexpr std::size_t kMostNamedFiles = 3;

ImageF toFloat(const Image8& image) {
  ImageF result(image.width, image.height, image.channels);
  std::ranges::transform(image.pixels, result.pixels.begin(), [](std::uint8_t value) { return float(value) / 255; });
  return result;
}

/// One channel as a grey picture: its luma is the channel.
ImageF greyChannel(const Image8& image, int channel) {
  ImageF result(image.width, image.height, 3);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = float(image.pixels[i - i % 3 + std::size_t(channel)]) / 255;
  return result;
}

double worstSimilarity(const Image8& image, const Image8& reference) {
  double worst = 1;
  Diagnostics none;  // sizes are equal
  for (int channel = 0; channel < 3; ++channel) {
    const auto difference = compareImages(greyChannel(image, channel), greyChannel(reference, channel), kStep, none);
    worst = std::min(worst, difference ? difference->ssim : 0);
  }
  return worst;
}

/// Stages whose texts differ: "vertex, fragment".
std::vector<std::string> changedStages(const GalleryProgram& before, const GalleryProgram& after) {
  std::vector<std::string> names;
  const auto collect = [&](const GalleryProgram& one, const GalleryProgram& other) {
    for (const auto& [name, hash] : one.stages) {
      const auto found = other.stages.find(name);
      const bool same = found != other.stages.end() && found->second == hash;
      if (!same && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  };
  collect(after, before);
  collect(before, after);
  return names;
}

std::string filesThatReach(const GalleryProgram& before, const GalleryProgram& after,
                           const std::vector<FileChange>& files) {
  std::vector<std::string> names;
  std::size_t more = 0;
  for (const FileChange& change : files) {
    const auto& made = change.kind == Difference::Removed ? before.files : after.files;
    if (!std::ranges::binary_search(made, change.file)) continue;
    if (names.size() < kMostNamedFiles) names.push_back(change.file);
    else ++more;
  }
  if (names.empty()) return "";
  return fmt::format(", by {}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

/// "": the program is the same.
std::string whyChanged(const GalleryPicture& before, const GalleryPicture& after, const GalleryPass& was,
                       const GalleryPass& is, const std::vector<FileChange>& files) {
  if (was.program != is.program)
    return fmt::format("drawn by {} instead of {}", is.program.empty() ? "the host" : is.program,
                       was.program.empty() ? "the host" : was.program);
  const auto old = before.programs.find(is.program), now = after.programs.find(is.program);
  if (old == before.programs.end() || now == after.programs.end()) return "";
  const auto stages = changedStages(old->second, now->second);
  if (stages.empty()) return "";
  return fmt::format("{}{}", fmt::join(stages, ", "), filesThatReach(old->second, now->second, files));
}

std::vector<PassChange> comparePasses(const GalleryPicture& before, const GalleryPicture& after,
                                      const std::vector<FileChange>& files) {
  std::vector<PassChange> changes;
  for (const GalleryPass& pass : after.passes) {
    PassChange& change = changes.emplace_back();
    change.name = pass.name;
    change.after = pass.milliseconds;
    const auto old = std::ranges::find(before.passes, pass.name, &GalleryPass::name);
    change.kind = Difference::Added;
    if (old == before.passes.end()) continue;
    change.before = old->milliseconds;
    change.why = whyChanged(before, after, *old, pass, files);
    change.kind = change.why.empty() ? Difference::Same : Difference::Changed;
  }
  for (const GalleryPass& pass : before.passes)
    if (std::ranges::find(after.passes, pass.name, &GalleryPass::name) == after.passes.end())
      changes.push_back({pass.name, Difference::Removed, pass.milliseconds, std::nullopt, ""});
  return changes;
}

}  // namespace

const char* differenceName(Difference difference) {
  static constexpr const char* kNames[] = {"same", "changed", "added", "removed"};
  return kNames[int(difference)];
}

std::vector<FileChange> changedFiles(const FileSource& before, const FileSource& after) {
  std::map<std::string, Difference> kinds;
  for (const std::string& file : after.files())
    if (!before.contains(file)) kinds[file] = Difference::Added;
    else if (before.read(file) != after.read(file)) kinds[file] = Difference::Changed;
  for (const std::string& file : before.files())
    if (!after.contains(file)) kinds[file] = Difference::Removed;
  std::vector<FileChange> changes;
  for (const auto& [file, kind] : kinds) changes.push_back({file, kind});
  return changes;
}

PictureChange comparePictures(const GalleryPicture& before, const GalleryPicture& after,
                              const std::vector<FileChange>& files) {
  PictureChange change;
  change.equal = before.image.pixels == after.image.pixels;
  if (!change.equal) {
    Diagnostics none;  // sizes are equal
    const auto difference = compareImages(toFloat(after.image), toFloat(before.image), kStep, none);
    change.change = 1 - worstSimilarity(after.image, before.image);
    change.rmse = difference ? difference->rmse : 1;
    change.share = difference ? difference->fractionAbove : 1;
  }
  change.passes = comparePasses(before, after, files);
  return change;
}

Image8 shownDifference(const Image8& before, const Image8& after) {
  const ImageF difference = differenceImage(toFloat(after), toFloat(before), kDifferenceGain);
  Image8 result(difference.width, difference.height, difference.channels);
  std::ranges::transform(difference.pixels, result.pixels.begin(), [](float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
  });
  return result.channels > 3 ? withoutAlpha(result) : result;
}

}  // namespace orris
