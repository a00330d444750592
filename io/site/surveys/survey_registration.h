#pragma once

#include <optional>
#include <string>

#include "core/evidence/surveys/pair_fit.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// A survey that is to be placed by a table of pairs.
struct PairsRequest {
    std::string survey;  ///< path
    std::string
        table;  ///< as readPlacePairs() takes it; in numbers of the survey: of a cloud its file's, else m in the case's system
    CloudRequest read;  ///< how a cloud is read
    Frame frame;        ///< of the case
    Site site;
    Aabb around;  ///< m, local, of the structure at rest: what the error holds for
    /// m, standard deviation of control points whose accuracy the table does not state; unset: not stated.
    std::optional<double> control = std::nullopt;
};

/// Brings both places of each pair to the case and fits. Findings are those of the fit and of the cloud.
/// Throws as readPlacePairs(), fitPairs() and CloudPlace.
PairFit placeByPairs(const PairsRequest& request);

}  // namespace rubble::io
