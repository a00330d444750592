#include "core/validation/comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/sequence.h"
#include "core/base/unknown.h"

namespace rubble {

namespace {

constexpr double lowShare = 0.025;
constexpr double highShare = 0.975;

void keepFinite(std::vector<double>& values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
}

std::vector<double> pooled(const std::vector<std::vector<double>>& simulated) {
    std::vector<double> all;
    for (const std::vector<double>& repeats : simulated) {
        all.insert(all.end(), repeats.begin(), repeats.end());
    }
    return all;
}

/// Bodies drawn with replacement; of each one of its repeats.
struct Resample {
    std::vector<double> measured;
    std::vector<double> simulated;
};
Resample resample(const PairedValues& values, Sequence& random) {
    Resample drawn;
    for (std::size_t i = 0; i < values.simulated.size(); ++i) {
        const std::size_t body = random.below(values.simulated.size());
        const std::vector<double>& repeats = values.simulated[body];
        if (!values.measured.empty()) {
            drawn.measured.push_back(values.measured[body]);
        }
        if (!repeats.empty()) {
            drawn.simulated.push_back(repeats[random.below(repeats.size())]);
        }
    }
    return drawn;
}

ConfidenceInterval intervalIn(double value, const std::vector<double>& drawn) {
    return {value, quantileOf(drawn, lowShare), quantileOf(drawn, highShare)};
}

/// Both samples drawn from what was measured and simulated alike: the area that chance alone makes.
double chanceArea(const PairedValues& values, const std::vector<double>& simulated, int resamplings, Sequence& random) {
    std::vector<double> together = values.measured;
    together.insert(together.end(), simulated.begin(), simulated.end());
    keepFinite(together);
    if (together.empty()) {
        return unknown;
    }
    const auto drawn = [&](std::size_t count) {
        std::vector<double> sample;
        for (std::size_t i = 0; i < count; ++i) {
            sample.push_back(together[random.below(together.size())]);
        }
        return sample;
    };
    std::vector<double> areas;
    // Repeats of one body are no new bodies: each side has as many as were measured.
    for (int r = 0; r < resamplings / 4; ++r) {
        areas.push_back(areaBetween(drawn(values.measured.size()), drawn(values.measured.size())));
    }
    return quantileOf(areas, 0.95);
}

}  // namespace

MeanAndScatter meanAndScatter(const std::vector<double>& values) {
    MeanAndScatter result{0, unknown, unknown};
    double sum = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) {
            sum += value;
            ++result.count;
        }
    }
    if (result.count == 0) {
        return result;
    }
    result.mean = sum / static_cast<double>(result.count);
    double squares = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) {
            squares += (value - result.mean) * (value - result.mean);
        }
    }
    if (result.count > 1) {
        result.scatter = std::sqrt(squares / static_cast<double>(result.count - 1));
    }
    return result;
}

double quantileOf(std::vector<double> values, double share) {
    keepFinite(values);
    if (values.empty()) {
        return unknown;
    }
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

double areaBetween(std::vector<double> a, std::vector<double> b) {
    keepFinite(a);
    keepFinite(b);
    if (a.empty() || b.empty()) {
        return unknown;
    }
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    double area = 0.0;
    double before = std::min(a.front(), b.front());
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        const bool takeA = j == b.size() || (i < a.size() && a[i] <= b[j]);
        const double now = takeA ? a[i] : b[j];
        const double shareA = static_cast<double>(i) / static_cast<double>(a.size());
        const double shareB = static_cast<double>(j) / static_cast<double>(b.size());
        area += std::abs(shareA - shareB) * (now - before);
        before = now;
        i += takeA;
        j += !takeA;
    }
    return area;
}

SampleComparison compareSamples(const PairedValues& values, int resamplings, std::uint64_t seed) {
    SampleComparison comparison;
    const std::vector<double> simulated = pooled(values.simulated);
    comparison.measured = meanAndScatter(values.measured);
    comparison.simulated = meanAndScatter(simulated);
    comparison.lost = static_cast<std::int64_t>(simulated.size() - comparison.simulated.count);
    comparison.area = areaBetween(values.measured, simulated);
    Sequence random(seed);
    std::vector<double> errors, ratios;
    for (int r = 0; r < resamplings; ++r) {
        const Resample drawn = resample(values, random);
        const MeanAndScatter d = meanAndScatter(drawn.measured), s = meanAndScatter(drawn.simulated);
        errors.push_back(s.mean - d.mean);
        ratios.push_back(s.scatter / d.scatter);
    }
    comparison.error = intervalIn(comparison.simulated.mean - comparison.measured.mean, errors);
    comparison.uncertainty = meanAndScatter(errors).scatter;
    comparison.scatterRatio = intervalIn(comparison.simulated.scatter / comparison.measured.scatter, ratios);
    comparison.areaByChance = chanceArea(values, simulated, resamplings, random);
    return comparison;
}

ConfidenceInterval intervalOf(const std::vector<std::vector<double>>& simulated, Statistic statistic, int resamplings,
                              std::uint64_t seed) {
    const auto of = [statistic](const std::vector<double>& values) {
        if (statistic == Statistic::Mean) {
            return meanAndScatter(values).mean;
        }
        return quantileOf(values, statistic == Statistic::Median ? 0.5 : 0.9);
    };
    Sequence random(seed);
    std::vector<double> drawn;
    for (int r = 0; r < resamplings; ++r) {
        drawn.push_back(of(resample({{}, simulated}, random).simulated));
    }
    return intervalIn(of(pooled(simulated)), drawn);
}

}  // namespace rubble
