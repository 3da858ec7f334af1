// Counts against the limits of the target. Only active code counts: the preprocessor has run.
#include <fmt/format.h>

#include <algorithm>

#include <orris/check/compile/shared_memory.h>
#include <orris/check/interface/declaration_checks.h>
#include <orris/check/interface/glsl_types.h>
#include <orris/pack/files/text.h>
#include <orris/plan/schedule/program_uses.h>

namespace orris {
namespace {

using Storage = StageGlobal::Storage;

constexpr std::int64_t kMostElements = 1 << 20;

std::int64_t elementsOf(const StageGlobal& global) {
  std::int64_t count = 1;
  for (const std::int64_t size : global.arraySizes)
    count = std::min(kMostElements, count * std::clamp<std::int64_t>(size, 1, kMostElements));
  return count;
}

bool isUsedSampler(const StageGlobal& g) {
  const OpaqueType type = opaqueType(g.type);
  return g.used && g.storage == Storage::Uniform && type.component != 0 && !type.image;
}
bool isUsedImage(const StageGlobal& g) {
  return g.used && g.storage == Storage::Uniform && opaqueType(g.type).image;
}
bool isUsedStorage(const StageGlobal& g) { return g.used && g.storage == Storage::Buffer; }
bool isUsedInput(const StageGlobal& g) {
  return g.used && g.storage == Storage::In && !g.block && !g.name.starts_with("gl_");
}

std::int64_t attributeSlots(const StageGlobal& g) {
  return elementsOf(g) * std::max(1, numericType(g.type).columns);
}
std::int64_t components(const StageGlobal& g) {
  const NumericType type = numericType(g.type);
  return elementsOf(g) * std::max(1, type.columns * type.rows);
}

/// Something that is counted in one stage.
struct Count {
  const char* what;
  bool (*counts)(const StageGlobal&);
  std::int64_t (*weight)(const StageGlobal&);
  int TargetLimits::*limit;
  std::optional<Stage> only;  ///< nullopt: every stage
};
constexpr Count kCounts[] = {
    {"samplers", isUsedSampler, elementsOf, &TargetLimits::samplers, std::nullopt},
    {"images", isUsedImage, elementsOf, &TargetLimits::images, std::nullopt},
    {"storage buffers", isUsedStorage, elementsOf, &TargetLimits::storageBuffers, std::nullopt},
    {"vertex attributes", isUsedInput, attributeSlots, &TargetLimits::vertexAttributes,
     Stage::Vertex},
    {"varying components", isUsedInput, components, &TargetLimits::varyingComponents,
     Stage::Fragment},
};

class StageCounts {
 public:
  StageCounts(const ProgramInterface& program, const StageInterface& stage,
              DeclarationReport& report)
      : program_(program), stage_(stage), report_(report), target_(report.folder.target) {}

  void check() {
    checkVersion();
    for (const Count& count : kCounts) checkCount(count);
    if (stage_.stage->stage == Stage::Compute) checkCompute();
    if (!target_.iris) checkCustomImages();
  }

 private:
  void checkVersion() {
    const int version = report_.writtenVersion(stage_);
    const auto isMalformed = [](const Diagnostic& d) { return d.id == "version-malformed"; };
    // A version that GLSL does not have is beyond every target.
    if (version <= target_.glslVersion || std::ranges::any_of(program_.program->diagnostics, isMalformed)) return;
    report(stage_.stage->text.locate(1, 1),
           fmt::format("#version {} is more than {} offers: {}", version, target_.fullName,
                       target_.glslVersion));
  }

  void checkCount(const Count& count) {
    if (count.only && *count.only != stage_.stage->stage) return;
    const int limit = target_.*count.limit;
    std::int64_t total = 0;
    const StageGlobal* first = nullptr;
    for (const StageGlobal& global : stage_.globals) {
      if (!count.counts(global)) continue;
      total += count.weight(global);
      if (total > limit && !first) first = &global;
    }
    if (!first) return;
    report(first->place,
           fmt::format("the {} stage uses {} {}, {} offers {}", stageName(stage_.stage->stage),
                       total, count.what, target_.fullName, limit));
  }

  void checkCompute() {
    if (!target_.compute) {
      return report(stage_.stage->text.locate(1, 1),
                    fmt::format("{} has no compute shaders", target_.fullName));
    }
    const auto bytes = sharedMemoryBytes(stage_);
    if (!bytes || *bytes <= target_.sharedMemoryBytes) return;
    const auto variable = std::find_if(
        stage_.globals.begin(), stage_.globals.end(),
        [](const StageGlobal& global) { return global.storage == Storage::Shared && global.used; });
    report(variable->place, fmt::format("the shared variables take {} bytes, {} offers {}", *bytes,
                                        target_.fullName, target_.sharedMemoryBytes));
  }

  void checkCustomImages() {
    for (const StageGlobal& global : stage_.globals) {
      if (!isUsedImage(global) || parseBufferName(global.name, false)) continue;
      report(global.place, fmt::format("{} has no custom images", target_.fullName));
    }
  }

  DeclarationReport::Finding finding(std::string message) const {
    return {Severity::Warning,
            "target-limit",
            std::move(message),
            "a limit of the target, not a mistake of the pack",
            {"in " + program_.name()}};
  }
  void report(const TextPlace& place, std::string message) {
    report_.add(stage_, place, finding(std::move(message)));
  }
  void report(const SourceLocation& at, std::string message) {
    report_.add(at, finding(std::move(message)));
  }

  const ProgramInterface& program_;
  const StageInterface& stage_;
  DeclarationReport& report_;
  const TargetLimits& target_;
};

}  // namespace

void checkResourceCounts(const ProgramInterface& program, DeclarationReport& report) {
  for (const StageInterface& stage : program.stages) StageCounts(program, stage, report).check();
}

}  // namespace orris
