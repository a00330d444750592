#include "core/clusters/grid_bounds.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string>

#include "core/base/same_bits.h"
#include "core/clusters/fragment_order.h"

namespace rubble {

namespace {

void boundByFragments(AxisSizing& sizing, int axis, const FragmentSet& fragments) {
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        const Aabb& bounds = fragments.list[f].bounds;
        const double outer = bounds.max()[axis] - bounds.min()[axis];
        if (!sizing.largestFragment || outer > sizing.accuracyMin) {
            sizing.accuracyMin = outer;
            sizing.largestFragment = idAt<FragmentId>(f);
        }
    }
}

void boundByComponents(AxisSizing& sizing, int axis, const Components& components) {
    for (std::size_t c = 0; c < components.list.size(); ++c) {
        const Component& component = components.list[c];
        if (!component.structural || component.bounds.isEmpty()) {
            continue;
        }
        const double extent = component.bounds.max()[axis] - component.bounds.min()[axis];
        if (!sizing.smallestComponent || extent < sizing.accuracyMax) {
            sizing.accuracyMax = extent;
            sizing.smallestComponent = idAt<ComponentId>(c);
        }
    }
}

/// Size of the box around all fragments [m]: beyond it nothing is left to join.
Vec3 extentOf(const FragmentSet& fragments) {
    Aabb all;
    for (const Fragment& fragment : fragments.list) {
        all.extend(fragment.bounds);
    }
    return all.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(all.sizes());
}

const char* axisName(int axis) {
    constexpr std::array names{"x", "y", "z"};
    return names[static_cast<std::size_t>(axis)];
}

std::int64_t elementOf(FragmentId f, const FragmentSet& fragments, const Mesh& mesh) {
    return mesh.elementIds[at(fragments.list[at(f)].element)];
}

const std::string& componentOf(FragmentId f, const FragmentSet& fragments, const Components& components) {
    return components.list[at(fragments.list[at(f)].component)].name;
}

}  // namespace

std::array<AxisSizing, 3> boundGrid(const FragmentSet& fragments, const Mesh& mesh, const Components& components,
                                    std::int64_t bodiesMax) {
    assert(bodiesMax > 0);
    std::array<AxisSizing, 3> axes;
    const Vec3 extent = extentOf(fragments);
    const std::vector<Vec3> centres = orderingCentres(fragments);
    std::vector<std::uint32_t> everyone(fragments.size());
    std::iota(everyone.begin(), everyone.end(), 0u);
    for (int axis = 0; axis < 3; ++axis) {
        AxisSizing& sizing = axes[static_cast<std::size_t>(axis)];
        sizing.meanDistance = orderFragments(fragments, mesh, centres, everyone, axis).meanDistance();
        sizing.efficiencyMin = guideSize(sizing.meanDistance, fragments.size(), bodiesMax);
        boundByFragments(sizing, axis, fragments);
        sizing.extent = sizing.accuracyMax = extent[axis];
        boundByComponents(sizing, axis, components);
    }
    return axes;
}

double guideSize(double meanDistance, std::size_t fragments, std::int64_t bodiesMax) {
    return meanDistance * cubeRootOf(static_cast<double>(fragments) / static_cast<double>(std::max<std::int64_t>(1, bodiesMax)));
}

BoundConflict conflictOf(const AxisSizing& axis) {
    if (axis.meanDistance > axis.accuracyMax) {
        return BoundConflict::Spacing;
    }
    return axis.accuracyMin > axis.accuracyMax ? BoundConflict::FragmentSize : BoundConflict::None;
}

void reportConflict(const AxisSizing& sizing, int axis, const FragmentSet& fragments, const Mesh& mesh,
                    const Components& components, Findings& findings) {
    const BoundConflict conflict = conflictOf(sizing);
    if (conflict == BoundConflict::None || !sizing.largestFragment || !sizing.smallestComponent) {
        return;
    }
    const std::string& small = components.list[at(*sizing.smallestComponent)].name;
    const Message remedy{
        "sizing.conflict.remedy",
        "The grid is {0} along {1}; the split by component keeps every cluster within one component. To give it room, "
        "merge \"{2}\" with a neighbour or set component[{2}].structural = false",
        {Argument(sizing.accuracyMin, "m"), axisName(axis), small}};
    const std::string element = std::to_string(elementOf(*sizing.largestFragment, fragments, mesh));
    const std::string& large = componentOf(*sizing.largestFragment, fragments, components);
    const std::string example = "element " + element + " (" + large + ")";
    if (conflict == BoundConflict::Spacing) {
        findings.add(
            {std::string("sizing.spacing_over_component.") + axisName(axis),
             "Along {0} the mean distance of the fragments, {1}, exceeds the smallest structural component, \"{2}\" with {3}; "
             "the largest fragment is element {4} of \"{5}\" with {6}",
             {axisName(axis), Argument(sizing.meanDistance, "m"), small, Argument(sizing.accuracyMax, "m"), element, large,
              Argument(sizing.accuracyMin, "m")}},
            remedy, example);
    } else {
        findings.add(
            {std::string("sizing.fragment_over_component.") + axisName(axis),
             "Along {0} the largest fragment, element {1} of \"{2}\" with {3}, exceeds the smallest structural component, "
             "\"{4}\" with {5}",
             {axisName(axis), element, large, Argument(sizing.accuracyMin, "m"), small, Argument(sizing.accuracyMax, "m")}},
            remedy, example);
    }
}

void reportOutside(const AxisSizing& sizing, int axis, const FragmentSet& fragments, const Mesh& mesh, const Components& components,
                   bool byComponents, Findings& findings) {
    if (sizing.largestFragment && sizing.size < sizing.accuracyMin) {
        const std::string element = std::to_string(elementOf(*sizing.largestFragment, fragments, mesh));
        findings.add(
            {std::string("sizing.below_fragment.") + axisName(axis),
             "Along {0} the grid of {1} is smaller than the largest fragment, element {2} of \"{3}\" with {4}",
             {axisName(axis), Argument(sizing.size, "m"), element, componentOf(*sizing.largestFragment, fragments, components),
              Argument(sizing.accuracyMin, "m")}},
            {"sizing.below_fragment.remedy", "Fragments wider than the grid mostly stand alone; raise it for fewer bodies", {}},
            "element " + element);
    }
    if (byComponents && sizing.smallestComponent && sizing.size > sizing.accuracyMax) {
        findings.add({std::string("sizing.above_component.") + axisName(axis),
                      "Along {0} the grid of {1} is larger than the smallest structural component, \"{2}\" with {3}",
                      {axisName(axis), Argument(sizing.size, "m"), components.list[at(*sizing.smallestComponent)].name,
                       Argument(sizing.accuracyMax, "m")}},
                     {"sizing.above_component.remedy", "Whole components may move as one body; lower the grid for accuracy", {}},
                     components.list[at(*sizing.smallestComponent)].name);
    }
}

}  // namespace rubble
