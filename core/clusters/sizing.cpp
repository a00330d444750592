#include "core/clusters/sizing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/clusters/grid_bounds.h"
#include "core/clusters/grid_search.h"
#include "core/clusters/partition.h"

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

/// Counts clusters where one birth time would need no more than the bodies allowed; tells if the many births need more.
void reportManyBirths(Partitioner& partitioner, const Sizing& sizing, const GridSettings& settings, const Execution& execution,
                      Findings& findings) {
    const auto fragments = static_cast<double>(sizing.fragments);
    if (partitioner.births() < 2 || fragments <= static_cast<double>(sizing.bodiesMax)) {
        return;
    }
    std::array<double, 3> guide;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        guide[axis] = sizing.axis[axis].efficiencyMin;
    }
    const std::size_t clusters = partitioner.at(guide, settings, execution).clusters();
    if (clusters <= static_cast<std::size_t>(sizing.bodiesMax)) {
        return;
    }
    const double multiple = std::cbrt(fragments / static_cast<double>(sizing.bodiesMax));
    findings.add(
        {"sizing.many_births",
         "{0} fragments are born at {1} instants: at the guide of {2} mean distances, which would give {3} clusters for one birth "
         "time, {4} clusters are counted. The published \"two to three\" mean distances do not carry over where few fragments "
         "share a birth",
         {sizing.fragments, partitioner.births(), multiple, sizing.bodiesMax, clusters}},
        {"sizing.many_births.remedy", "Take the grid that was searched by counting; the guide is shown for comparison only", {}});
}

void reportFps(Sizing& sizing) {
    sizing.reachableFps = sizing.fpsTarget;
    if (sizing.clusters <= static_cast<std::size_t>(sizing.bodiesMax)) {
        return;
    }
    sizing.reachableFps *= static_cast<double>(sizing.bodiesMax) / static_cast<double>(sizing.clusters);
    const bool byHand = sizing.stoppedBy == StoppedBy::User;
    const Message remedy{
        "sizing.fps.remedy",
        "Accept a live rate of about {0}, merge small components into their neighbours, or raise bodies_max if this "
        "machine moves more",
        {Argument(sizing.reachableFps, "frames/s")}};
    if (byHand) {
        sizing.findings.add({"sizing.more_than_bodies_max",
                             "The grid set by hand gives {0} clusters, more than the {1} bodies that reach {2}",
                             {sizing.clusters, sizing.bodiesMax, Argument(sizing.fpsTarget, "frames/s")}},
                            remedy);
    } else {
        sizing.findings.add(
            {"sizing.fps_unreachable",
             "A live rate of {0} is out of reach: even at the upper bounds {1} clusters are counted, {2} are allowed; about "
             "{3} can be reached",
             {Argument(sizing.fpsTarget, "frames/s"), sizing.clusters, sizing.bodiesMax,
              Argument(sizing.reachableFps, "frames/s")}},
            remedy);
    }
}

}  // namespace

std::string_view clampedByName(ClampedBy by) {
    switch (by) {
        case ClampedBy::None:
            return "none";
        case ClampedBy::Spacing:
            return "spacing";
        case ClampedBy::FragmentSize:
            return "fragment_size";
        case ClampedBy::ComponentSize:
            return "component_size";
    }
    assert(false);
    return "";
}

std::string_view stoppedByName(StoppedBy by) {
    switch (by) {
        case StoppedBy::Efficiency:
            return "efficiency";
        case StoppedBy::FpsUnreachable:
            return "fps_unreachable";
        case StoppedBy::User:
            return "user";
    }
    assert(false);
    return "";
}

Sizing sizeBasicGrid(const FragmentSet& fragments, const Mesh& mesh, const Components& components, const GridSettings& settings,
                     const Execution& execution) {
    Sizing sizing;
    sizing.fragments = fragments.size();
    sizing.bodiesMax = settings.bodiesMax;
    sizing.fpsTarget = settings.fpsTarget;
    sizing.axis = boundGrid(fragments, mesh, components, settings.bodiesMax);
    Partitioner partitioner(fragments, mesh);
    if (!settings.oneBodyPerFragment) {
        reportManyBirths(partitioner, sizing, settings, execution, sizing.findings);
    }
    // Nested clusters keep within a component however large the grid.
    const bool boundByComponents = settings.grouping == Grouping::Axes || settings.acrossComponents;
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
            ranges[a] = boundByComponents ? rangeOf(bounds) : nestedRange(bounds);
            if (boundByComponents) {
                reportConflict(bounds, axis, fragments, mesh, components, sizing.findings);
            }
        }
    }
    searchGrid(partitioner, ranges, settings, execution, sizing);
    for (int axis = 0; axis < 3 && !settings.oneBodyPerFragment; ++axis) {
        const AxisSizing& chosen = sizing.axis[static_cast<std::size_t>(axis)];
        if (sizeByHand(axis, chosen.meanDistance, settings)) {
            reportOutside(chosen, axis, fragments, mesh, components, boundByComponents, sizing.findings);
        }
    }
    if (!settings.oneBodyPerFragment) {
        reportFps(sizing);
    }
    return sizing;
}

}  // namespace rubble
