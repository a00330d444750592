#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// A number with the interval that holds it in 95 of 100 resamplings.
struct ConfidenceInterval {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// Mean and standard deviation of what is finite.
struct MeanAndScatter {
    std::size_t count = 0;
    double mean = 0.0;     ///< NaN without values
    double scatter = 0.0;  ///< standard deviation; NaN with fewer than two
};
MeanAndScatter meanAndScatter(const std::vector<double>& values);
/// Linear between order statistics; NaN without values. @param share  0 to 1
double quantileOf(std::vector<double> values, double share);

/// Area between two cumulative curves: how far one has to be moved, on average, to become the other. In the unit of the values; NaN
/// where one has none.
double areaBetween(std::vector<double> a, std::vector<double> b);

/// One quantity as it was measured and as it was simulated, body by body. What is not a number was lost and counts nowhere else.
struct PairedValues {
    std::vector<double> measured;                ///< [bodies]
    std::vector<std::vector<double>> simulated;  ///< [bodies][repeats]
};

/// What was simulated held against what was measured, in the terms of ASME V&V 20: S the simulation, D the data, E = S - D the
/// comparison error. Its interval is that of the bootstrap over bodies and repeats, so it holds the scatter of both.
struct SampleComparison {
    MeanAndScatter measured;
    MeanAndScatter simulated;
    std::int64_t lost = 0;            ///< simulated values that are no numbers
    ConfidenceInterval error;         ///< of the means
    double uncertainty = 0.0;         ///< standard deviation of that error over the resamplings
    ConfidenceInterval scatterRatio;  ///< scatter simulated over scatter measured
    double area = 0.0;                ///< between the cumulative curves
    /// What the area would be, in 95 of 100 resamplings at most, if both were of one distribution: less shows nothing.
    double areaByChance = 0.0;
};

/// @param resamplings  of the bootstrap; the same seed gives the same interval
SampleComparison compareSamples(const PairedValues& values, int resamplings = 2000, std::uint64_t seed = 1);

/// A number of one sample with its interval by bootstrap over bodies and repeats.
enum class Statistic : std::uint8_t { Mean, Median, Ninetieth };
ConfidenceInterval intervalOf(const std::vector<std::vector<double>>& simulated, Statistic statistic, int resamplings = 2000,
                              std::uint64_t seed = 1);

}  // namespace rubble
