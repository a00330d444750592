#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/evidence/ensembles/ensemble.h"

namespace rubble {

/// How often a member of one hypothesis is closer to the evidence than one of another, over all pairs of members; equal ones count
/// by half. 0.5: neither is closer.
struct Superiority {
    double share = 0.5;
    double low = 0.0;  ///< ends of its interval of confidence
    double high = 1.0;
};

/// Probability of superiority of the first list over the second, less being better, with a score interval after Newcombe (2006,
/// part 2, method 5), which holds for few members and at the ends.
/// @param z  normal quantile of the interval: 1.96 for 95 %
Superiority superiorityOf(std::span<const double> first, std::span<const double> second, double z);

/// Departures of every member of a hypothesis from each piece of evidence: [evidence][members].
/// 0: the same.
/// 1: nothing in common.
/// NaN: not known.
using Departures = std::vector<std::vector<double>>;

/// One hypothesis among others.
struct RankedCause {
    std::size_t hypothesis = 0;
    std::vector<double> scores;                 ///< [members] mean departure in units of its scatter; less is closer
    FigureSpread score;                         ///< of them
    std::vector<FigureSpread> departures;       ///< [evidence]
    Superiority bestOver;                       ///< of the closest hypothesis over this one
    std::vector<Superiority> bestOverEvidence;  ///< the same by each piece of evidence alone [evidence]
    bool apart = false;                         ///< the evidence tells it from the closest one
};

/// Hypotheses in the order of how close they are to the evidence.
struct CauseRanking {
    std::vector<RankedCause> causes;  ///< the closest first; it is never `apart` from itself
    std::vector<double> scatter;      ///< [evidence] standard deviation of the departures within hypotheses, pooled
    double confidence = 0.95;         ///< of all intervals together (Bonferroni)

    /// All others are told from the closest one.
    bool decided() const;
};

/// The least share of pairs of members for which the interval must speak before two hypotheses are told apart. What is observed is
/// one collapse: with many members a difference that means nothing would pass a test against one half.
inline constexpr double tellingShare = 0.7;

/// Members of each of so many hypotheses below which none is told from the others, however clear the evidence is.
/// @param leftOut  members of the closest one that do not count
std::size_t membersToTell(std::size_t hypotheses, std::size_t leftOut = 0, double confidence = 0.95);

/// Ranks hypotheses. A piece of evidence weighs by the inverse of its scatter within hypotheses: what birth times and friction
/// change as much as causes do says little. A hypothesis is told from the closest one if the lower end of the interval of
/// superiority lies above tellingShare, intervals of all comparisons holding together with the confidence.
/// @param hypotheses  at least one, all with the same evidence
/// Throws UsageError without a hypothesis or a member that is known.
CauseRanking rankCauses(std::span<const Departures> hypotheses, double confidence = 0.95);

}  // namespace rubble
