#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scenario/registration.h"
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
    /// The file that they came from as it was then, and where the case puts it.
    struct Source {
        std::string path;                    ///< absolute; empty: no file
        std::uint64_t bytes = 0;             ///< of the file
        std::int64_t time = 0;               ///< ns, of its last change
        std::optional<Registration> placed;  ///< unset: it lies by its coordinates alone
        std::uint64_t far = 0;               ///< points far from all others, which are not drawn
        double finest = 0.0;                 ///< m, width of the cells of which the finest level drawn has one point each
        bool whole = true;                   ///< no level was left out to keep their number
    };

    std::vector<std::shared_ptr<const Patch>> patches;
    Source source;
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
