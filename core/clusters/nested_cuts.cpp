#include "core/clusters/nested_cuts.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <tuple>

namespace rubble {

namespace {

/// D / m of a homogeneous box of the grid's size: 1 / 12 along each of three axes.
constexpr double spreadOfBox = 0.25;
/// A box that is just full is not cut for rounding.
constexpr double slack = 1.0 + 1e-9;
/// Fewer are sorted by comparing, which is quicker then.
constexpr std::size_t few = 512;
constexpr unsigned digitBits = 11;

}  // namespace

NestedCuts::NestedCuts(const FragmentSet& fragments, const Mesh& mesh) {
    for (const Fragment& fragment : fragments.list) {
        m_solids.push_back({fragment.centre, fragment.bounds.sizes(), fragment.mass});
    }
    std::vector<std::tuple<double, std::int64_t, std::uint32_t>> keys(fragments.size());
    for (int axis = 0; axis < 3; ++axis) {
        for (std::uint32_t f = 0; f < keys.size(); ++f) {
            const Fragment& fragment = fragments.list[f];
            keys[f] = {fragment.centre[axis], mesh.elementIds[at(fragment.element)], f};
        }
        std::ranges::sort(keys);
        AxisRanks& ranks = m_ranks[static_cast<std::size_t>(axis)];
        ranks.rank.resize(keys.size());
        for (const auto& [centre, element, f] : keys) {
            ranks.rank[f] = static_cast<std::uint32_t>(ranks.at.size());
            ranks.at.push_back(f);
        }
    }
}

NestedCuts::Spread NestedCuts::spreadOf(std::span<const std::uint32_t> members, const std::array<double, 3>& size) const {
    double mass = 0.0;
    Vec3 moment = Vec3::Zero();
    const Vec3 origin = m_solids[members.front()].centre;
    for (const std::uint32_t f : members) {
        mass += m_solids[f].mass;
        moment += m_solids[f].mass * (m_solids[f].centre - origin);
    }
    const Vec3 centre = origin + moment / mass;
    Vec3 between = Vec3::Zero();
    Vec3 within = Vec3::Zero();
    for (const std::uint32_t f : members) {
        const Solid& solid = m_solids[f];
        between += solid.mass * (solid.centre - centre).cwiseAbs2();
        within += solid.mass / 12.0 * solid.extents.cwiseAbs2();
    }
    const Vec3 scale = Vec3(size[0], size[1], size[2]).cwiseAbs2().cwiseInverse() / mass;
    between = between.cwiseProduct(scale);
    Spread spread;
    spread.perMass = between.sum() + within.dot(scale);
    between.maxCoeff(&spread.axis);
    return spread;
}

/// Sorts numbers below that of the fragments, digit by digit from the least where there are many: then the time grows as their
/// number does.
void NestedCuts::sort(std::span<std::uint32_t> numbers) {
    if (numbers.size() < few) {
        std::ranges::sort(numbers);
        return;
    }
    m_sorted.resize(numbers.size());
    for (unsigned shift = 0; (m_solids.size() - 1) >> shift > 0; shift += digitBits) {
        std::array<std::size_t, (std::size_t{1} << digitBits) + 1> first{};
        const auto digit = [shift](std::uint32_t number) { return (number >> shift) & ((1u << digitBits) - 1u); };
        for (const std::uint32_t number : numbers) {
            ++first[digit(number) + 1];
        }
        std::partial_sum(first.begin(), first.end(), first.begin());
        for (const std::uint32_t number : numbers) {
            m_sorted[first[digit(number)]++] = number;
        }
        std::ranges::copy(m_sorted, numbers.begin());
    }
}

/// Orders the members along the axis; returns how many stand before the cut that leaves the least spread on its two sides.
std::size_t NestedCuts::bestCut(std::span<std::uint32_t> members, int axis) {
    const AxisRanks& ranks = m_ranks[static_cast<std::size_t>(axis)];
    std::ranges::transform(members, members.begin(), [&](std::uint32_t f) { return ranks.rank[f]; });
    sort(members);
    std::ranges::transform(members, members.begin(), [&](std::uint32_t rank) { return ranks.at[rank]; });
    const double origin = m_solids[members.front()].centre[axis];
    double mass = 0.0;
    double moment = 0.0;
    for (const std::uint32_t f : members) {
        mass += m_solids[f].mass;
        moment += m_solids[f].mass * (m_solids[f].centre[axis] - origin);
    }
    // Least within the sides is most between them.
    std::size_t best = members.size() / 2;
    double most = 0.0;
    double before = 0.0;
    double momentBefore = 0.0;
    for (std::size_t k = 0; k + 1 < members.size(); ++k) {
        const Solid& solid = m_solids[members[k]];
        before += solid.mass;
        momentBefore += solid.mass * (solid.centre[axis] - origin);
        const double apart = momentBefore / before - (moment - momentBefore) / (mass - before);
        const double between = before * (mass - before) * apart * apart;
        if (between > most) {
            most = between;
            best = k + 1;
        }
    }
    return best;
}

void NestedCuts::cut(const std::array<double, 3>& size, std::span<std::uint32_t> members, std::vector<std::uint32_t>& sizes) {
    assert(size[0] > 0.0 && size[1] > 0.0 && size[2] > 0.0);
    m_open.assign(1, members);
    while (!m_open.empty()) {
        const std::span<std::uint32_t> part = m_open.back();
        m_open.pop_back();
        const Spread spread = spreadOf(part, size);
        if (part.size() < 2 || spread.perMass <= spreadOfBox * slack) {
            sort(part);
            sizes.push_back(static_cast<std::uint32_t>(part.size()));
            continue;
        }
        const std::size_t first = bestCut(part, spread.axis);
        m_open.push_back(part.subspan(first));
        m_open.push_back(part.first(first));
    }
}

}  // namespace rubble
