#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "widgets/render/basics/colours.h"

namespace rubble::render {

/// Points of a cloud as they are drawn, the coarse ones first, and what their colours say.
struct SitePoints {
    /// Points that came together.
    struct Patch {
        std::vector<float> places;      ///< m, x y z of each
        std::vector<std::uint8_t> rgb;  ///< of each
    };
    /// What there is behind the colours.
    enum class Scale : std::uint8_t { Own, Intensity, Height, Class, Distance };

    std::vector<std::shared_ptr<const Patch>> patches;
    std::string name;         ///< of the file
    std::uint64_t shown = 0;  ///< points of the patches
    std::uint64_t all = 0;    ///< points of the cloud, or places where distances were measured
    Scale scale = Scale::Own;
    double low = 0.0;                          ///< of heights [m], intensities or distances [m]
    double high = 0.0;                         ///< the same
    std::vector<std::pair<int, Rgb>> classes;  ///< that were met, with their colours
    double time = 0.0;                         ///< s, on the file's clock: distances are to the site as it is then
    double detection = 0.0;                    ///< m, level of detection at 95 % in the median; NaN: not known
    bool registered = false;                   ///< it holds the error of the registration
    std::uint64_t significant = 0;             ///< distances beyond their level of detection
    std::uint64_t unknown = 0;                 ///< distances whose level of detection is not known
};

}  // namespace rubble::render
