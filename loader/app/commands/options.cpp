// orris options: the options of a pack, where they are defined and which programs they reach.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/commands/commands.h"
#include "app/commands/graph.h"
#include "app/commands/option_tree.h"
#include "app/input/inputs.h"
#include <orris/pack/programs/live_check.h>
#include <orris/plan/schedule/auto_choices.h>

namespace orris {
namespace {

struct OptionsOptions {
  PackOptions pack;
  std::vector<std::string> filter;  ///< words of the options to print
  std::string graph;                ///< file to write, "-" for standard output, "" for none
  OutputOptions output;
};

using Reach = std::map<std::string, std::set<std::string>>;  // option -> programs
using Live = std::map<std::string, std::string>;             // option -> why it is not, "" if it is

std::string join(const std::vector<std::string>& words, const char* between) {
  return fmt::format("{}", fmt::join(words, between));
}

Reach reachOf(const ShaderPack& pack) {
  Reach reach;
  for (const ProgramSource& program : pack.programs) {
    for (const std::string& option : program.options) reach[option].insert(program.name);
  }
  return reach;
}

/// What each value costs where the host chooses: value -> formula, in the pack's order.
std::vector<std::pair<std::string, std::string>> costsOf(const ShaderPack& pack,
                                                         const std::string& option) {
  std::vector<std::pair<std::string, std::string>> costs;
  for (const AutoCandidate& candidate : autoCandidates(pack))
    if (candidate.option == option) costs.emplace_back(candidate.value, candidate.formula());
  return costs;
}

nlohmann::json optionsJson(const ShaderPack& pack, const Option& option, const Reach& reach,
                           const Live& live) {
  nlohmann::json costs = nlohmann::json::array();
  for (const auto& [value, formula] : costsOf(pack, option.name))
    costs.push_back({{"value", value}, {"milliseconds", formula}});
  nlohmann::json places = nlohmann::json::array();
  for (const SourceLocation& place : option.at) places.push_back(toJson(place));
  const auto programs = reach.find(option.name);
  return {{"name", option.name},
          {"label", labelOf(pack, "option." + option.name)},
          {"comment", option.comment},
          {"boolean", option.isBoolean},
          {"value", pack.options.value(pack.values, option.name)},
          {"default", option.defaultValue},
          {"values", option.values},
          {"definedAt", places},
          {"auto", costs},
          {"live", live.at(option.name).empty()},
          {"notLive", live.at(option.name)},
          {"programs", programs == reach.end() ? std::set<std::string>() : programs->second}};
}

nlohmann::json optionsJson(const ShaderPack& pack) {
  const Reach reach = reachOf(pack);
  const Live live = liveOptions(pack);
  nlohmann::json options = nlohmann::json::array(), profiles = options, screens = options;
  for (const auto& [name, option] : pack.options.all()) {
    options.push_back(optionsJson(pack, option, reach, live));
  }
  for (const Profile& profile : pack.properties.profiles) {
    profiles.push_back({{"name", profile.name},
                        {"values", profile.values},
                        {"disabledPrograms", profile.disabledPrograms}});
  }
  for (const Screen& screen : pack.properties.screens) {
    screens.push_back({{"name", screen.name}, {"entries", screen.entries}});
  }
  return {{"pack", pack.name},
          {"folder", pack.folder},
          {"profile", pack.currentProfile()},
          {"options", options},
          {"profiles", profiles},
          {"screens", screens},
          {"sliders", pack.properties.sliders}};
}

/// One line, or with `details` where it is defined and what it reaches too.
std::vector<std::string> linesOf(const ShaderPack& pack, const Option& option, const Reach& reach,
                                 const Live* live) {
  const std::string value = pack.options.value(pack.values, option.name);
  std::string head = fmt::format("{} = {}", option.name, value);
  if (value != option.defaultValue) head += fmt::format(" (default {})", option.defaultValue);
  if (!option.isBoolean) head += fmt::format("  [{}]", join(option.values, " "));
  const std::string label = labelOf(pack, "option." + option.name);
  if (!label.empty()) head += "  " + label;
  std::vector<std::string> lines = {head};
  if (live == nullptr) return lines;
  for (const SourceLocation& place : option.at)
    lines.push_back(fmt::format("defined  {}:{}", place.file, place.line));
  for (const auto& [candidate, cost] : costsOf(pack, option.name))
    lines.push_back(fmt::format("auto     {}: {} ms", candidate, cost));
  const auto programs = reach.find(option.name);
  lines.push_back("reaches  " + (programs == reach.end()
                                     ? "no program of this folder"
                                     : fmt::format("{}", fmt::join(programs->second, " "))));
  const std::string& reason = live->at(option.name);
  lines.push_back("live     " + (reason.empty() ? "yes" : "no: " + reason));
  return lines;
}

void printProfiles(const ShaderPack& pack) {
  const std::string current = pack.currentProfile();
  for (const Profile& profile : pack.properties.profiles) {
    std::string text = "profile " + profile.name + (profile.name == current ? " (current)" : "");
    for (const auto& [name, value] : profile.values) text += fmt::format(" {}={}", name, value);
    printText(text + '\n');
  }
}

void printPack(const ShaderPack& pack, const std::vector<std::string>& filter, bool verbose) {
  const Reach reach = reachOf(pack);
  const auto wanted = [&](const Option& option) { return matchesFilter(pack, option, filter); };
  const bool details = verbose || !filter.empty();
  const Live live = details ? liveOptions(pack) : Live();
  const std::string tree = optionTree(
      pack, wanted, [&](const Option& option) { return linesOf(pack, option, reach, details ? &live : nullptr); });
  printText(tree);
  if (filter.empty()) {
    printProfiles(pack);
  } else if (tree.empty()) {
    printText(fmt::format("no option has {}\n", join(filter, " and ")));
  }
}

/// What people call the pack: its folder or file without extension.
std::string titleOf(const std::string& path) {
  const std::filesystem::path absolute = std::filesystem::absolute(path).lexically_normal();
  const std::filesystem::path last = absolute.has_filename() ? absolute : absolute.parent_path();
  return last.extension() == ".zip" ? last.stem().string() : last.filename().string();
}

int runOptions(const OptionsOptions& options) {
  Report report(options.output);
  const auto files = openPackFiles(options.pack.path, report);
  const auto request =
      files ? makeLoadRequest(files, options.pack,
                              standardMacros({.versions = options.pack.versions}), report)
            : std::nullopt;
  const auto pack = request ? loadPack(files, *request, report) : std::nullopt;
  if (!pack) {
    printJson(nlohmann::json::object(), report);
    return report.status();
  }
  if (!options.graph.empty()) {
    if (!writeGraph(*pack, titleOf(options.pack.path), options.graph, report))
      return report.status();
  } else if (!options.output.json) {
    printPack(*pack, options.filter, options.output.verbose);
  }
  if (options.output.json) printJson(optionsJson(*pack), report);
  return report.status();
}

}  // namespace

void addOptionsCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<OptionsOptions>();
  CLI::App* command = app.add_subcommand(
      "options", "options of a pack: values, profiles, screens, programs reached");
  addPackArgument(*command, options->pack.path);
  command
      ->add_option("filter", options->filter,
                   "print only options with all these words in their name, label, comment or "
                   "values, and where each is defined and what it reaches")
      ->type_name("WORD");
  addPackFlags(*command, options->pack);
  addVersionFlags(*command, options->pack.versions);
  command
      ->add_option(
          "--graph", options->graph,
          "write the pass graph instead: .svg, .png, .pdf, .dot, .json, .md, or - to print "
          "tables")
      ->type_name("FILE");
  addOutputFlags(*command, options->output);
  command->callback([options, &status] { status = runOptions(*options); });
}

}  // namespace orris
