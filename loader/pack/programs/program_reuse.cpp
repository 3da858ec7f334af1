#include <orris/pack/programs/program_reuse.h>

#include <algorithm>

namespace orris {
namespace {

template <typename Map>
bool sameEntry(const Map& a, const Map& b, const std::string& key) {
  const auto inA = a.find(key), inB = b.find(key);
  if (inA == a.end() || inB == b.end()) return (inA == a.end()) == (inB == b.end());
  return inA->second == inB->second;
}

/// Do both say the same of one program?
bool sameState(const ShaderProperties& a, const ShaderProperties& b, const std::string& program) {
  return &a == &b ||
         (sameEntry(a.alphaTest, b.alphaTest, program) && sameEntry(a.blend, b.blend, program) &&
          sameEntry(a.bufferBlend, b.bufferBlend, program) &&
          sameEntry(a.scale, b.scale, program) && sameEntry(a.flip, b.flip, program));
}

/// Files of `b` that `a` has otherwise or not at all: their lines, and what these include, which may be in error.
std::set<std::string> editedBetween(const FolderBuild& a, const FolderBuild& b) {
  std::set<std::string> edited;
  if (&a.files() == &b.files()) return edited;
  const PackFiles &before = a.files(), &after = b.files();
  for (const auto& [file, unused] : after.graph.files) {
    const FileLines* old = a.lines(file);
    const bool same = old && *old == *b.lines(file) &&
                      sameEntry(before.graph.includes, after.graph.includes, file);
    if (!same) edited.insert(file);
  }
  return edited;
}

}  // namespace

ProgramReuse::ProgramReuse(const FolderBuild* old, const ProgramList& programs,
                           const FolderBuild& build)
    : old_(old), programs_(programs), build_(build) {
  if (!old) return;
  // Which names are options decides of which options a program's text depends on.
  usable_ = old->folder() == build.folder() && old->irisTexts() == build.irisTexts() &&
            old->properties().shaderMacros == build.properties().shaderMacros &&
            old->preludeOfVoxy() == build.preludeOfVoxy() &&
            old->files().optionNames == build.files().optionNames;
  if (!usable_) return;
  changed_ = differingOptions(build.files().options, old->textValues(), build.textValues());
  edited_ = editedBetween(*old, build);
}

ProgramList::Pointer ProgramReuse::operator()(const ProgramEntry& entry) const {
  for (size_t i = 0; usable_ && i < programs_.size(); ++i) {
    const auto& program = programs_.share(i);
    if (program->name == entry.name.program && program->group == entry.name.group)
      return isSame(entry, *program) ? program : nullptr;
  }
  return nullptr;
}

bool ProgramReuse::isSame(const ProgramEntry& entry, const ProgramSource& program) const {
  const ProgramEntry* before = old_->entryNamed(program.name);
  // A stage may be new, a single compute shader of a program disabled.
  return before && before->stages == entry.stages && before->computes == entry.computes &&
         !haveCommonName(changed_, program.options) && !reachesEdit(entry) &&
         sameState(old_->properties().shader, build_.properties().shader, program.name);
}

bool ProgramReuse::reachesEdit(const ProgramEntry& entry) const {
  if (edited_.empty()) return false;
  const auto reaches = [&](const auto& named) {
    return std::ranges::any_of(reachableFiles(build_.files().graph, named.second),
                               [&](const std::string& file) { return edited_.contains(file); });
  };
  return std::ranges::any_of(entry.stages, reaches) || std::ranges::any_of(entry.computes, reaches);
}

}  // namespace orris
