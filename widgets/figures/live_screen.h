#pragma once

#include <memory>
#include <string>

#include "core/analysis/accuracy/live_cost.h"

namespace rubble::figures {

/// The screen that live FPS are measured on: both views of a run, 1280 x 800 pixels off screen, drawn as the workbench draws them.
/// @param renderer  what drew, in words, once something was drawn; outlives the screen
/// Throws WorldError (remedy: an X display, or Xvfb) when no display answers.
std::unique_ptr<LiveScreen> liveScreen(const RunDescription& run, std::shared_ptr<const TrajectoryReader> trajectory,
                                       std::string& renderer);

}  // namespace rubble::figures
