#include "app/study/plot_process.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>

#include "app/output/child_process.h"
#include <orris/check/workers/sandbox.h>
#include <orris/core/socket_bytes.h>

namespace orris {
namespace {

constexpr std::chrono::seconds kLongestPlot{60};
constexpr std::uint64_t kMostScriptBytes = std::uint64_t{64} << 20;
constexpr const char* kSvg = "set terminal svg size 1000,600 font 'sans-serif,12' background rgb 'white'\n";
constexpr const char* kPng = "set terminal pngcairo size 1000,600 font 'sans,10'\n";

enum class Plotted : std::uint32_t { Drawn, Missing, Stopped, Failed };

struct PlotAnswer {
  Plotted plotted = Plotted::Missing;
  std::string text{};  ///< the picture, or what gnuplot said
};

void shutGnuplotIn() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  enterSandboxToRunProgram({"/etc/fonts", "/var/cache/fontconfig"});
}

PlotAnswer runGnuplot(const std::string& script) {
  auto result = runChild({"gnuplot", "-d", "-"}, script, kLongestPlot, shutGnuplotIn);
  if (!result || result->missing) return {Plotted::Missing};
  if (result->succeeded()) return {Plotted::Drawn, std::move(result->output)};
  if (!result->exitStatus) return {Plotted::Stopped};
  return {Plotted::Failed, std::move(result->errors)};
}

bool sendPlotText(int socket, const std::string& text) {
  const std::uint64_t size = text.size();
  return sendAll(socket, &size, sizeof size) && sendAll(socket, text.data(), text.size());
}

std::optional<std::string> receivePlotText(int socket, std::uint64_t most) {
  std::uint64_t size = 0;
  if (!receiveAll(socket, &size, sizeof size) || size > most) return std::nullopt;
  std::string text(size, '\0');
  return receiveAll(socket, text.data(), text.size()) ? std::optional(std::move(text)) : std::nullopt;
}

/// The life of the process: script in, plot out, until the socket closes.
[[noreturn]] void drawPlots(int socket) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  closeOpenFiles({socket});
  while (const auto script = receivePlotText(socket, kMostScriptBytes)) {
    const PlotAnswer answer = runGnuplot(*script);
    if (!sendAll(socket, &answer.plotted, sizeof answer.plotted) || !sendPlotText(socket, answer.text)) break;
  }
  _exit(0);
}

PlotAnswer askForPlot(int socket, const std::string& script) {
  PlotAnswer answer;
  if (!sendPlotText(socket, script) || !receiveAll(socket, &answer.plotted, sizeof answer.plotted))
    return {Plotted::Stopped};
  auto text = receivePlotText(socket, UINT64_MAX);
  if (!text) return {Plotted::Stopped};
  answer.text = std::move(*text);
  return answer;
}

void warn(Report& report, std::string id, std::string message, std::string hint) {
  report.add({.severity = Severity::Warning,
              .id = std::move(id),
              .message = std::move(message),
              .hint = std::move(hint)});
}

}  // namespace

PlotProcess::PlotProcess() {
  std::array<int, 2> sockets{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return;
  process_ = fork();
  if (process_ == 0) drawPlots(sockets[1]);
  close(sockets[1]);
  socket_ = sockets[0];
}

PlotProcess::~PlotProcess() {
  if (socket_ >= 0) close(socket_);
  if (process_ > 0) waitpid(process_, nullptr, 0);
}

Plotter PlotProcess::plotter(Report& report) const {
  return [this, &report](const PlotScript& script, const std::string& ending) -> std::optional<std::string> {
    PlotAnswer answer = askForPlot(socket_, (ending == ".svg" ? kSvg : kPng) + script.text);
    if (answer.plotted == Plotted::Drawn) return std::move(answer.text);
    if (answer.plotted == Plotted::Missing)
      warn(report, "gnuplot-missing", "the program gnuplot cannot be run: no plots are drawn",
           "install gnuplot-nox");
    else
      warn(report, "gnuplot-failed",
           fmt::format("gnuplot did not draw {}{}: {}", script.name, ending,
                       answer.plotted == Plotted::Failed ? answer.text : "it was stopped"),
           "");
    return std::nullopt;
  };
}

bool writeChart(const ChartData& chart, const StudyFiles& files, const PlotProcess& plots, Report& report) {
  Diagnostics diagnostics;
  const bool written = writeChart(chart, files, plots.plotter(report), diagnostics);
  report.add(diagnostics);
  return written;
}

}  // namespace orris
