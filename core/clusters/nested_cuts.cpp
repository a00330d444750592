#include "core/clusters/nested_cuts.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace rubble {

namespace {

/// D / m of a homogeneous box of the grid's size: 1 / 12 along each of three axes.
constexpr double spreadOfBox = 0.25;
/// A box that is just full is not cut for rounding.
constexpr double slack = 1.0 + 1e-9;

}  // namespace

NestedCuts::NestedCuts(const FragmentSet& fragments, const Mesh& mesh) {
    for (const Fragment& fragment : fragments.list) {
        m_solids.push_back({fragment.centre, fragment.bounds.sizes(), fragment.mass, mesh.elementIds[at(fragment.element)]});
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

/// Orders the members along the axis; returns how many stand before the cut that leaves the least spread on its two sides.
std::size_t NestedCuts::bestCut(std::span<std::uint32_t> members, int axis) {
    std::ranges::sort(members, [&](std::uint32_t a, std::uint32_t b) {
        return std::make_tuple(m_solids[a].centre[axis], m_solids[a].element, a) <
               std::make_tuple(m_solids[b].centre[axis], m_solids[b].element, b);
    });
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
            std::ranges::sort(part);
            sizes.push_back(static_cast<std::uint32_t>(part.size()));
            continue;
        }
        const std::size_t first = bestCut(part, spread.axis);
        m_open.push_back(part.subspan(first));
        m_open.push_back(part.first(first));
    }
}

}  // namespace rubble
