#include "widgets/render/basics/colour_choice.h"

#include <algorithm>
#include <cmath>

namespace rubble::render::colour_choice {
namespace {

Rgb shaded(const Rgb& c, double factor) {
    const auto channel = [factor](std::uint8_t v) {
        const double scaled = factor <= 1.0 ? v * factor : 255.0 - (255.0 - v) * (2.0 - factor);
        return static_cast<std::uint8_t>(std::lround(std::clamp(scaled, 0.0, 255.0)));
    };
    return {channel(c.r), channel(c.g), channel(c.b)};
}

/// A second and third round through the hues is told apart by lightness.
constexpr std::array<double, 3> rounds{1.0, 0.68, 1.38};

}  // namespace

Rgb structure(const SceneColours& colours, std::uint32_t component) {
    return colours.structure.empty() ? Rgb{160, 160, 160} : colours.structure[component % greys % colours.structure.size()];
}

Rgb category(const SceneColours& colours, std::size_t index) {
    if (colours.categories.empty()) {
        return colours.fragment;
    }
    return shaded(colours.categories[index % colours.categories.size()], rounds[index / colours.categories.size() % rounds.size()]);
}

std::size_t categories(const SceneColours& colours) {
    return std::max<std::size_t>(1, rounds.size() * colours.categories.size());
}

std::vector<std::uint32_t> unlikeFragments(const SceneColours& colours) {
    std::vector<std::uint32_t> left;
    for (std::uint32_t c = 0; c < categories(colours); ++c) {
        if (!colours.categories.empty() && !(colours.categories[c % colours.categories.size()] == colours.fragment)) {
            left.push_back(c);
        }
    }
    return left.empty() ? std::vector<std::uint32_t>{0} : left;
}

Rgb clusterColour(const SceneColours& colours, ClusterId cluster) {
    return category(colours, at(cluster) * 5 % categories(colours));
}

std::size_t errorStep(const std::vector<double>& steps, double error) {
    return static_cast<std::size_t>(std::lower_bound(steps.begin(), steps.end(), error) - steps.begin());
}

Rgb errorColour(const SceneColours& colours, const std::vector<double>& steps, double error) {
    return onRamp(colours.errorRamp, 0.0, static_cast<double>(steps.size()), static_cast<double>(errorStep(steps, error)));
}

Rgb onRamp(const std::array<Rgb, 256>& ramp, double low, double high, double value) {
    const double share = high > low ? (value - low) / (high - low) : 0.0;
    return ramp[static_cast<std::size_t>(std::lround(255.0 * std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0)))];
}

}  // namespace rubble::render::colour_choice
