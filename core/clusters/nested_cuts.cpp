#include "core/clusters/nested_cuts.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/base/same_bits.h"

namespace rubble {

namespace {

/// D / m of a homogeneous box of the grid's size: 1 / 12 along each of three axes.
constexpr double spreadOfBox = 0.25;
/// A box that is just full is not cut for rounding.
constexpr double slack = 1.0 + 1e-9;
/// Fewer are sorted by comparing, which is quicker then.
constexpr std::size_t few = 512;
constexpr unsigned digitBits = 11;
/// Of the mean moment, added along every direction: of fragments of no thickness no box would have the shape.
constexpr double thickness = 1e-4;
/// A direction is worth a cut across it if the centres lie further apart along it than along an axis by this share of the square.
constexpr double skew = 0.01;

using Moment = Eigen::Matrix<double, 6, 1>;

/// Second moment of mass of a body from its inertia.
Moment secondMoment(const Mat3& inertia) {
    Moment moment;
    moment << Vec3::Constant(0.5 * inertia.trace()) - inertia.diagonal(), -inertia(0, 1), -inertia(0, 2), -inertia(1, 2);
    return moment;
}

/// x x^T
Moment square(const Vec3& x) {
    return Moment{x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[0] * x[2], x[1] * x[2]};
}

Mat3 matrixOf(const Moment& moment) {
    Mat3 matrix;
    matrix << moment[0], moment[3], moment[4],  //
        moment[3], moment[1], moment[5],        //
        moment[4], moment[5], moment[2];
    return matrix;
}

Mat3 thickened(const Mat3& moment) {
    return moment + thickness / 3.0 * moment.trace() * Mat3::Identity();
}

}  // namespace

NestedCuts::NestedCuts(const FragmentSet& fragments, const Mesh& mesh) {
    Moment all = Moment::Zero();
    for (const Fragment& fragment : fragments.list) {
        m_solids.push_back({fragment.centre, fragment.mass, secondMoment(fragment.inertia)});
        all += m_solids.back().second;
    }
    if (const Mat3 moment = matrixOf(all); moment.trace() > 0.0) {
        const Vec3 squares = thickened(moment).diagonal();
        m_usual = (squares / cubeRootOf(squares.prod())).cwiseSqrt();
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

NestedCuts::Form NestedCuts::formOf(std::span<const std::uint32_t> members, const Vec3& stretch) const {
    Moment between = Moment::Zero();
    Moment own = Moment::Zero();
    double mass = 0.0;
    Vec3 moment = Vec3::Zero();
    const Vec3 origin = m_solids[members.front()].centre;
    for (const std::uint32_t f : members) {
        const Solid& solid = m_solids[f];
        const Vec3 place = solid.centre - origin;
        mass += solid.mass;
        moment += solid.mass * place;
        between += solid.mass * square(place);
        own += solid.second;
    }
    Form form;
    form.between = matrixOf(between - square(moment) / mass);
    const Mat3 within = matrixOf(own);
    const Mat3 shape = thickened(within);
    form.box = stretch.asDiagonal() * (shape / cubeRootOf(shape.determinant())) * stretch.asDiagonal();
    form.inverse = form.box.inverse();
    form.perMass = form.inverse.cwiseProduct(form.between + within).sum() / mass;
    return form;
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

void NestedCuts::sortAlongAxis(std::span<std::uint32_t> members, int axis) {
    const AxisRanks& ranks = m_ranks[static_cast<std::size_t>(axis)];
    std::ranges::transform(members, members.begin(), [&](std::uint32_t f) { return ranks.rank[f]; });
    sort(members);
    std::ranges::transform(members, members.begin(), [&](std::uint32_t rank) { return ranks.at[rank]; });
}

/// Leaves the members in m_sorted.
void NestedCuts::sortAlong(std::span<const std::uint32_t> members, const Vec3& normal) {
    m_along.clear();
    const Vec3 origin = m_solids[members.front()].centre;
    for (const std::uint32_t f : members) {
        m_along.emplace_back(normal.dot(m_solids[f].centre - origin), f);
    }
    std::ranges::sort(m_along);
    m_sorted.resize(members.size());
    std::ranges::transform(m_along, m_sorted.begin(), [](const auto& each) { return each.second; });
}

/// How many stand before the cut that leaves the least spread along the normal on its two sides.
std::size_t NestedCuts::bestAlong(std::span<const std::uint32_t> ordered, const Vec3& normal) const {
    const Vec3 origin = m_solids[ordered.front()].centre;
    double mass = 0.0;
    double moment = 0.0;
    for (const std::uint32_t f : ordered) {
        mass += m_solids[f].mass;
        moment += m_solids[f].mass * normal.dot(m_solids[f].centre - origin);
    }
    // Least within the sides is most between them.
    std::size_t best = ordered.size() / 2;
    double most = 0.0;
    double before = 0.0;
    double momentBefore = 0.0;
    for (std::size_t k = 0; k + 1 < ordered.size(); ++k) {
        const Solid& solid = m_solids[ordered[k]];
        before += solid.mass;
        momentBefore += solid.mass * normal.dot(solid.centre - origin);
        const double apart = momentBefore / before - (moment - momentBefore) / (mass - before);
        const double between = before * (mass - before) * apart * apart;
        if (between > most) {
            most = between;
            best = k + 1;
        }
    }
    return best;
}

/// By how much a cut makes the spread less.
double NestedCuts::gainOf(std::span<const std::uint32_t> ordered, std::size_t first, const Mat3& inverse) const {
    const Vec3 origin = m_solids[ordered.front()].centre;
    std::array<double, 2> mass{};
    std::array<Vec3, 2> moment{Vec3::Zero(), Vec3::Zero()};
    for (std::size_t k = 0; k < ordered.size(); ++k) {
        const Solid& solid = m_solids[ordered[k]];
        const std::size_t side = k < first ? 0 : 1;
        mass[side] += solid.mass;
        moment[side] += solid.mass * (solid.centre - origin);
    }
    const Vec3 apart = moment[1] / mass[1] - moment[0] / mass[0];
    return mass[0] * mass[1] / (mass[0] + mass[1]) * apart.dot(inverse * apart);
}

/// Orders the members; returns how many stand before the cut.
std::size_t NestedCuts::cutPart(std::span<std::uint32_t> members, const Form& form) {
    if (members.size() == 2) {
        return 1;
    }
    int axis = 0;
    const double widest = form.between.diagonal().cwiseQuotient(form.box.diagonal()).maxCoeff(&axis);
    sortAlongAxis(members, axis);
    const std::size_t across = bestAlong(members, Vec3::Unit(axis));
    const Eigen::LLT<Mat3> root(form.box);
    const Mat3 half = root.matrixL().solve(form.between);
    Eigen::SelfAdjointEigenSolver<Mat3> directions;
    directions.computeDirect(root.matrixL().solve(Mat3(half.transpose())));
    if (!(directions.eigenvalues()[2] > (1.0 + skew) * widest)) {
        return across;
    }
    const Vec3 normal = root.matrixU().solve(Vec3(directions.eigenvectors().col(2)));
    sortAlong(members, normal);
    const std::size_t along = bestAlong(m_sorted, normal);
    if (!(gainOf(m_sorted, along, form.inverse) > gainOf(members, across, form.inverse))) {
        return across;
    }
    std::ranges::copy(m_sorted, members.begin());
    return along;
}

void NestedCuts::cut(const std::array<double, 3>& size, std::span<std::uint32_t> members, std::vector<std::uint32_t>& sizes) {
    assert(size[0] > 0.0 && size[1] > 0.0 && size[2] > 0.0);
    const Vec3 stretch = Vec3(size[0], size[1], size[2]).cwiseQuotient(m_usual);
    m_open.assign(1, members);
    while (!m_open.empty()) {
        const std::span<std::uint32_t> part = m_open.back();
        m_open.pop_back();
        const bool single = part.size() == 1;
        const Form form = single ? Form() : formOf(part, stretch);
        if (single || form.perMass <= spreadOfBox * slack) {
            sort(part);
            sizes.push_back(static_cast<std::uint32_t>(part.size()));
            continue;
        }
        const std::size_t first = cutPart(part, form);
        m_open.push_back(part.subspan(first));
        m_open.push_back(part.first(first));
    }
}

}  // namespace rubble
