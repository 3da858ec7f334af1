#include "app/gallery/gallery_run.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/gallery/gallery_files.h"
#include "app/input/inputs.h"
#include "app/output/progress.h"
#include <orris/chart/gallery/gallery_page.h>
#include <orris/image/encode_png.h>

namespace orris {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using GalleryTime = std::chrono::steady_clock;

std::string packName(const std::string& path) {
  return fs::weakly_canonical(path).filename().string();
}

/// What comes of one run.
class GalleryRun {
 public:
  GalleryRun(const GalleryOptions& options, Report& report)
      : options_(options), report_(report), page_(options.output), files_("") {
    if (fs::path(options.output).extension() == ".html") return;
    files_ = GalleryFiles(options.output);
    page_ = (fs::path(options.output) / "index.html").string();
  }

  int run(json& result) {
    auto input = readGalleryInput(options_, report_, status_);
    if (!input || !files_.create(report_, status_)) return status_;
    if (!checkWritable(page_, report_)) return kUsage;
    input_ = std::move(*input);
    begin();
    draw();
    if (status_ == kHostFailed || !compare()) return status_;
    if (!writeWholeFile(page_, galleryPage(gallery_), report_)) return kUsage;
    judge();
    result = describe();
    sayWritten(options_.report, {page_}, summary());
    // What goes wrong with a picture, the driver that dies of it too, is a problem of the pack.
    return status_ == kClean && hasErrors(report_.all()) ? int(kProblems) : status_;
  }

 private:
  std::string fileName(const GalleryJob& job) const {
    return input_.set.shots[job.shot].name + (job.before ? ".before" : "");
  }
  GalleryRevision& revision(const GalleryJob& job) {
    GalleryEntry& entry = gallery_.entries[entryOf_.at(job.shot)];
    return job.before ? entry.before : entry.after;
  }

  /// The entries of this shard, and what is known of others.
  void begin() {
    const GalleryKeys keys(options_, input_);
    const Shard shard = parseShard(options_.shard).value_or(Shard{1, 1});
    gallery_.against = input_.filesBefore != nullptr;
    gallery_.title = packName(options_.pack.path);
    if (gallery_.against) {
      gallery_.title += " against " + packName(options_.against);
      gallery_.files = changedFiles(*input_.filesBefore, *input_.files);
    }
    gallery_.facts = facts();
    for (std::size_t shot = 0; shot < input_.set.shots.size(); ++shot)
      addShot(shot, keys, int(shot % std::size_t(shard.second)) + 1 == shard.first);
  }

  void addShot(std::size_t shot, const GalleryKeys& keys, bool own) {
    std::vector<std::pair<GalleryJob, std::optional<GalleryPicture>>> revisions = {{{shot, false}, std::nullopt}};
    if (gallery_.against) revisions.push_back({{shot, true}, std::nullopt});
    bool known = true;
    for (auto& [job, picture] : revisions) {
      picture = files_.read(fileName(job), keys.key(job), input_.size);
      known = known && picture;
    }
    if (!own && !known) return;
    entryOf_[shot] = gallery_.entries.size();
    gallery_.entries.emplace_back().name = input_.set.shots[shot].name;
    for (auto& [job, picture] : revisions) {
      if (!picture) {
        jobs_.push_back(job);
        keys_.push_back(keys.key(job));
      }
      revision(job).picture = std::move(picture);
    }
  }

  std::vector<std::pair<std::string, std::string>> facts() const {
    const auto count = [](int n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
    const bool cpu = galleryClock(options_) == FrameClock::Processor;
    return {{"set", input_.set.name},
            {"pictures", fmt::format("{}x{}, the last of {}; times are medians over the second half of them, {}",
                                     input_.size.width, input_.size.height, count(input_.frames, "frame"),
                                     cpu ? "processor time of all threads" : "time that passed")},
            {"driver", input_.driver.renderer}};
  }

  void draw() {
    const auto budget = parseBudget(options_.budget);
    const auto until = budget ? std::optional(GalleryTime::now() + *budget) : std::nullopt;
    if (jobs_.empty()) return;
    Progress progress("drawing pictures", int(jobs_.size()), options_.report);
    drawGallery(options_, input_, jobs_, until, [&](std::size_t job, GalleryDrawn drawn) {
      take(job, std::move(drawn));
      progress.advanceTo(++drawn_);
    });
  }

  void take(std::size_t job, GalleryDrawn drawn) {
    const GalleryShot& shot = input_.set.shots[jobs_[job].shot];
    GalleryRevision& kept = revision(jobs_[job]);
    for (Diagnostic& diagnostic : drawn.diagnostics) {
      if (diagnostic.at.file.empty() && input_.set.name != "default") diagnostic.at = shot.at;
      if (diagnostic.severity == Severity::Error) kept.problems.push_back(formatDiagnostic(diagnostic));
    }
    kept.picture = std::move(drawn.picture);
    if (kept.picture) files_.write(fileName(jobs_[job]), keys_[job], *kept.picture, report_, status_);
    if (!jobs_[job].before)
      report_.add(drawn.diagnostics);
    else if (!kept.picture)
      warnOfBefore(shot, drawn.diagnostics);
  }

  /// Mistakes of the older revision are no problems of this one.
  void warnOfBefore(const GalleryShot& shot, const Diagnostics& found) {
    const auto first = std::ranges::find(found, Severity::Error, &Diagnostic::severity);
    Diagnostics diagnostics(1);
    diagnostics[0].severity = Severity::Warning;
    diagnostics[0].id = "gallery-before";
    diagnostics[0].message = fmt::format("{} could not be drawn of {}", shot.name, options_.against);
    if (first != found.end())
      diagnostics[0].notes.push_back(fmt::format("{}: {}", formatLocation(first->at), first->message));
    report_.add(diagnostics);
  }

  /// Only now: comparing may start threads, which no worker could be forked from.
  bool compare() {
    for (GalleryEntry& entry : gallery_.entries) {
      if (!encode(entry.after) || !encode(entry.before)) return false;
      if (!entry.after.picture || !entry.before.picture) continue;
      entry.change = comparePictures(*entry.before.picture, *entry.after.picture, gallery_.files);
      if (entry.change->equal) continue;
      Diagnostics diagnostics;
      const auto png = encodePng(shownDifference(entry.before.picture->image, entry.after.picture->image), page_, diagnostics);
      report_.add(diagnostics);
      if (!png) return failed();
      entry.differencePng = *png;
    }
    return true;
  }

  bool encode(GalleryRevision& kept) {
    if (!kept.picture) return true;
    Diagnostics diagnostics;
    auto png = encodePng(kept.picture->image, page_, diagnostics);
    report_.add(diagnostics);
    if (!png) return failed();
    kept.png = std::move(*png);
    return true;
  }

  bool failed() {
    status_ = kHostFailed;
    return false;
  }

  std::size_t missing() const {
    std::size_t count = input_.set.shots.size() - gallery_.entries.size();
    for (const GalleryEntry& entry : gallery_.entries)
      count += std::size_t(!entry.after.picture && entry.after.problems.empty());
    return count;
  }

  void judge() {
    if (const std::size_t count = missing(); count > 0) {
      Diagnostics diagnostics(1);
      diagnostics[0].severity = Severity::Warning;
      diagnostics[0].id = "gallery-unfinished";
      diagnostics[0].message = fmt::format("{} of {} pictures are not drawn", count, input_.set.shots.size());
      diagnostics[0].hint = "with a folder for --output the same command goes on, without --shard to see all";
      report_.add(diagnostics);
    }
    for (const GalleryEntry& entry : gallery_.entries) {
      if (!options_.failAbove || !entry.change || entry.change->change <= *options_.failAbove) continue;
      report_.error("limit-exceeded", fmt::format("{} changed by {:.4f}, --fail-above allows {:.4g}", entry.name,
                                                  entry.change->change, *options_.failAbove));
    }
  }

  std::string summary() const {
    std::size_t drawn = 0, changed = 0;
    for (const GalleryEntry& entry : gallery_.entries) {
      drawn += std::size_t(entry.after.picture.has_value());
      changed += std::size_t(entry.change && !entry.change->equal);
    }
    const std::string text = fmt::format("{} of {} pictures", drawn, input_.set.shots.size());
    return gallery_.against ? fmt::format("{}, {} changed", text, changed) : text;
  }

  static json passesJson(const PictureChange& change) {
    json passes = json::array();
    for (const PassChange& pass : change.passes)
      if (pass.kind != Difference::Same)
        passes.push_back({{"pass", pass.name}, {"kind", differenceName(pass.kind)}, {"why", pass.why}});
    return passes;
  }

  static json entryJson(const GalleryEntry& entry) {
    json value = {{"name", entry.name}, {"drawn", entry.after.picture.has_value()}};
    if (entry.after.picture) {
      value["milliseconds"] = entry.after.picture->milliseconds;
      value["passes"] = entry.after.picture->passes.size();
      value["programs"] = entry.after.picture->programs.size();
    }
    if (entry.before.picture) value["millisecondsBefore"] = entry.before.picture->milliseconds;
    if (!entry.change) return value;
    value["equal"] = entry.change->equal;
    value["change"] = entry.change->change;
    value["rmse"] = entry.change->rmse;
    value["fractionAbove"] = entry.change->share;
    value["passesChanged"] = passesJson(*entry.change);
    return value;
  }

  json describe() const {
    json pictures = json::array(), files = json::array();
    for (const GalleryEntry& entry : gallery_.entries) pictures.push_back(entryJson(entry));
    for (const FileChange& file : gallery_.files)
      files.push_back({{"file", file.file}, {"kind", differenceName(file.kind)}});
    return {{"page", page_}, {"set", input_.set.name}, {"pictures", pictures}, {"files", files}, {"missing", missing()}};
  }

  const GalleryOptions& options_;
  Report& report_;
  std::string page_;
  GalleryFiles files_;
  GalleryInput input_;
  Gallery gallery_;
  std::map<std::size_t, std::size_t> entryOf_;  ///< by shot
  std::vector<GalleryJob> jobs_;
  std::vector<std::string> keys_;  ///< of the jobs
  int drawn_ = 0, status_ = kClean;
};

}  // namespace

int runGallery(const GalleryOptions& options, Report& report, json& result) {
  return GalleryRun(options, report).run(result);
}

}  // namespace orris
