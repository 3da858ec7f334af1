// The command `orris`: picks the subcommand, and turns what went wrong with the command line into
// exit status 2.
#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/commands.h"
#include <orris/core/exit_status.h>
#include "app/input/folder_config.h"
#include <orris/core/printable.h>
#include <orris/core/work_stage.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

void addCommands(CLI::App& app, int& status, const FolderConfig& folder) {
  addRenderCommand(app, status);
  addValidateCommand(app, status, folder);
  addOptionsCommand(app, status);
  addWorldCommand(app, status);
  addCompareCommand(app, status);
  addViewCommand(app, status);
  addTraceCommand(app, status);
  addChartCommand(app, status);
  addTuneCommand(app, status);
  addGalleryCommand(app, status);
  addDoctorCommand(app, status);
  addLspCommand(app, status);
}

// Flags that take several assignments: "--set A=1 B=2" is "--set A=1 --set B=2". Left to the parser,
// such a flag would swallow the positional arguments behind it.
constexpr const char* kAssignmentFlags[] = {"--set", "--dump", "--show"};

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
  std::cerr << printableLines(
      fmt::format("{}: error: {}\n  hint: {} --help\n", name, error.what(), name));
  return kUsage;
}

/// What --config names; "" with --no-config, nullopt without either.
std::optional<std::string> chosenConfig(const std::vector<std::string>& arguments) {
  constexpr std::string_view kFlag = "--config", kAssigned = "--config=";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--no-config") return "";
    if (arguments[i] == kFlag) return i + 1 < arguments.size() ? arguments[i + 1] : "";
    if (arguments[i].starts_with(kAssigned)) return arguments[i].substr(kAssigned.size());
  }
  return std::nullopt;
}

/// The file of the working folder, unless the command line says which file to read, or none. nullopt: reported.
std::optional<FolderConfig> unaskedConfig(const std::vector<std::string>& arguments) {
  const std::optional<std::string> chosen = chosenConfig(arguments);
  Diagnostics diagnostics;
  std::optional<FolderConfig> config = FolderConfig{};
  if (!chosen)
    config = readFolderConfig(".", diagnostics);
  else if (!chosen->empty() && !isBoundedConfig(*chosen, diagnostics))
    config = std::nullopt;
  for (const Diagnostic& diagnostic : diagnostics)
    std::cerr << formatDiagnostic(diagnostic) << '\n';
  return config;
}

/// The first word is a command; the parser would only say that one is required.
bool knowsCommand(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return true;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), words.front()) != names.end()) return true;
  const std::string meant = suggest(words.front(), names);
  std::cerr << fmt::format("orris: error: there is no command '{}'\n  hint: {}\n",
                           printable(words.front()),
                           meant.empty() ? "orris --help lists them" : meant);
  return false;
}

/// A flag without its value would take the next flag for it, and write a file of that name.
void refuseFlagsAsValues(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() == 0) continue;
    option->check([&command](const std::string& text) {
      const bool isFlag = text.starts_with("--") && command.get_option_no_throw(text) != nullptr;
      return isFlag ? fmt::format("expected a value before {}", text) : std::string();
    });
  }
}

int run(int argc, char** argv) {
  std::vector<std::string> arguments = repeatAssignmentFlags(argc, argv);
  const std::optional<FolderConfig> folder = unaskedConfig(arguments);
  if (!folder) return kUsage;
  CLI::App app("Hosts Iris-format shader packs without a game, a window or a GPU.", "orris");
  app.set_version_flag("--version", "orris " ORRIS_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 clean, 1 problems found, 2 wrong usage or unreadable input, 3 the host "
      "failed.");
  int status = kClean;
  addCommands(app, status, *folder);
  // CLI11 reads it for the main program only; a section for each command then names its flags.
  app.set_config("--config", folder->present ? kFolderConfig : "",
                 "read flags from this file, in sections like [validate]; default: what orris.toml "
                 "of the working folder chooses without naming files")
      ->type_name("FILE");
  // The value is looked up before the command line is parsed.
  app.add_flag_function(
      "--no-config", [](std::int64_t) {}, "do not read orris.toml of the working folder");
  app.allow_config_extras(CLI::config_extras_mode::error);
  for (CLI::App* command : app.get_subcommands({})) {
    command->fallthrough();
    command->allow_config_extras(CLI::config_extras_mode::error);
    refuseFlagsAsValues(*command);
  }

  if (!knowsCommand(app, arguments)) return kUsage;
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
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the limit is then an error of its writer
  // As glibc sets them by itself once a block of that size was freed. Until then it gives the end of the heap back each time
  // 128 kB are free there, and a software rasteriser frees more in every draw: a quarter of a frame went into new pages.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  try {
    status = orris::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "orris: error: out of memory " << orris::printable(orris::WorkStage::whereFailed())
              << "\n  hint: leave out parts of what was named, or allow more memory\n";
  } catch (const std::exception& error) {
    std::cerr << "orris: error: " << orris::printable(error.what()) << '\n';
  }
  std::cout.flush();
  if (!std::cout && status == orris::kClean) {
    std::cerr << "orris: error: standard output cannot be written\n";
    return orris::kHostFailed;
  }
  return status;
}
