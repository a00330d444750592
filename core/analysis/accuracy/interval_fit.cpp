#include "core/analysis/accuracy/interval_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace rubble {

namespace {

using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

/// What the prior on the noise counts like, in samples.
constexpr double priorSamples = 2.0;
/// Variance of the departure over that of the noise.
constexpr std::array<double, 6> strengths{0.0, 0.3, 1.0, 4.0, 16.0, 64.0};
/// Reach of the departure, in spreads of the samples.
constexpr std::array<double, 3> reaches{0.4, 1.0, 2.5};

/// Incomplete beta function by its continued fraction (Abramowitz & Stegun 26.5.8), evaluated from the front (Lentz 1976).
double betaFraction(double a, double b, double x) {
    constexpr double tiny = 1e-300;
    double c = 1.0;
    double d = 1.0 / std::max(tiny, 1.0 - (a + b) * x / (a + 1.0));
    double fraction = d;
    for (int m = 1; m < 300; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        double change = 1.0;
        for (const double term : {even, odd}) {
            d = 1.0 + term * d;
            c = 1.0 + term / c;
            d = 1.0 / (std::abs(d) < tiny ? tiny : d);
            if (std::abs(c) < tiny) {
                c = tiny;
            }
            change = c * d;
            fraction *= change;
        }
        if (std::abs(change - 1.0) < 1e-14) {
            break;
        }
    }
    return fraction;
}

double incompleteBeta(double a, double b, double x) {
    if (x <= 0.0 || x >= 1.0) {
        return x <= 0.0 ? 0.0 : 1.0;
    }
    const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    return x < (a + 1.0) / (a + b + 2.0) ? front * betaFraction(a, b, x) / a : 1.0 - front * betaFraction(b, a, 1.0 - x) / b;
}

double departureAt(const std::vector<double>& a, const std::vector<double>& b, double reach) {
    double square = 0.0;
    for (std::size_t d = 0; d < a.size(); ++d) {
        square += (a[d] - b[d]) * (a[d] - b[d]);
    }
    return std::exp(-0.5 * square / (reach * reach));
}

/// What one model says of one place.
struct Said {
    double weight = 0.0;  ///< logarithm of how well the model explains the samples
    double middle = 0.0;
    double scale = 0.0;
    double degrees = 0.0;
};

double mixtureBelow(const std::vector<Said>& all, double value) {
    double below = 0.0;
    for (const Said& said : all) {
        below += said.weight * studentBelow((value - said.middle) / said.scale, said.degrees);
    }
    return below;
}

/// The value below which a share of the mixture lies.
double quantile(const std::vector<Said>& all, double share) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Said& said : all) {
        low = std::min(low, said.middle - said.scale);
        high = std::max(high, said.middle + said.scale);
    }
    for (double step = high - low; mixtureBelow(all, low) > share; step *= 2.0) {
        low -= step;
    }
    for (double step = high - low; mixtureBelow(all, high) < share; step *= 2.0) {
        high += step;
    }
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (mixtureBelow(all, middle) < share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

double studentBelow(double t, double degrees) {
    assert(degrees > 0.0);
    const double tail = 0.5 * incompleteBeta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
    return t > 0.0 ? 1.0 - tail : tail;
}

double studentQuantile(double normal, double degrees) {
    assert(degrees >= 1.0);
    const double x = normal;
    const double squared = x * x;
    const std::array<double, 4> terms{
        (squared + 1.0) / 4.0, ((5.0 * squared + 16.0) * squared + 3.0) / 96.0,
        (((3.0 * squared + 19.0) * squared + 17.0) * squared - 15.0) / 384.0,
        ((((79.0 * squared + 776.0) * squared + 1482.0) * squared - 1920.0) * squared - 945.0) / 92160.0};
    double series = 0.0;
    for (std::size_t k = terms.size(); k > 0; --k) {
        series = (series + terms[k - 1]) / degrees;
    }
    return x * (1.0 + series);
}

/// One reach and strength of the departure, held against the samples.
struct IntervalFit::Model {
    Model(const IntervalFit& fit, double strength_, double reach_, Eigen::Index lines)
        : samples(fit.m_scaled), strength(strength_), reach(reach_) {
        const Eigen::Index n = static_cast<Eigen::Index>(samples.size());
        Matrix covariance = Matrix::Identity(n, n);
        trend = Matrix::Ones(n, lines);
        Column y(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const std::vector<double>& at = samples[static_cast<std::size_t>(i)];
            for (Eigen::Index j = 0; j < n && strength > 0.0; ++j) {
                covariance(i, j) += strength * departureAt(at, samples[static_cast<std::size_t>(j)], reach);
            }
            trend.row(i) = trendAt(at, lines);
            y(i) = fit.m_values[static_cast<std::size_t>(i)];
        }
        factor.compute(covariance);
        const Matrix solved = factor.solve(trend);
        normal.compute(trend.transpose() * solved);
        line = normal.solve(solved.transpose() * y);
        residual = factor.solve(y - trend * line);
        const double square = (y - trend * line).dot(residual);
        degrees = priorSamples + static_cast<double>(n - lines);
        noise = (priorSamples * fit.m_scatter * fit.m_scatter + square) / degrees;
        const Matrix lower = factor.matrixL();
        const Matrix lowerNormal = normal.matrixL();
        weight =
            -lower.diagonal().array().log().sum() - lowerNormal.diagonal().array().log().sum() - 0.5 * degrees * std::log(noise);
    }

    static Eigen::RowVectorXd trendAt(const std::vector<double>& at, Eigen::Index lines) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Ones(lines);
        for (Eigen::Index d = 1; d < lines; ++d) {
            row(d) = at[static_cast<std::size_t>(d - 1)];
        }
        return row;
    }

    Said at(const std::vector<double>& place) const {
        Column reaching = Column::Zero(residual.size());
        for (Eigen::Index i = 0; i < reaching.size() && strength > 0.0; ++i) {
            reaching(i) = strength * departureAt(place, samples[static_cast<std::size_t>(i)], reach);
        }
        const Column row = trendAt(place, trend.cols()).transpose();
        const Column solved = factor.solve(reaching);
        const Column open = row - trend.transpose() * solved;
        const double variance = 1.0 + strength - reaching.dot(solved) + open.dot(normal.solve(open));
        return {weight, row.dot(line) + reaching.dot(residual), std::sqrt(noise * std::max(variance, 1e-12)), degrees};
    }

    const std::vector<std::vector<double>>& samples;
    double strength;
    double reach;
    Matrix trend;
    Eigen::LLT<Matrix> factor;
    Eigen::LLT<Matrix> normal;
    Column line;
    Column residual;
    double noise = 0.0;
    double degrees = 0.0;
    double weight = 0.0;
};

IntervalFit::IntervalFit(std::vector<FitSample> samples, double scatter) : m_scatter(scatter) {
    assert(samples.size() >= 3 && scatter > 0.0);
    const std::size_t coordinates = samples.front().at.size();
    const double n = static_cast<double>(samples.size());
    m_middle.assign(coordinates, 0.0);
    m_spread.assign(coordinates, 0.0);
    for (std::size_t d = 0; d < coordinates; ++d) {
        for (const FitSample& sample : samples) {
            assert(std::isfinite(sample.at[d]) && std::isfinite(sample.value));
            m_middle[d] += sample.at[d] / n;
        }
        for (const FitSample& sample : samples) {
            m_spread[d] += (sample.at[d] - m_middle[d]) * (sample.at[d] - m_middle[d]) / n;
        }
        m_spread[d] = std::sqrt(m_spread[d]);
        // Rounding of equal coordinates is no spread.
        if (m_spread[d] < 1e-9 * (1.0 + std::abs(m_middle[d]))) {
            m_spread[d] = 0.0;
        }
    }
    for (const FitSample& sample : samples) {
        m_scaled.push_back(scaled(sample.at));
        m_values.push_back(sample.value);
    }
}

std::vector<double> IntervalFit::scaled(const std::vector<double>& at) const {
    std::vector<double> result;
    for (std::size_t d = 0; d < at.size(); ++d) {
        if (m_spread[d] > 0.0) {
            result.push_back((at[d] - m_middle[d]) / m_spread[d]);
        }
    }
    return result;
}

FitInterval IntervalFit::predict(const std::vector<double>& at, double chance) const {
    assert(chance > 0.0 && chance < 1.0);
    const std::vector<double> place = scaled(at);
    // A line in every coordinate, as long as two samples are left to say how well it holds.
    Eigen::Index lines = 1 + static_cast<Eigen::Index>(std::min(place.size(), m_values.size() - 3));
    std::vector<Said> all;
    const auto ask = [&] {
        for (const double strength : strengths) {
            for (const double reach : reaches) {
                const Model model(*this, strength, reach, lines);
                if (model.normal.info() == Eigen::Success && std::isfinite(model.weight)) {
                    all.push_back(model.at(place));
                }
                if (strength == 0.0) {
                    break;
                }
            }
        }
    };
    ask();
    // Coordinates that always change together have no lines of their own.
    while (all.empty() && lines > 1) {
        --lines;
        ask();
    }
    double most = -std::numeric_limits<double>::infinity();
    for (const Said& said : all) {
        most = std::max(most, said.weight);
    }
    double sum = 0.0;
    for (Said& said : all) {
        sum += said.weight = std::exp(said.weight - most);
    }
    for (Said& said : all) {
        said.weight /= sum;
    }
    return {quantile(all, 0.5 - 0.5 * chance), quantile(all, 0.5), quantile(all, 0.5 + 0.5 * chance)};
}

}  // namespace rubble
