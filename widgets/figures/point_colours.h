#pragma once

#include "widgets/render/basics/site_points.h"

namespace rubble::figures {

/// Colour of a share of a scale, [0, 1], from dark to light.
render::Rgb scaleColour(render::SitePoints::Scale scale, double share);
/// Colour of a class of LAS.
render::Rgb classColour(int kind);
/// Colour of a distance to the simulated site; red where that lies above the point, blue below.
/// @param share  of the greatest, [-1, 1]
render::Rgb distanceColour(double share);
/// Of distances that are not significant, and of those that cannot be judged.
inline constexpr render::Rgb withinDetection{160, 160, 160};
inline constexpr render::Rgb detectionUnknown{214, 178, 92};

}  // namespace rubble::figures
