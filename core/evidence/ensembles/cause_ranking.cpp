#include "core/evidence/ensembles/cause_ranking.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/error.h"
#include "core/base/normal_distribution.h"
#include "core/base/unknown.h"

namespace rubble {

namespace {

/// Standard deviation within hypotheses of one piece of evidence; 0 if nothing scatters.
double pooledScatter(std::span<const Departures> hypotheses, std::size_t evidence) {
    double squares = 0.0;
    double freedom = 0.0;
    for (const Departures& departures : hypotheses) {
        const FigureSpread spread = spreadOf(departures[evidence]);
        if (spread.count > 1) {
            squares += spread.deviation * spread.deviation * (static_cast<double>(spread.count) - 1.0);
            freedom += static_cast<double>(spread.count) - 1.0;
        }
    }
    return freedom > 0.0 ? std::sqrt(squares / freedom) : 0.0;
}

/// What a departure of a piece of evidence is divided by: evidence without scatter keeps its own size.
double unitOf(double scatter) {
    constexpr double least = 1e-6;  // departures lie between 0 and 1
    return scatter > least ? scatter : 1.0;
}

std::vector<double> scoresOf(const Departures& departures, const std::vector<double>& scatter) {
    const std::size_t members = departures.empty() ? 0 : departures.front().size();
    std::vector<double> scores(members, unknown);
    for (std::size_t m = 0; m < members; ++m) {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t e = 0; e < departures.size(); ++e) {
            if (std::isfinite(departures[e][m])) {
                sum += departures[e][m] / unitOf(scatter[e]);
                count += 1.0;
            }
        }
        scores[m] = count > 0.0 ? sum / count : unknown;
    }
    return scores;
}

/// Variance of the share under method 5 of Newcombe, were the share true.
double varianceOf(double share, double first, double second) {
    const double mean = 0.5 * (first + second) - 1.0;
    return share * (1.0 - share) * (1.0 + mean * ((1.0 - share) / (2.0 - share) + share / (1.0 + share))) / (first * second);
}

/// Where the distance to the observed share is as many deviations as the interval allows, searched between the two.
double endOf(double observed, double end, double first, double second, double z) {
    double inside = observed;
    double outside = end;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (inside + outside);
        const bool within = std::abs(middle - observed) <= z * std::sqrt(varianceOf(middle, first, second));
        (within ? inside : outside) = middle;
    }
    return 0.5 * (inside + outside);
}

/// Of each interval, so that those of all hypotheses against the closest hold together.
double quantileFor(std::size_t hypotheses, double confidence) {
    const double comparisons = std::max<double>(1.0, static_cast<double>(hypotheses) - 1.0);
    return normalPlaceAbove(0.5 * (1.0 - confidence) / comparisons);
}

}  // namespace

Superiority superiorityOf(std::span<const double> first, std::span<const double> second, double z) {
    double wins = 0.0;
    double a = 0.0;
    double b = 0.0;
    for (const double x : first) {
        a += std::isfinite(x) ? 1.0 : 0.0;
        for (const double y : second) {
            if (std::isfinite(x) && std::isfinite(y)) {
                wins += x < y ? 1.0 : x == y ? 0.5 : 0.0;
            }
        }
    }
    for (const double y : second) {
        b += std::isfinite(y) ? 1.0 : 0.0;
    }
    if (a == 0.0 || b == 0.0) {
        return {};
    }
    Superiority superiority;
    superiority.share = wins / (a * b);
    superiority.low = endOf(superiority.share, 0.0, a, b, z);
    superiority.high = endOf(superiority.share, 1.0, a, b, z);
    return superiority;
}

bool CauseRanking::decided() const {
    return causes.size() > 1 && std::all_of(causes.begin() + 1, causes.end(), [](const RankedCause& cause) { return cause.apart; });
}

std::size_t membersToTell(std::size_t hypotheses, std::size_t leftOut, double confidence) {
    constexpr std::size_t most = 1000;
    const double z = quantileFor(hypotheses, confidence);
    for (std::size_t count = leftOut + 1; count < most; ++count) {
        const std::vector<double> closer(count - leftOut, 0.0);
        const std::vector<double> farther(count, 1.0);
        if (superiorityOf(closer, farther, z).low > tellingShare) {
            return count;
        }
    }
    return most;
}

CauseRanking rankCauses(std::span<const Departures> hypotheses, double confidence) {
    CauseRanking ranking;
    ranking.confidence = confidence;
    const std::size_t evidence = hypotheses.empty() ? 0 : hypotheses.front().size();
    for (std::size_t e = 0; e < evidence; ++e) {
        ranking.scatter.push_back(pooledScatter(hypotheses, e));
    }
    for (std::size_t h = 0; h < hypotheses.size(); ++h) {
        assert(hypotheses[h].size() == evidence);
        RankedCause cause;
        cause.hypothesis = h;
        cause.scores = scoresOf(hypotheses[h], ranking.scatter);
        cause.score = spreadOf(cause.scores);
        for (const std::vector<double>& departures : hypotheses[h]) {
            cause.departures.push_back(spreadOf(departures));
        }
        ranking.causes.push_back(std::move(cause));
    }
    std::erase_if(ranking.causes, [](const RankedCause& cause) { return cause.score.count == 0; });
    if (ranking.causes.empty()) {
        throw UsageError({"causes.nothing", "No hypothesis has a member that can be held against the evidence.", {}},
                         {"causes.nothing.remedy", "Simulate their ensembles, and give evidence.", {}});
    }
    // By the middle, which one member that went astray does not move.
    std::stable_sort(ranking.causes.begin(), ranking.causes.end(),
                     [](const RankedCause& a, const RankedCause& b) { return a.score.middle < b.score.middle; });
    const double z = quantileFor(ranking.causes.size(), confidence);
    const RankedCause& best = ranking.causes.front();
    for (RankedCause& cause : ranking.causes) {
        const bool self = &cause == &best;
        cause.bestOver = self ? Superiority{} : superiorityOf(best.scores, cause.scores, z);
        for (std::size_t e = 0; e < evidence; ++e) {
            cause.bestOverEvidence.push_back(
                self ? Superiority{} : superiorityOf(hypotheses[best.hypothesis][e], hypotheses[cause.hypothesis][e], z));
        }
        cause.apart = !self && cause.bestOver.low > tellingShare;
    }
    return ranking;
}

}  // namespace rubble
