// The command `orris`: picks the subcommand, and turns what went wrong with the command line into
// exit status 2.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/exit_status.h"

namespace orris {
namespace {

using AddCommand = void (*)(CLI::App& app, int& status);
constexpr AddCommand kCommands[] = {addRenderCommand, addValidateCommand, addOptionsCommand,
                                    addWorldCommand,  addCompareCommand,  addViewCommand,
                                    addTraceCommand,  addChartCommand,    addTuneCommand};

// Flags that take several assignments: "--set A=1 B=2" is "--set A=1 --set B=2". Left to the parser,
// such a flag would swallow the positional arguments behind it.
constexpr const char* kAssignmentFlags[] = {"--set", "--dump"};

std::vector<std::string> repeatAssignmentFlags(int argc, char** argv) {
  std::vector<std::string> result;
  std::string flag;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool isFlag = word.starts_with('-');
    const bool another =
        !flag.empty() && !isFlag && word.find('=') != std::string::npos && result.back() != flag;
    if (another) result.push_back(flag);
    result.push_back(word);
    const bool takesSeveral = std::find(std::begin(kAssignmentFlags), std::end(kAssignmentFlags),
                                        word) != std::end(kAssignmentFlags);
    if (takesSeveral)
      flag = word;
    else if (isFlag || word.find('=') == std::string::npos)
      flag.clear();
  }
  return result;
}

int reportUsage(const CLI::App& app, const CLI::ParseError& error) {
  std::string name = "orris";
  for (const CLI::App* command : app.get_subcommands()) name += " " + command->get_name();
  std::cerr << fmt::format("{}: error: {}\n  hint: {} --help\n", name, error.what(), name);
  return kUsage;
}

int run(int argc, char** argv) {
  CLI::App app("Hosts Iris-format shader packs without a game, a window or a GPU.", "orris");
  app.set_version_flag("--version", "orris " ORRIS_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 clean, 1 problems found, 2 wrong usage or unreadable input, 3 the host "
      "failed.");
  int status = kClean;
  for (const AddCommand add : kCommands) add(app, status);
  // CLI11 reads it for the main program only; a section for each command then names its flags.
  app.set_config("--config", "orris.toml", "read flags from this file, in sections like [validate]")
      ->type_name("FILE");
  app.allow_config_extras(CLI::config_extras_mode::error);
  for (CLI::App* command : app.get_subcommands({})) {
    command->fallthrough();
    command->allow_config_extras(CLI::config_extras_mode::error);
  }

  std::vector<std::string> arguments = repeatAssignmentFlags(argc, argv);
  std::reverse(arguments.begin(), arguments.end());  // the order CLI11 takes a vector in
  try {
    app.parse(arguments);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help, --version
  } catch (const CLI::ParseError& error) {
    return reportUsage(app, error);
  }
  return status;
}

}  // namespace
}  // namespace orris

int main(int argc, char** argv) {
  int status = orris::kHostFailed;
  try {
    status = orris::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "orris: error: " << error.what() << '\n';
  }
  std::cout.flush();
  if (!std::cout && status == orris::kClean) {
    std::cerr << "orris: error: standard output cannot be written\n";
    return orris::kHostFailed;
  }
  return status;
}
