#pragma once

#include <optional>
#include <vector>

#include "core/evidence/surveys/survey_grid.h"

namespace rubble {

inline constexpr double farFromDebris = 5.0;  ///< m, from where on a survey shows the ground alone

/// How well a survey and the ground below it are known: the noise of surveyed height above the ground in a cell.
struct SurveyNoise {
    enum class Source {
        Unknown,    ///< nobody stated it, and too little of the survey lies far from all debris; also of outlines
        Stated,     ///< of both surfaces
        Estimated,  ///< from the part that lies far from all simulated debris; holds both surfaces
        None,       ///< a map of another run has none
    };
    Source source = Source::Unknown;
    double deviation = 0.0;  ///< m, standard deviation; 0 where it is not known
    std::size_t cells = 0;   ///< far from all debris
    double offset = 0.0;     ///< m, median height above the ground there; NaN without such cells
    /// m, distance at which the noise of two cells there agrees by 1/e; NaN: not known. Longer than a cell: it hangs together.
    double correlation = 0.0;

    /// m: a height that is nearer to the ground may be noise (95 %; Lane et al. 2003, Wheaton et al. 2010).
    double detection() const { return 1.96 * deviation; }
};

/// @param surveyed   m above the ground
/// @param distances  in cells, to the nearest simulated debris
/// @param stated     m, standard deviations of the survey and of the ground; unset: not stated. One alone is taken as the least
SurveyNoise noiseOf(const CellGrid& surveyed, const std::vector<double>& distances, std::optional<double> ofSurvey,
                    std::optional<double> ofGround);

}  // namespace rubble
