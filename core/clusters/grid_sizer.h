#pragma once

#include <array>
#include <optional>

#include "core/clusters/grid_search.h"
#include "core/clusters/partition.h"
#include "core/clusters/sizing.h"

namespace rubble {

/// Sizes the Basic Grid of one set of fragments again and again, as a slider asks for: bounds, births and orders are made once, so
/// that another grid costs little more than its count. Not for use from two threads at once.
class GridSizer {
public:
    /// All three outlive the sizer.
    GridSizer(const FragmentSet& fragments, const Mesh& mesh, const Components& components);

    /// What sizeBasicGrid() gives for these settings. Throws Cancelled; the sizer can be used again after that.
    Sizing size(const GridSettings& settings, const Execution& execution);
    /// The partition that size() counted last, at the grid it chose. Valid until the next call.
    const Partition& counted() const { return m_partitioner.latest(); }

private:
    /// What the count at the published guide depends on, and its outcome.
    struct GuideCount {
        Grouping grouping{};
        std::int64_t bodiesMax = 0;
        bool acrossComponents = false;
        double velocityTolerance = 0.0;
        std::size_t clusters = 0;
    };

    std::array<AxisRange, 3> rangesFor(const GridSettings& settings, Sizing& sizing) const;
    void reportManyBirths(const GridSettings& settings, const Execution& execution, Sizing& sizing);
    std::size_t countAtGuide(const GridSettings& settings, const Execution& execution, const Sizing& sizing);

    const FragmentSet& m_fragments;
    const Mesh& m_mesh;
    const Components& m_components;
    std::array<AxisSizing, 3> m_bounds;
    Partitioner m_partitioner;
    std::optional<GuideCount> m_guide;
};

}  // namespace rubble
