#pragma once

#include <limits>
#include <memory>

#include "widgets/render/basics/scene_data.h"

namespace rubble::scenes {

/// A run without an engine: every cluster flies ballistically from its hand-over and turns at 1 rad/s about y, until its centre is
/// at the ground. What views need, at no cost.
/// @param until     s, last frame
/// @param complete  whether the run says that it has finished
render::SceneData ballisticRun(std::shared_ptr<const FeResult> fe, double until, bool complete = true,
                               const FragmentSettings& settings = {});

/// Components, fragments and clusters (boxes of 2 m) of an FE result, without a trajectory.
render::SceneData withoutRun(std::shared_ptr<const FeResult> fe, const FragmentSettings& settings = {});

}  // namespace rubble::scenes
