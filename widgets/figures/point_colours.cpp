#include "widgets/figures/point_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble::figures {

using render::Rgb;
using render::SitePoints;

namespace {

/// Between the colours of a row, evenly spaced.
template <std::size_t Size>
Rgb between(const std::array<Rgb, Size>& row, double share) {
    const double at = std::clamp(share, 0.0, 1.0) * (Size - 1);
    const auto i = std::min(static_cast<std::size_t>(at), Size - 2);
    const double rest = at - static_cast<double>(i);
    const auto mix = [&](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(std::lround(a + rest * (b - a))); };
    return {mix(row[i].r, row[i + 1].r), mix(row[i].g, row[i + 1].g), mix(row[i].b, row[i + 1].b)};
}

/// Viridis (Smith & van der Walt 2015) at five places.
constexpr std::array<Rgb, 5> heights{{{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
constexpr std::array<Rgb, 2> intensities{{{30, 30, 30}, {235, 235, 235}}};

}  // namespace

Rgb scaleColour(SitePoints::Scale scale, double share) {
    return scale == SitePoints::Scale::Intensity ? between(intensities, share) : between(heights, share);
}

Rgb classColour(int kind) {
    struct Known {
        int kind;
        Rgb colour;
    };
    constexpr std::array<Known, 12> known{{{0, {150, 150, 150}},
                                           {1, {170, 170, 170}},
                                           {2, {166, 118, 74}},
                                           {3, {140, 190, 110}},
                                           {4, {96, 160, 80}},
                                           {5, {50, 120, 60}},
                                           {6, {200, 90, 60}},
                                           {9, {70, 120, 200}},
                                           {11, {110, 110, 120}},
                                           {13, {220, 190, 60}},
                                           {14, {220, 190, 60}},
                                           {17, {150, 100, 170}}}};
    for (const Known& row : known) {
        if (row.kind == kind) {
            return row.colour;
        }
    }
    constexpr std::array<Rgb, 5> others{{{90, 170, 180}, {190, 110, 160}, {130, 130, 60}, {230, 140, 90}, {110, 140, 220}}};
    return others[static_cast<std::size_t>(kind) % others.size()];
}

Rgb distanceColour(double share) {
    const auto pale = static_cast<std::uint8_t>(std::lround(200.0 * (1.0 - std::min(1.0, std::abs(share)))));
    return share > 0.0 ? Rgb{220, pale, pale} : Rgb{pale, pale, 220};
}

}  // namespace rubble::figures
