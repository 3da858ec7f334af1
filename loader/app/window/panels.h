// What is drawn over the picture: help, options, scene, passes, problems. Each panel shows what it is
// given and leaves what the user asks for in the requests; none changes anything itself.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/input/shown_buffer.h"
#include "app/view/pack/live_pack.h"
#include "app/window/interface.h"
#include <orris/render/inspect/pixel_probe.h>

namespace orris {

class BufferInspector;
class SetComparison;
struct ProgramText;

/// Which panels are open and where the user is in them.
struct PanelState {
  bool help = false, options = false, scene = false, passes = false, buffers = false,
       compare = false, program = false;
  bool problems = true;              ///< shown while the last load failed
  std::vector<std::string> screens;  ///< from the main screen to the one shown
  std::string search;
  int programLine = 0;       ///< of the final text, from 1; 0: none
  bool programMoved = false;  ///< the line must come into view
  std::string programWords;   ///< looked for
  int wordKind = 0;                  ///< how the words of a bufferObject are written
  std::map<std::string, int> dragged;  ///< sliders being dragged: index of the value under the mouse
};

/// The steps of a frame, each name once: geometry drawn in several layers is counted.
std::vector<std::string> stepLabels(const Schedule& schedule);

/// Times of the last frames by label of the step, for a median.
struct StepHistory {
  static constexpr std::size_t kFrames = 32;
  std::map<std::string, std::deque<StepTime>> steps;
  void add(const Schedule& schedule, const std::vector<StepTime>& times);
  /// Milliseconds of each clock; 0 before the first frame.
  struct Median {
    double passed = 0, processors = 0;
    std::optional<double> card;
  };
  Median median(const std::string& step) const;
};

/// What the panels show.
struct PanelFacts {
  LivePack& pack;
  RenderSession& session;  ///< what is drawn: the pack's, or that of the host's own programs
  bool packOn = true, paused = false;
  bool exact = false;  ///< what is asked for is known and done before the next frame
  const std::vector<std::string>& worldsBeside;  ///< paths of those in the folder of the world that is drawn
  const StepHistory& times;
  const std::optional<std::pair<int, int>>& pixel;  ///< that is probed
  const std::vector<ProbeValue>& probe;
  bool checksFinite = false;
  const Diagnostics& notFinite;  ///< of the first frame that wrote NaN or Inf since that began
  const BufferInspector* inspector = nullptr;  ///< nullptr: no buffer is shown
  const ProgramText* program = nullptr;        ///< nullptr: none is shown
  SetComparison* comparison = nullptr;         ///< nullptr: nothing is compared; how it is shown is its own
};

/// What the user asked for in this frame.
struct PanelRequests {
  OptionValues set;  ///< "" for the default
  OptionValues drag;  ///< live options for the next frame, not to be saved
  std::optional<OptionValues> values;  ///< all at once
  bool resetAll = false;
  std::string profile;
  std::optional<int> time;
  std::optional<float> rain, thunder;
  std::string camera, world;
  std::optional<bool> pause, packOn;
  bool singleFrame = false;
  bool dropPixel = false;
  std::optional<bool> checkFinite;
  std::optional<ShownBuffer> show;  ///< opens the buffers
  std::string program;              ///< text to show, "composite.fsh"
  std::optional<SourceLocation> edit;  ///< place to open in the editor
};

void drawHelp(Interface& interface, PanelState& state);
void drawOptions(Interface& interface, PanelState& state, const PanelFacts& facts,
                 PanelRequests& requests);
void drawScene(Interface& interface, PanelState& state, const PanelFacts& facts,
               PanelRequests& requests);
void drawPasses(Interface& interface, PanelState& state, const PanelFacts& facts,
                PanelRequests& requests);
void drawBuffers(Interface& interface, PanelState& state, const PanelFacts& facts,
                 PanelRequests& requests);
void drawProgram(Interface& interface, PanelState& state, const PanelFacts& facts,
                 PanelRequests& requests);
void drawCompare(Interface& interface, PanelState& state, const PanelFacts& facts,
                 PanelRequests& requests);
void drawProblems(Interface& interface, PanelState& state, const PanelFacts& facts);

}  // namespace orris
