#include "core/clusters/partition.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/clusters/fragment_order.h"
#include "core/clusters/velocity_split.h"

namespace rubble {

Partitioner::Partitioner(const FragmentSet& fragments, const Mesh& mesh) : m_cuts(fragments, mesh) {
    std::map<std::pair<std::uint32_t, double>, std::size_t> births;
    for (std::uint32_t f = 0; f < fragments.size(); ++f) {
        const Fragment& fragment = fragments.list[f];
        m_masses.push_back({fragment.mass, fragment.centre, fragment.inertia, fragment.velocity, fragment.angularVelocity});
        m_component.push_back(static_cast<std::uint32_t>(rubble::at(fragment.component)));
        m_components = std::max(m_components, m_component.back() + 1);
        const auto [place, isNew] = births.try_emplace({fragment.handOverState, fragment.endTime}, m_births.size());
        if (isNew) {
            m_births.push_back({fragment.handOverTime, {}, {}});
        }
        m_births[place->second].fragments.push_back(f);
    }
    const std::vector<Vec3> centres = orderingCentres(fragments);
    for (Birth& birth : m_births) {
        for (int axis = 0; axis < 3; ++axis) {
            birth.order[static_cast<std::size_t>(axis)] = orderFragments(fragments, mesh, centres, birth.fragments, axis);
        }
    }
}

const Partition& Partitioner::at(const std::array<double, 3>& size, const GridSettings& settings, const Execution& execution) {
    divide(size, settings, std::numeric_limits<std::size_t>::max(), execution);
    return m_partition;
}

bool Partitioner::atMost(std::size_t awake, const std::array<double, 3>& size, const GridSettings& settings,
                         const Execution& execution) {
    divide(size, settings, awake, execution);
    return m_partition.awake <= awake;
}

/// Takes a birth that was divided into the count of what is awake at once.
void Partitioner::countAwake(std::size_t birth, const GridSettings& settings) {
    m_clustersUpTo.push_back(m_partition.clusters());
    while (m_births[m_firstAwake].time < m_births[birth].time - settings.awakeTime) {
        ++m_firstAwake;
    }
    const std::size_t before = m_firstAwake > 0 ? m_clustersUpTo[m_firstAwake - 1] : 0;
    m_partition.awake = std::max(m_partition.awake, m_partition.clusters() - before);
}

/// Divides birth by birth; goes no further once more clusters than enough are awake at once.
void Partitioner::divide(const std::array<double, 3>& size, const GridSettings& settings, std::size_t enough,
                         const Execution& execution) {
    m_partition.members.clear();
    m_partition.sizes.clear();
    m_partition.productGroups = m_partition.splitByComponent = m_partition.splitByVelocity = m_partition.awake = 0;
    m_clustersUpTo.clear();
    m_firstAwake = 0;
    if (settings.oneBodyPerFragment) {
        m_partition.members.resize(m_masses.size());
        std::iota(m_partition.members.begin(), m_partition.members.end(), 0u);
        for (std::size_t birth = 0; birth < m_births.size(); ++birth) {
            m_partition.sizes.resize(m_partition.sizes.size() + m_births[birth].fragments.size(), 1u);
            countAwake(birth, settings);
        }
        m_partition.productGroups = m_masses.size();
        return;
    }
    const bool nested = settings.grouping == Grouping::Nested;
    for (int axis = 0; axis < 3 && !nested; ++axis) {
        groupAxis(axis, size[static_cast<std::size_t>(axis)], execution);
    }
    std::size_t offset = 0;
    for (std::size_t birth = 0; birth < m_births.size() && m_partition.awake <= enough; ++birth) {
        execution.check();
        if (nested) {
            cutBirth(m_births[birth], size, settings);
        } else {
            divideBirth(birth, offset, settings);
        }
        offset += m_births[birth].fragments.size();
        countAwake(birth, settings);
    }
}

void Partitioner::groupAxis(int axis, double size, const Execution& execution) {
    AxisLabels& labels = m_axis[static_cast<std::size_t>(axis)];
    if (labels.size == size) {
        return;
    }
    labels.size = -1.0;  // stays so if the work is cancelled
    labels.label.resize(m_masses.size());
    labels.groups.clear();
    std::span<std::uint32_t> rest = labels.label;
    for (const Birth& birth : m_births) {
        execution.check();
        labels.groups.push_back(
            m_grouping.group(birth.order[static_cast<std::size_t>(axis)], size, rest.first(birth.fragments.size())));
        rest = rest.subspan(birth.fragments.size());
    }
    labels.size = size;
}

/// Sorts the places in m_order by a key in [0, keys), equal keys in their order before.
void Partitioner::sortStably(std::span<const std::uint32_t> key, std::uint32_t keys) {
    if (keys <= 1) {
        return;
    }
    m_starts.assign(keys + 1, 0);
    for (const std::uint32_t place : m_order) {
        ++m_starts[key[place] + 1];
    }
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_sorted.resize(m_order.size());
    for (const std::uint32_t place : m_order) {
        m_sorted[m_starts[key[place]]++] = place;
    }
    m_order.swap(m_sorted);
}

/// Puts the places of a birth into m_order and their components, as far as these keep clusters apart, into m_componentOf.
void Partitioner::orderByComponent(std::span<const std::uint32_t> fragments, const GridSettings& settings) {
    m_componentOf.clear();
    for (const std::uint32_t f : fragments) {
        m_componentOf.push_back(settings.acrossComponents ? 0 : m_component[f]);
    }
    m_order.resize(fragments.size());
    std::iota(m_order.begin(), m_order.end(), 0u);
    sortStably(m_componentOf, settings.acrossComponents ? 1 : m_components);
}

void Partitioner::divideBirth(std::size_t birth, std::size_t offset, const GridSettings& settings) {
    const std::vector<std::uint32_t>& fragments = m_births[birth].fragments;
    const std::size_t n = fragments.size();
    std::array<std::span<const std::uint32_t>, 3> label;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        label[axis] = std::span(m_axis[axis].label).subspan(offset, n);
    }
    orderByComponent(fragments, settings);
    for (const std::size_t axis : {2u, 1u, 0u}) {
        sortStably(label[axis], m_axis[axis].groups[birth]);
    }
    const auto sameGroup = [&](std::uint32_t a, std::uint32_t b) {
        return label[0][a] == label[0][b] && label[1][a] == label[1][b] && label[2][a] == label[2][b];
    };
    for (std::size_t first = 0; first < n;) {
        std::size_t last = first + 1;
        while (last < n && sameGroup(m_order[first], m_order[last]) &&
               m_componentOf[m_order[first]] == m_componentOf[m_order[last]]) {
            ++last;
        }
        const bool continues = first > 0 && sameGroup(m_order[first - 1], m_order[first]);
        ++(continues ? m_partition.splitByComponent : m_partition.productGroups);
        const std::size_t begin = m_partition.members.size();
        for (std::size_t k = first; k < last; ++k) {
            m_partition.members.push_back(fragments[m_order[k]]);
        }
        const std::size_t firstSize = m_partition.sizes.size();
        m_partition.sizes.push_back(static_cast<std::uint32_t>(last - first));
        splitByVelocity(begin, firstSize, settings);
        first = last;
    }
}

void Partitioner::cutBirth(const Birth& birth, const std::array<double, 3>& size, const GridSettings& settings) {
    const std::size_t firstMember = m_partition.members.size();
    const std::size_t firstSize = m_partition.sizes.size();
    orderByComponent(birth.fragments, settings);
    for (const std::uint32_t place : m_order) {
        m_partition.members.push_back(birth.fragments[place]);
    }
    for (std::size_t first = 0; first < m_order.size();) {
        std::size_t last = first + 1;
        while (last < m_order.size() && m_componentOf[m_order[last]] == m_componentOf[m_order[first]]) {
            ++last;
        }
        m_cuts.cut(size, std::span(m_partition.members).subspan(firstMember + first, last - first), m_partition.sizes);
        first = last;
    }
    m_partition.productGroups += m_partition.sizes.size() - firstSize;
    splitByVelocity(firstMember, firstSize, settings);
}

/// Splits the clusters from `firstSize` on, whose members begin at `firstMember`.
void Partitioner::splitByVelocity(std::size_t firstMember, std::size_t firstSize, const GridSettings& settings) {
    if (!(settings.velocityTolerance > 0.0)) {
        return;
    }
    const std::vector<std::uint32_t> whole(m_partition.sizes.begin() + static_cast<std::ptrdiff_t>(firstSize),
                                           m_partition.sizes.end());
    m_partition.sizes.resize(firstSize);
    for (const std::uint32_t size : whole) {
        rubble::splitByVelocity(m_masses, settings.velocityTolerance, std::span(m_partition.members).subspan(firstMember, size),
                                m_partition.sizes);
        firstMember += size;
    }
    m_partition.splitByVelocity += m_partition.sizes.size() - firstSize - whole.size();
}

}  // namespace rubble
