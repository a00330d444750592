#include "core/clusters/grid_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/clusters/grid_bounds.h"

namespace rubble {

namespace {

constexpr double scanRatio = 1.05;      // from one multiple of the scan to the next
constexpr double refinedRatio = 1.001;  // between the multiple chosen and the nearest known not to suffice
constexpr double atBound = 1.0 - 1e-12;

/// Counts clusters at common multiples.
class Count {
public:
    Count(Partitioner& partitioner, const std::array<AxisRange, 3>& ranges, const GridSettings& settings,
          const Execution& execution, const Sizing& sizing)
        : m_partitioner(partitioner), m_ranges(ranges), m_settings(settings), m_execution(execution), m_sizing(sizing) {}

    std::array<double, 3> sizesAt(double multiple) const {
        std::array<double, 3> sizes;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sizes[axis] = m_ranges[axis].nearest(multiple * m_sizing.axis[axis].meanDistance);
        }
        return sizes;
    }

    const Partition& at(double multiple) { return m_partitioner.at(sizesAt(multiple), m_settings, m_execution); }

    bool suffices(double multiple) {
        const double done = m_last > 1.0 ? std::clamp(std::log(multiple) / std::log(m_last), 0.0, 1.0) : 1.0;
        m_execution.report({"sizing.search", "Searching the Basic Grid", {}}, done);
        return m_partitioner.atMost(static_cast<std::size_t>(m_sizing.bodiesMax), sizesAt(multiple), m_settings, m_execution);
    }

    /// The multiple at which every axis has reached its upper bound, at least 1.
    double last() {
        m_last = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double distance = m_sizing.axis[axis].meanDistance;
            if (m_ranges[axis].moves() && distance > 0.0) {
                m_last = std::max(m_last, m_ranges[axis].high / distance);
            }
        }
        return m_last;
    }

private:
    Partitioner& m_partitioner;
    const std::array<AxisRange, 3>& m_ranges;
    const GridSettings& m_settings;
    const Execution& m_execution;
    const Sizing& m_sizing;
    double m_last = 1.0;
};

/// The multiple that the search ends at, and why.
std::pair<double, StoppedBy> search(Count& count) {
    const double last = count.last();
    if (count.suffices(1.0)) {
        return {1.0, StoppedBy::Efficiency};
    }
    double tooSmall = 1.0;
    double enough = std::numeric_limits<double>::infinity();
    while (tooSmall < last) {
        const double multiple = std::min(tooSmall * scanRatio, last);
        if (count.suffices(multiple)) {
            enough = multiple;
            break;
        }
        tooSmall = multiple;
    }
    if (!(enough <= last)) {
        return {last, StoppedBy::FpsUnreachable};
    }
    while (enough > tooSmall * refinedRatio) {
        const double middle = std::sqrt(enough * tooSmall);
        (count.suffices(middle) ? enough : tooSmall) = middle;
    }
    return {enough, StoppedBy::Efficiency};
}

}  // namespace

double AxisRange::nearest(double wanted) const {
    return std::max(low, std::min(wanted, high));
}

ClampedBy AxisRange::clampedAt(double wanted) const {
    if (!moves() || wanted < low) {
        return lowBy;
    }
    return wanted >= high * atBound ? highBy : ClampedBy::None;
}

AxisRange fixedRange(double size) {
    return {size, size, ClampedBy::None, ClampedBy::None};
}

AxisRange rangeOf(const AxisSizing& bounds) {
    switch (conflictOf(bounds)) {
        case BoundConflict::Spacing:
            return {bounds.accuracyMin, bounds.accuracyMin, ClampedBy::Spacing, ClampedBy::Spacing};
        case BoundConflict::FragmentSize:
            return {bounds.accuracyMin, bounds.accuracyMin, ClampedBy::FragmentSize, ClampedBy::FragmentSize};
        case BoundConflict::None:
            break;
    }
    const ClampedBy highBy = bounds.smallestComponent ? ClampedBy::ComponentSize : ClampedBy::None;
    return {bounds.accuracyMin, bounds.accuracyMax, ClampedBy::FragmentSize, highBy};
}

AxisRange nestedRange(const AxisSizing& bounds) {
    // Two masses at the ends of a box spread three times as far as the material that fills it.
    return {0.0, 2.0 * bounds.extent, ClampedBy::None, ClampedBy::None};
}

void searchGrid(Partitioner& partitioner, const std::array<AxisRange, 3>& ranges, const GridSettings& settings,
                const Execution& execution, Sizing& sizing) {
    Count count(partitioner, ranges, settings, execution, sizing);
    if (settings.oneBodyPerFragment || settings.multiple || (settings.length && settings.width && settings.height)) {
        sizing.commonMultiple = settings.oneBodyPerFragment ? 0.0 : settings.multiple.value_or(0.0);
        sizing.stoppedBy = StoppedBy::User;
    } else {
        std::tie(sizing.commonMultiple, sizing.stoppedBy) = search(count);
    }
    const std::array<double, 3> sizes = count.sizesAt(sizing.commonMultiple);
    const Partition& partition = count.at(sizing.commonMultiple);
    sizing.clusters = partition.clusters();
    sizing.awake = partition.awake;
    sizing.grid = {sizes[0], sizes[1], sizes[2]};
    for (std::size_t a = 0; a < 3; ++a) {
        AxisSizing& axis = sizing.axis[a];
        axis.size = sizes[a];
        axis.multiple = axis.meanDistance > 0.0 ? axis.size / axis.meanDistance : 0.0;
        axis.clampedBy = ranges[a].clampedAt(sizing.commonMultiple * axis.meanDistance);
    }
}

}  // namespace rubble
