#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "widgets/render/basics/colours.h"

/// Which of the scene's colours a thing takes; scene and legends ask here, so that they agree.
namespace rubble::render::colour_choice {

/// Stone greys that take turns.
constexpr std::uint32_t greys = 5;

/// Grey of the active structure of a component.
Rgb structure(const SceneColours& colours, std::uint32_t component);
/// Colour of a component.
Rgb category(const SceneColours& colours, std::size_t index);
/// How many of these differ.
std::size_t categories(const SceneColours& colours);
/// Those that no highlighted fragment could be taken for; at least one.
std::vector<std::uint32_t> unlikeFragments(const SceneColours& colours);
/// Colour of a cluster: neighbours in number look different.
Rgb clusterColour(const SceneColours& colours, ClusterId cluster);
/// Which of the steps an error [m] falls into: 0 up to the first bound.
std::size_t errorStep(const std::vector<double>& steps, double error);
/// Colour of an error.
Rgb errorColour(const SceneColours& colours, const std::vector<double>& steps, double error);
/// Colour of a value on a scale; clamped at both ends, and the first colour for a scale without length.
Rgb onRamp(const std::array<Rgb, 256>& ramp, double low, double high, double value);

}  // namespace rubble::render::colour_choice
