#include "core/clusters/grid_sizer.h"

#include <cmath>

#include "core/base/same_bits.h"
#include "core/clusters/grid_bounds.h"
#include "core/clusters/grid_search.h"

namespace rubble {

namespace {

/// The size that the user gives an axis, by hand or by the common multiple.
std::optional<double> sizeByHand(int axis, double meanDistance, const GridSettings& settings) {
    const std::array<std::optional<double>, 3> byHand{settings.length, settings.width, settings.height};
    if (byHand[static_cast<std::size_t>(axis)]) {
        return byHand[static_cast<std::size_t>(axis)];
    }
    return settings.multiple ? std::optional(*settings.multiple * meanDistance) : std::nullopt;
}

void reportFps(Sizing& sizing) {
    sizing.reachableFps = sizing.fpsTarget;
    if (sizing.awake <= static_cast<std::size_t>(sizing.bodiesMax)) {
        return;
    }
    sizing.reachableFps *= static_cast<double>(sizing.bodiesMax) / static_cast<double>(sizing.awake);
    const bool byHand = sizing.stoppedBy == StoppedBy::User;
    const Message remedy{
        "sizing.fps.remedy",
        "Accept a live rate of about {0}, merge small components into their neighbours, or raise bodies_max if this "
        "machine moves more",
        {Argument(sizing.reachableFps, "FPS")}};
    if (byHand) {
        sizing.findings.add({"sizing.more_than_bodies_max",
                             "The grid set by hand has {0} clusters awake at once, more than the {1} bodies that reach {2}",
                             {sizing.awake, sizing.bodiesMax, Argument(sizing.fpsTarget, "FPS")}},
                            remedy);
    } else {
        sizing.findings.add(
            {"sizing.fps_unreachable",
             "A live rate of {0} is out of reach: even at the upper bounds {1} clusters are awake at once, {2} are allowed; "
             "about {3} can be reached",
             {Argument(sizing.fpsTarget, "FPS"), sizing.awake, sizing.bodiesMax, Argument(sizing.reachableFps, "FPS")}},
            remedy);
    }
}

}  // namespace

GridSizer::GridSizer(const FragmentSet& fragments, const Mesh& mesh, const Components& components)
    : m_fragments(fragments),
      m_mesh(mesh),
      m_components(components),
      m_bounds(boundGrid(fragments, mesh, components, 1)),
      m_partitioner(fragments, mesh) {}

Sizing GridSizer::size(const GridSettings& settings, const Execution& execution) {
    Sizing sizing;
    sizing.fragments = m_fragments.size();
    sizing.bodiesMax = settings.bodiesMax;
    sizing.fpsTarget = settings.fpsTarget;
    sizing.axis = m_bounds;
    for (AxisSizing& axis : sizing.axis) {
        axis.efficiencyMin = guideSize(axis.meanDistance, sizing.fragments, settings.bodiesMax);
    }
    // Who leaves it to the search gets what was counted, whatever the guide says.
    const bool byHand = settings.multiple || settings.length || settings.width || settings.height;
    if (!settings.oneBodyPerFragment && byHand) {
        reportManyBirths(settings, execution, sizing);
    }
    searchGrid(m_partitioner, rangesFor(settings, sizing), settings, execution, sizing);
    for (int axis = 0; axis < 3 && !settings.oneBodyPerFragment; ++axis) {
        const AxisSizing& chosen = sizing.axis[static_cast<std::size_t>(axis)];
        if (sizeByHand(axis, chosen.meanDistance, settings)) {
            reportOutside(chosen, axis, m_fragments, m_mesh, m_components, boundByComponents(settings), sizing.findings);
        }
    }
    if (!settings.oneBodyPerFragment) {
        reportFps(sizing);
    }
    return sizing;
}

std::array<AxisRange, 3> GridSizer::rangesFor(const GridSettings& settings, Sizing& sizing) const {
    std::array<AxisRange, 3> ranges;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const AxisSizing& bounds = sizing.axis[a];
        const std::optional<double> byHand = sizeByHand(axis, bounds.meanDistance, settings);
        if (settings.oneBodyPerFragment) {
            ranges[a] = fixedRange(0.0);
        } else if (byHand) {
            ranges[a] = fixedRange(*byHand);
        } else {
            ranges[a] = boundByComponents(settings) ? rangeOf(bounds) : nestedRange(bounds);
            if (boundByComponents(settings)) {
                reportConflict(bounds, axis, m_fragments, m_mesh, m_components, sizing.findings);
            }
        }
    }
    return ranges;
}

/// Clusters where one birth time would need no more than the bodies allowed; counted once for settings that decide it.
std::size_t GridSizer::countAtGuide(const GridSettings& settings, const Execution& execution, const Sizing& sizing) {
    const bool known = m_guide && m_guide->grouping == settings.grouping && m_guide->bodiesMax == settings.bodiesMax &&
                       m_guide->acrossComponents == settings.acrossComponents &&
                       m_guide->velocityTolerance == settings.velocityTolerance;
    if (!known) {
        std::array<double, 3> guide;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            guide[axis] = sizing.axis[axis].efficiencyMin;
        }
        const std::size_t clusters = m_partitioner.at(guide, settings, execution).clusters();
        m_guide =
            GuideCount{settings.grouping, settings.bodiesMax, settings.acrossComponents, settings.velocityTolerance, clusters};
    }
    return m_guide->clusters;
}

/// Tells if the many births need more than the bodies allowed where one birth would not.
void GridSizer::reportManyBirths(const GridSettings& settings, const Execution& execution, Sizing& sizing) {
    const auto fragments = static_cast<double>(sizing.fragments);
    if (m_partitioner.births() < 2 || fragments <= static_cast<double>(sizing.bodiesMax)) {
        return;
    }
    const std::size_t clusters = countAtGuide(settings, execution, sizing);
    if (clusters <= static_cast<std::size_t>(sizing.bodiesMax)) {
        return;
    }
    const double multiple = cubeRootOf(fragments / static_cast<double>(sizing.bodiesMax));
    sizing.findings.add(
        {"sizing.many_births",
         "{0} fragments are born at {1} instants: at the guide of {2} mean distances, which would give {3} clusters for one birth "
         "time, {4} clusters are counted. The published \"two to three\" mean distances do not carry over where few fragments "
         "share a birth",
         {sizing.fragments, m_partitioner.births(), multiple, sizing.bodiesMax, clusters}},
        {"sizing.many_births.remedy",
         "Leave the multiple automatic, which is searched by counting. The guide is shown for comparison only.",
         {}});
}

}  // namespace rubble
