#include <orris/check/matrix/matrix_plan.h>

#include <algorithm>
#include <map>

namespace orris {
namespace {

/// Makes the jobs of one build, configuration by configuration.
class BuildPlanner {
 public:
  BuildPlanner(const ShaderPack& pack, std::size_t index, MatrixVariants& variants,
               MatrixPlan& plan)
      : index_(index), variants_(variants), plan_(plan) {
    const FolderBuild& build = *plan.builds[index];
    for (const ProgramSource& program : pack.programs) known_[program.name] = &program;
    const auto& profiles = build.properties().shader.profiles;
    profilesDisable_ = std::any_of(profiles.begin(), profiles.end(),
                                   [](const Profile& p) { return !p.disabledPrograms.empty(); });
  }

  void addJobs(std::size_t configuration, bool tellProperties) {
    const FolderBuild& build = *plan_.builds[index_];
    const OptionValues& values = plan_.configurations[configuration];
    const auto changed = differingOptions(build.files().options, build.values(), values);
    const bool properties = haveCommonName(changed, build.properties().options);
    const bool others = properties || profilesDisable_;
    if (properties && tellProperties) plan_.jobs.push_back({configuration, index_, nullptr});
    for (const ProgramEntry& entry : others ? entriesFor(values) : build.programs()) {
      const auto known = known_.find(entry.name.program);
      if (known == known_.end() || !sameFiles(entry, *known->second) ||
          haveCommonName(changed, known->second->options)) {
        plan_.jobs.push_back({configuration, index_, &entry});
      }
    }
  }

 private:
  static bool sameFiles(const ProgramEntry& entry, const ProgramSource& program) {
    return entry.stages.size() == program.stages.size() &&
           entry.computes.size() == program.computes.size();
  }

  /// Listed once for each set of values that the properties can tell apart.
  const std::vector<ProgramEntry>& entriesFor(const OptionValues& values) {
    const FolderBuild& build = *plan_.builds[index_];
    const auto& asked = build.properties().options;
    std::string key;
    for (const std::string& name : profilesDisable_ ? build.files().optionNames : asked) {
      key += build.files().options.value(values, name) + '\n';
    }
    auto& made = byKey_[key];
    if (!made) {
      plan_.entries.push_back(variants_.get(index_, values).programs());
      made = &plan_.entries.back();
    }
    return *made;
  }

  std::size_t index_;
  MatrixVariants& variants_;
  MatrixPlan& plan_;
  std::map<std::string, const ProgramSource*> known_;
  std::map<std::string, const std::vector<ProgramEntry>*> byKey_;
  bool profilesDisable_ = false;
};

std::vector<OptionValues> configurationsOf(const MatrixBase& base, const MatrixRequest& request,
                                           const std::function<bool()>& stop) {
  const ShaderPack& first = base.folders.front();
  auto axes = matrixAxes(base.folders, request.options);
  if (request.kind == MatrixKind::Pairwise) thinNumbers(axes);
  const auto all = matrixConfigurations(request.kind, axes, first.options, first.values, stop);
  std::vector<OptionValues> ours;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % static_cast<std::size_t>(request.shards) + 1 == static_cast<std::size_t>(request.shard))
      ours.push_back(all[i]);
  }
  return ours;
}

}  // namespace

MatrixPlan planMatrix(const MatrixBase& base, const MatrixRequest& request,
                      std::optional<std::chrono::steady_clock::time_point> until) {
  MatrixPlan plan;
  if (base.folders.empty()) return plan;
  const auto isOver = [&] { return until && std::chrono::steady_clock::now() >= *until; };
  plan.configurations = configurationsOf(base, request, isOver);
  plan.all = !isOver();
  for (const ShaderPack& pack : base.folders) plan.builds.push_back(pack.builds.front());
  MatrixVariants variants(plan, base.environment);
  std::vector<BuildPlanner> planners;
  for (std::size_t i = 0; i < plan.builds.size(); ++i) {
    planners.emplace_back(base.folders[i], i, variants, plan);
  }
  for (std::size_t c = 0; c < plan.configurations.size(); ++c) {
    if (isOver()) {
      plan.left = plan.configurations.size() - c;
      plan.configurations.resize(c);
      break;
    }
    // shaders.properties and the id maps are those of the pack, whatever the folder.
    for (std::size_t i = 0; i < planners.size(); ++i) planners[i].addJobs(c, i == 0);
  }
  return plan;
}

const FolderBuild& MatrixVariants::get(std::size_t build, const OptionValues& values) {
  const FolderBuild& base = *plan_.builds[build];
  const bool current = last_ && last_->values() == values;
  if (current && last_->folder() == base.folder()) return *last_;
  last_ =
      std::make_shared<const FolderBuild>(base.sharedFiles(), base.folder(), values, environment_,
                                          base.irisTexts(), current ? last_.get() : &base);
  return *last_;
}

}  // namespace orris
