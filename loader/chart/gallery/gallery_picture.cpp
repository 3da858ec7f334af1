#include <orris/chart/gallery/gallery_picture.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include <orris/chart/measure/statistics.h>
#include <orris/chart/study/digest.h>
#include <orris/glsl/rewrite/rewrite.h>

namespace orris {
namespace {

using nlohmann::json;

constexpr float kSettlingTime = 0.25f;  // seconds of a frame of the first half: packs must bear a slow machine

/// Times of each pass over the frames that count, in the order of the first of them.
class GalleryPassTimes {
 public:
  void add(const std::vector<StepTime>& steps, FrameClock clock) {
    std::map<std::string, double> frame;  // a pass may run in several steps
    for (const StepTime& step : steps) {
      const double seconds = clock == FrameClock::Wall ? step.seconds : step.processorSeconds;
      if (!frame.contains(step.name) && !times_.contains(step.name)) names_.push_back(step.name);
      frame[step.name] += seconds * 1e3;
    }
    for (const auto& [name, milliseconds] : frame) times_[name].push_back(milliseconds);
  }
  std::vector<GalleryPass> passes() const {
    std::vector<GalleryPass> result;
    for (const std::string& name : names_) result.push_back({name, median(times_.at(name)), ""});
    return result;
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> times_;
};

void addStage(const std::string& name, const MappedText& text, GalleryProgram& program,
              std::set<std::string>& files) {
  program.stages[name] = Digest().add(text.text).value();
  for (const IncludeSite& site : text.sites) files.insert(site.file);
}

GalleryProgram describeProgram(const ProgramSource& source) {
  GalleryProgram program;
  std::set<std::string> files;
  for (const StageText& stage : source.stages)
    addStage(stageName(stage.stage), stage.text, program, files);
  for (const ComputeSource& compute : source.computes)
    addStage(compute.name, compute.text.text, program, files);
  program.files.assign(files.begin(), files.end());
  return program;
}

void addPrograms(const FrameRenderer& renderer, GalleryPicture& picture) {
  const auto& programs = renderer.pack().programs;
  for (const int index : renderer.schedule().programs) {
    const ProgramSource& source = programs[std::size_t(index)];
    picture.programs[source.name] = describeProgram(source);
  }
  for (const Step& step : renderer.schedule().frame) {
    const auto pass = std::ranges::find(picture.passes, step.name, &GalleryPass::name);
    if (pass != picture.passes.end() && step.program >= 0)
      pass->program = programs[std::size_t(step.program)].name;
  }
}

}  // namespace

Image8 withoutAlpha(const Image8& image) {
  Image8 result(image.width, image.height, 3);
  for (std::size_t from = 0, to = 0; to + 2 < result.pixels.size();
       from += std::size_t(image.channels), to += 3)
    std::copy_n(image.pixels.begin() + std::ptrdiff_t(from), 3,
                result.pixels.begin() + std::ptrdiff_t(to));
  return result;
}

std::optional<GalleryPicture> drawGalleryPicture(gl::Context& context, SessionRequest request,
                                                 World world, const GalleryWork& work,
                                                 Diagnostics& diagnostics) {
  request.renderer.timings = true;
  const float frameTime = request.frameTime;
  const auto session =
      RenderSession::create(context, std::move(request), std::move(world), diagnostics);
  if (!session) return std::nullopt;
  GalleryPassTimes passes;
  std::vector<double> frames;
  for (int frame = 0; frame < work.frames; ++frame) {
    const bool settling = frame < work.frames / 2;
    session->setFrameTime(settling ? kSettlingTime : frameTime);
    const double start = millisecondsOf(work.clock);
    session->renderFrame(diagnostics);
    if (settling) continue;
    frames.push_back(millisecondsOf(work.clock) - start);
    passes.add(session->renderer().stepTimes(), work.clock);
  }
  const std::vector<std::string> errors = context.takeErrors();
  for (const std::string& message : errors)
    diagnostics.push_back({.id = "gl-error", .at = {}, .message = message});
  if (!errors.empty()) return std::nullopt;
  GalleryPicture picture;
  picture.image = withoutAlpha(session->renderer().screenshot());
  picture.milliseconds = median(frames);
  picture.passes = passes.passes();
  picture.leftOut = session->renderer().programsLeftOut();
  addPrograms(session->renderer(), picture);
  return picture;
}

std::string writeGalleryNumbers(const GalleryPicture& picture) {
  json passes = json::array(), programs = json::object();
  for (const GalleryPass& pass : picture.passes)
    passes.push_back({pass.name, pass.milliseconds, pass.program});
  for (const auto& [name, program] : picture.programs)
    programs[name] = {{"stages", program.stages}, {"files", program.files}};
  const json numbers = {{"milliseconds", picture.milliseconds},
                        {"passes", std::move(passes)},
                        {"programs", std::move(programs)},
                        {"leftOut", picture.leftOut}};
  return numbers.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::optional<GalleryPicture> parseGalleryNumbers(std::string_view text) {
  GalleryPicture picture;
  try {
    const json numbers = json::parse(text);
    picture.milliseconds = numbers.at("milliseconds").get<double>();
    for (const json& pass : numbers.at("passes"))
      picture.passes.push_back({pass.at(0), pass.at(1), pass.at(2)});
    for (const auto& [name, program] : numbers.at("programs").items())
      picture.programs[name] = {program.at("stages").get<std::map<std::string, std::uint64_t>>(),
                                program.at("files").get<std::vector<std::string>>()};
    picture.leftOut = numbers.at("leftOut").get<std::vector<std::string>>();
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return picture;
}

}  // namespace orris
