#include "app/view/pack/program_text.h"

#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

struct NamedStage {
  std::string name;
  const ProgramSource* program;
  const StageText* stage;
  const std::vector<AppliedRule>* rules;
};

std::vector<NamedStage> stagesOf(const ShaderPack& pack) {
  std::vector<NamedStage> stages;
  for (const ProgramSource& program : pack.programs) {
    for (const StageText& stage : program.stages)
      stages.push_back({program.name + "." + stageExtension(stage.stage), &program, &stage, &program.rules});
    for (const ComputeSource& compute : program.computes)
      stages.push_back({compute.name + "." + stageExtension(Stage::Compute), &program, &compute.text, &compute.rules});
  }
  return stages;
}

}  // namespace

std::vector<int> ProgramText::linesFrom(const std::string& file, int line) const {
  std::vector<int> found;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].author.line == line && lines[i].author.file == file) found.push_back(int(i) + 1);
  return found;
}

int ProgramText::find(const std::string& words, int from) const {
  if (words.empty()) return 0;
  const int count = int(lines.size());
  for (int i = 0; i < count; ++i) {
    const int at = (from + i) % count;
    const ProgramLine& line = lines[std::size_t(at)];
    if (line.text.find(words) != std::string::npos || authorText(line) == words) return at + 1;
  }
  return 0;
}

std::vector<std::string> programTextNames(const ShaderPack& pack) {
  std::vector<std::string> names;
  for (const NamedStage& one : stagesOf(pack)) names.push_back(one.name);
  return names;
}

std::optional<ProgramText> programText(const ShaderPack& pack, const std::string& name) {
  const std::vector<NamedStage> stages = stagesOf(pack);
  const auto found = std::ranges::find(stages, name, &NamedStage::name);
  if (found == stages.end()) return std::nullopt;
  ProgramText result{.name = name, .rules = *found->rules};
  const MappedText& text = found->stage->text;
  int number = 0;
  for (std::string& line : splitLines(text.text)) {
    ++number;
    // A blank line has no token that came from somewhere.
    const bool mapped = std::size_t(number) <= text.lines.size() && !text.lines[std::size_t(number) - 1].empty();
    result.lines.push_back({std::move(line), mapped ? text.locate(number, 0) : SourceLocation()});
  }
  for (const std::string& option : found->program->options)
    result.options.push_back(option + "=" + pack.options.value(pack.values, option));
  for (const IncludeSite& site : text.sites)
    if (std::ranges::find(result.includes, site.file) == result.includes.end()) result.includes.push_back(site.file);
  return result;
}

std::string authorText(const ProgramLine& line) {
  return line.author.file.empty() ? "(host)" : fmt::format("{}:{}", line.author.file, line.author.line);
}

}  // namespace orris
