// In which process `orris view` draws: apart from its window, shut in, where a software rasteriser draws
// anyway; else in the one that owns the window, whose driver needs what a sandbox refuses.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/input/shipped_worlds.h"
#include "app/input/world_shelf.h"
#include "app/view/apart/remote_surface.h"
#include "app/view/surface/hidden_surface.h"
#include "app/view/surface/view_window.h"
#include "app/view/viewer.h"
#include <orris/core/add_diagnostic.h>
#include <orris/core/files/read_places.h>
#include <orris/core/work_record.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

/// Opens the window once the other process is there, and says whether that one shall draw.
class WindowAttendant final : public Attendant {
 public:
  WindowAttendant(ShownWindow& window, const WindowLink& link, Report& report)
      : window_(window), link_(link), report_(report) {}

  std::optional<int> attend() override {
    if (!opened_) {
      Diagnostics diagnostics;
      opened_ = window_.open(diagnostics);
      report_.add(diagnostics);
      if (!opened_) return report_.status();
      if (!window_.drawsElsewhere()) return kClean;
    }
    window_.attend();
    return std::nullopt;
  }
  int descriptor() const override { return link_.windowEnd(); }

 private:
  ShownWindow& window_;
  const WindowLink& link_;
  Report& report_;
  bool opened_ = false;
};

/// What the pack and its world are read from later, too. A folder that is made anew is another one to the
/// sandbox, but not its parent; that one is left out where something hidden lies in it.
void addPlacesToRead(const PackOptions& pack, const std::vector<std::string>& worlds) {
  std::error_code error;
  const auto isHidden = [](const fs::directory_entry& entry) {
    return entry.path().filename().string().starts_with(".");
  };
  if (fs::is_directory(fs::path(pack.path) / "shaders", error) &&
      std::none_of(fs::directory_iterator(pack.path, error), fs::directory_iterator(), isHidden))
    addReadPlace(pack.path);
  if (!pack.settingsFile.empty()) addReadPlace(pack.settingsFile);
  for (const std::string& world : worlds) addReadPlace(world);
  for (const std::string& world : recentWorlds()) addReadPlace(world);
  for (const std::string& name : shippedWorldNames()) addReadPlace(fs::path(findWorld(name)).parent_path());
  if (!recentWorldsFile().empty()) addReadPlace(fs::path(recentWorldsFile()).parent_path());
}

}  // namespace

AllowedFiles Viewer::filesApart() const {
  AllowedFiles files;
  const std::string optionFile = optionFileOf(options_.pack);
  files.outputs = {optionFile, recentWorldsFile(), options_.screenshot};
  files.isOutput = isScreenshotName;
  files.inputs = {optionFile, options_.pack.path};
  return files;
}

int Viewer::runInWindow() {
  // What a script does to files, a process that is shut in could not.
  if (player_) return drawHere(nullptr);
  WindowLink link;
  if (!link.usable()) return drawHere(nullptr);
  KeptPack kept;
  kept_ = &kept;
  const ImageOptions& image = options_.image;
  ShownWindow window({.width = image.width,
                      .height = image.height,
                      .profile = image.context,
                      .waitForRefresh = !hasFixedTime(),
                      .packPath = options_.pack.path},
                     link);
  WindowAttendant attendant(window, link, report_);
  // The process that draws is no child of the one with the window: to fork one that holds a driver is to
  // copy locks and lists of threads that are not there.
  const int status = runSupervised({.limits = options_.limits,
                                    .backend = gl::Backend::Egl,
                                    .software = true,
                                    .pack = options_.pack.path,
                                    .attendant = &attendant,
                                    .endsItself = true},
                                   report_, [&] { return keepDrawing(link); });
  auto context = window.takeContext();
  if (!context) return status;
  kept_ = nullptr;
  return drawHere(std::move(context));
}

int Viewer::keepDrawing(WindowLink& link) {
  noteIdle();  // time is counted for the process that draws
  for (;;) {
    bool draws = false;
    report_.beginAgain();
    const int status = runSupervised({.limits = options_.limits,
                                      .backend = gl::Backend::Egl,
                                      .software = true,
                                      .pack = options_.pack.path,
                                      .files = filesApart(),
                                      .confined = true,
                                      .endsItself = true},
                                     report_, [&] {
                                       draws = true;
                                       return drawApart(link);
                                     });
    if (draws || !kept_->canGoOn()) return status;
    death_ = report_.all().back();
    kept_->setAtRisk(false);
  }
}

int Viewer::drawApart(WindowLink& link) {
  addPlacesToRead(options_.pack, worldsBeside_);
  watchEvents_ = BackgroundWatch::openEvents();
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  link.closeWindowEnd();
  confineDrawing({link.drawingEnd(), watchEvents_});
  Diagnostics diagnostics;
  // Not OSMesa: the panels' library finds its functions by way of libGL, which knows the contexts of EGL.
  context_ = gl::createContext({.backend = gl::Backend::Egl, .profile = options_.image.context}, diagnostics);
  if (context_) surface_ = RemoteSurface::open(link);
  if (context_ && !surface_)
    addError(diagnostics, "gl-no-window", {}, "the process that opens the window does not answer", "");
  report_.add(diagnostics);
  return surface_ ? draw() : report_.status();
}

int Viewer::drawHere(std::unique_ptr<gl::Context> window) {
  const ImageOptions& image = options_.image;
  const bool hidden = image.backend == gl::Backend::Egl;
  Diagnostics diagnostics;
  context_ = window ? std::move(window)
                    : gl::createContext({.backend = hidden ? gl::Backend::Egl : gl::Backend::Glfw,
                                         .profile = image.context,
                                         .width = image.width,
                                         .height = image.height,
                                         .title = "Orris"},
                                        diagnostics);
  report_.add(diagnostics);
  if (!context_) return report_.status();
  if (hidden) {
    surface_ = std::make_unique<HiddenSurface>(image.width, image.height);
  } else {
    surface_ = std::make_unique<ViewWindow>(context_->window(), !hasFixedTime());
  }
  return draw();
}

}  // namespace orris
