// orris lsp: what an editor needs to know of a pack, over standard input and output.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdint>
#include <memory>

#include "app/commands/commands.h"
#include "app/input/common.h"
#include "app/lsp/server.h"
#include <orris/check/compile/target_limits.h>

namespace orris {

void addLspCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<ValidateOptions>();
  const auto named = std::make_shared<std::string>(options->target->name);
  CLI::App* command =
      app.add_subcommand("lsp", "answer an editor by the Language Server Protocol (docs/editors.md)");
  addPackFlags(*command, options->pack);
  std::vector<std::string> targets;
  for (const TargetLimits& target : targetTable()) targets.emplace_back(target.name);
  command->add_option("--target", *named, "whose rules, limits and macros: iris, apple, ...")
      ->check(CLI::IsMember(targets));
  command->add_option("--jobs", options->jobs, "processes")->check(CLI::Range(1, 256));
  command->add_flag_function(
      "--stdio", [](std::int64_t) {}, "said by some editors; it is always so");
  command->callback([options, named, &status] {
    options->target = findTarget(*named);
    std::signal(SIGPIPE, SIG_IGN);  // an editor that is gone is seen where it is written to
    LspWire wire(STDIN_FILENO, STDOUT_FILENO);
    status = LspServer(wire, *options).run();
  });
}

}  // namespace orris
