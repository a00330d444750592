#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/evidence/ensembles/cause_comparison.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// How often causes were named in blind trials.
struct BlindShare {
    std::int64_t trials = 0;
    std::int64_t right = 0;  ///< named, and rightly
    std::int64_t wrong = 0;  ///< named, and wrongly; the rest cannot be told apart

    double share() const { return trials > 0 ? static_cast<double>(right) / static_cast<double>(trials) : 0.0; }
    /// Score interval of the share after Wilson (1927), 95 %.
    double low() const;
    double high() const;
};

/// Evidence that is not at hand, and how far it would tell causes apart.
struct FurtherEvidence {
    EvidenceKind kind = EvidenceKind::Heights;
    std::optional<Eigen::AlignedBox2d> part;  ///< m, of the site that is surveyed or that debris reaches; unset: all of it
    std::optional<Eigen::Vector2d> from;      ///< m, where a photograph is taken, 1.7 m above the ground
    double accuracy = 0.0;                    ///< s, plus or minus, of a time
    BlindShare named;                         ///< with it and what is at hand

    /// "heights of all debris", "photograph at rest from x = 12 m, y = -40 m".
    Message words() const;
};

/// Which evidence would tell causes apart.
struct TellingEvidence {
    std::vector<std::size_t> causes;      ///< hypotheses that are to be told apart
    BlindShare atHand;                    ///< with the surveys at hand alone; without any no trial
    std::vector<FurtherEvidence> ranked;  ///< that which names the cause rightly most often first
};

/// Each member of each cause in turn is what happened. The evidence at hand, looked at as it was, and one further piece are taken
/// from it without any error; then the causes are ranked as compareCauses() does. Pieces are outline and heights of all debris and
/// of parts of the site, the time at which debris first reached a part, to half a second, and the silhouette of the debris from
/// eight places around it. What is told is what a perfect survey could tell at best: a silhouette knows neither standing structure
/// nor ground before it. The first of many is flattered by chance. Photographs at hand take no part, since no outline can be drawn
/// on what a member would have shown.
/// @param causes  hypotheses to be told apart, at least two
/// @param ground  on which the debris lies
/// Throws as compareCauses(), UsageError for fewer than two causes, Cancelled.
TellingEvidence tellingEvidence(std::span<const Hypothesis> hypotheses, const CauseEvidence& atHand,
                                std::span<const std::size_t> causes, const SiteSurface& ground, const Execution& execution);

/// The hypotheses of a comparison that its evidence cannot tell from the closest one, that one among them; all of them where all
/// are told apart.
std::vector<std::size_t> notToldApart(const CauseComparison& made);

}  // namespace rubble
