// What one setting does on one scene: accuracy, noise, cost, lag and memory of the same setting in one row.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <orris/chart/measure/run_bias.h>
#include <orris/chart/measure/statistics.h>

namespace orris {

struct SceneRow {
  std::string scene, camera, setting;
  std::string chosen;  ///< for options that are AUTO; "" where none is
  int time = 0;        ///< ticks
  int runs = 0, warmUp = 0, frames = 0;
  double referenceNoise = 0;  ///< noiseFloor() of the reference
  RunBias bias;
  std::array<double, kBiasChannels> noise{};      ///< of one frame: standard deviation, rms over the pixels, relative
  std::array<double, kBiasChannels> noiseMean{};  ///< of the mean of `frames` frames, from run to run
  PairedCost cost;     ///< beside the first setting on this scene
  PairedCost editing;  ///< the same while a block changes in every frame
  PairedCost moving;   ///< the same while the camera walks in a circle of one block
  double milliseconds = 0;  ///< a frame
  /// Frames after a lamp was placed until eight frames on average are within a tenth of the change from where the
  /// picture's brightness ends; -1: a lamp there changes less than its noise, or it does not settle in kLagFrames.
  int lag = -1;
  double megabytes = 0;  ///< of the buffers that the renderer lists, both sides of render targets
};

/// Frames that are watched after a lamp was placed.
inline constexpr int kLagFrames = 96;

/// From the mean brightness of frames; those before `changed` precede the lamp. See SceneRow::lag.
int lagOf(const std::vector<double>& brightness, std::size_t changed);

/// Red, green or blue with the largest upper end of the rms bias.
const ChannelBias& worstChannel(const SceneRow& row);

/// A row a scene and setting; rms biases are signed roots: below 0 means that noise explains more than all.
std::string sceneRowsCsv(const std::vector<SceneRow>& rows);

/// One line a setting: median and worst over the scenes, share of the scenes with the upper end of the rms bias at
/// most .03 and .05, and * for settings that no other beats in both median bias and median cost.
std::string sceneSummary(const std::vector<SceneRow>& rows);

}  // namespace orris
