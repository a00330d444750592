#pragma once

#include <vector>

namespace rubble {

/// One observation: where it was made, and what was seen there.
struct FitSample {
    std::vector<double> at;  ///< the same number of coordinates for all samples
    double value = 0.0;
};

/// A value that lies between low and high with the chance that was asked for.
struct FitInterval {
    double low = 0.0;
    double value = 0.0;  ///< in the middle
    double high = 0.0;
};

/// Predicts between and a little beyond a few noisy samples, with an interval: a straight line in every coordinate plus a smooth
/// departure from it plus noise (universal kriging; Cressie 1993, section 3.4), with flat priors on the line and a weak one on the
/// noise. How far and how strongly the departure reaches is not settled but averaged over by how well it explains the samples, so
/// that few samples give wide intervals (Rasmussen & Williams 2006, sections 2.7 and 5.4).
class IntervalFit {
public:
    /// @param samples  at least 3, of finite numbers; coordinates in which they do not differ play no part
    /// @param scatter  what scatter is likely before any sample is seen; counts like two samples
    IntervalFit(std::vector<FitSample> samples, double scatter);

    /// @param chance  that a further sample at this place lies in the interval, in (0, 1)
    FitInterval predict(const std::vector<double>& at, double chance) const;

private:
    struct Model;                               ///< one reach and strength of the departure
    std::vector<std::vector<double>> m_scaled;  ///< coordinates of the samples, of unit spread
    std::vector<double> m_values;
    std::vector<double> m_middle;
    std::vector<double> m_spread;  ///< 0: this coordinate does not vary
    double m_scatter;
    std::vector<double> scaled(const std::vector<double>& at) const;
};

/// Chance that a number of Student's distribution is below t. @param degrees  of freedom, above 0
double studentBelow(double t, double degrees);
/// The number of Student's distribution that has as much below it as another has of the normal one, within 0.2 % from three degrees
/// of freedom on (Abramowitz & Stegun 26.7.5). @param degrees  of freedom, 1 or more
double studentQuantile(double normal, double degrees);

}  // namespace rubble
