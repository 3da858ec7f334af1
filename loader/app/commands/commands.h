// The subcommands of `orris`: each adds itself to the command line and sets the exit status when it
// runs. Exit status: 0 clean, 1 problems found, 2 wrong usage or unreadable input, 3 host failure.
#pragma once

namespace CLI {
class App;
}

namespace orris {

struct FolderConfig;

void addRenderCommand(CLI::App& app, int& status);
/// `folder`: what orris.toml of the working folder asks for; kept until the command has run.
void addValidateCommand(CLI::App& app, int& status, const FolderConfig& folder);
void addOptionsCommand(CLI::App& app, int& status);
void addWorldCommand(CLI::App& app, int& status);
void addCompareCommand(CLI::App& app, int& status);
void addViewCommand(CLI::App& app, int& status);
void addTraceCommand(CLI::App& app, int& status);
void addChartCommand(CLI::App& app, int& status);
void addTuneCommand(CLI::App& app, int& status);
void addGalleryCommand(CLI::App& app, int& status);
void addDoctorCommand(CLI::App& app, int& status);
void addLspCommand(CLI::App& app, int& status);

}  // namespace orris
