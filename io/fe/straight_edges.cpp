#include "io/fe/straight_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/unknown.h"
#include "core/fe/components.h"

namespace rubble::io {

namespace {

using Edge = std::pair<std::size_t, std::size_t>;

constexpr double leastDifference = 1e-3;  // of an element's size, for it to count as curved
constexpr double farthest = 0.75;         // of an edge's length: a node farther from its middle stands on another edge

// In the order of the nodes on them: base, top, sides.
std::vector<Edge> edgesOf(ElementShape shape, EdgeOrder order) {
    const auto ring = [](std::size_t first, std::size_t count) {
        std::vector<Edge> edges;
        for (std::size_t i = 0; i < count; ++i) {
            edges.emplace_back(first + i, first + (i + 1) % count);
        }
        return edges;
    };
    const auto append = [](std::vector<Edge>& edges, const std::vector<Edge>& more) {
        edges.insert(edges.end(), more.begin(), more.end());
    };
    switch (shape) {
        case ElementShape::Hexahedron:
        case ElementShape::Wedge: {
            const std::size_t sides = shape == ElementShape::Wedge ? 3 : 4;
            std::vector<Edge> edges = ring(0, sides), between;
            for (std::size_t i = 0; i < sides; ++i) {
                between.emplace_back(i, i + sides);
            }
            append(edges, order == EdgeOrder::TopBeforeSides ? ring(sides, sides) : between);
            append(edges, order == EdgeOrder::TopBeforeSides ? between : ring(sides, sides));
            return edges;
        }
        case ElementShape::Pyramid:
        case ElementShape::Tetrahedron: {
            const std::size_t sides = shape == ElementShape::Pyramid ? 4 : 3;
            std::vector<Edge> edges = ring(0, sides);
            for (std::size_t i = 0; i < sides; ++i) {
                edges.emplace_back(i, sides);
            }
            return edges;
        }
        case ElementShape::Quadrilateral:
            return ring(0, 4);
        case ElementShape::Triangle:
            return ring(0, 3);
        case ElementShape::Beam:
            return {{0, 1}};
    }
    return {};
}

// Node counts of quadratic elements: a node on each edge, then at most one in the middle of each face and of the whole, which say
// nothing of edges. More or others are of higher order, or mix orders.
bool isQuadratic(ElementShape shape, std::size_t nodes) {
    constexpr std::array<std::pair<std::size_t, std::size_t>, 7> counts{
        {{20, 27}, {15, 21}, {13, 19}, {10, 15}, {8, 9}, {6, 7}, {3, 3}}};
    const auto& [least, most] = counts[static_cast<std::size_t>(shape)];
    return nodes >= least && nodes <= most;
}

Vec3 meanOf(std::span<const Vec3> places) {
    return std::accumulate(places.begin(), places.end(), Vec3(Vec3::Zero())) / static_cast<double>(places.size());
}

// Whether all nodes behind the corners lie in the middle of a flat face, or within a solid: then no edge has a node, and none is
// curved. A node off its face bulges the face, one elsewhere stands on an edge.
bool onlyInMiddles(ElementShape shape, std::span<const Vec3> nodes) {
    const auto corners = nodes.first(static_cast<std::size_t>(cornerCount(shape)));
    const Vec3 middle = meanOf(corners);
    std::vector<Vec3> middles;
    double within = isSolid(shape) ? std::numeric_limits<double>::infinity() : 0.0, size = 0.0;
    for (const auto& face : facesOf(shape)) {
        std::vector<Vec3> places;
        for (std::size_t c = 0; c < (face[3] < 0 ? 3U : 4U); ++c) {
            places.push_back(corners[static_cast<std::uint8_t>(face[c])]);
        }
        middles.push_back(meanOf(places));
        within = std::min(within, 0.5 * (middles.back() - middle).norm());
    }
    for (const Vec3& corner : corners) {
        size = std::max(size, (corner - middle).norm());
    }
    return std::all_of(nodes.begin() + cornerCount(shape), nodes.end(), [&](const Vec3& node) {
        return !node.allFinite() || (node - middle).norm() <= within ||
               std::any_of(middles.begin(), middles.end(),
                           [&](const Vec3& other) { return (node - other).norm() <= leastDifference * size; });
    });
}

constexpr std::size_t gaussPoints = 3;
const std::array<double, gaussPoints> gaussPlaces{-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
constexpr std::array<double, gaussPoints> gaussWeights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

/// A point of a face and its derivatives.
struct FacePoint {
    Vec3 place = Vec3::Zero(), alongR = Vec3::Zero(), alongS = Vec3::Zero();
};

// Eight nodes: corners, then those on the edges.
FacePoint onQuadrilateral(std::span<const Vec3> x, double r, double s) {
    constexpr std::array<std::array<double, 2>, 8> at{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    FacePoint point;
    for (std::size_t a = 0; a < 8; ++a) {
        const double u = at[a][0], v = at[a][1];
        double value = 0.0, byR = 0.0, byS = 0.0;
        if (a < 4) {
            value = 0.25 * (1.0 + u * r) * (1.0 + v * s) * (u * r + v * s - 1.0);
            byR = 0.25 * u * (1.0 + v * s) * (2.0 * u * r + v * s);
            byS = 0.25 * v * (1.0 + u * r) * (u * r + 2.0 * v * s);
        } else if (u == 0.0) {
            value = 0.5 * (1.0 - r * r) * (1.0 + v * s);
            byR = -r * (1.0 + v * s);
            byS = 0.5 * v * (1.0 - r * r);
        } else {
            value = 0.5 * (1.0 + u * r) * (1.0 - s * s);
            byR = 0.5 * u * (1.0 - s * s);
            byS = -s * (1.0 + u * r);
        }
        point.place += value * x[a];
        point.alongR += byR * x[a];
        point.alongS += byS * x[a];
    }
    return point;
}

// Six nodes: corners, then those on the edges. r and s are the shares of the second and the third corner.
FacePoint onTriangle(std::span<const Vec3> x, double r, double s) {
    const double q = 1.0 - r - s;
    FacePoint point;
    point.place = q * (2.0 * q - 1.0) * x[0] + r * (2.0 * r - 1.0) * x[1] + s * (2.0 * s - 1.0) * x[2] + 4.0 * q * r * x[3] +
                  4.0 * r * s * x[4] + 4.0 * s * q * x[5];
    point.alongR = (1.0 - 4.0 * q) * x[0] + (4.0 * r - 1.0) * x[1] + 4.0 * (q - r) * x[3] + 4.0 * s * (x[4] - x[5]);
    point.alongS = (1.0 - 4.0 * q) * x[0] + (4.0 * s - 1.0) * x[2] + 4.0 * r * (x[4] - x[3]) + 4.0 * (q - s) * x[5];
    return point;
}

// Sums a value over a face of six or eight nodes.
template <class Value>
double overFace(std::span<const Vec3> x, const Value& value) {
    double sum = 0.0;
    for (std::size_t i = 0; i < gaussPoints; ++i) {
        for (std::size_t j = 0; j < gaussPoints; ++j) {
            const double weight = gaussWeights[i] * gaussWeights[j];
            if (x.size() == 8) {
                sum += weight * value(onQuadrilateral(x, gaussPlaces[i], gaussPlaces[j]));
            } else {
                const double r = 0.5 * (1.0 + gaussPlaces[i]), s = 0.5 * (1.0 + gaussPlaces[j]) * (1.0 - r);
                sum += 0.25 * weight * (1.0 - r) * value(onTriangle(x, r, s));
            }
        }
    }
    return sum;
}

/// An element with a node on each edge.
class CurvedElement {
public:
    CurvedElement(ElementShape shape, EdgeOrder order, std::span<const Vec3> nodes)
        : m_shape(shape),
          m_edges(edgesOf(shape, order)),
          m_corners(nodes.begin(), nodes.begin() + cornerCount(shape)),
          m_middles(m_edges.size()) {
        for (std::size_t e = 0; e < m_edges.size(); ++e) {
            const Vec3& from = m_corners[m_edges[e].first];
            const Vec3& to = m_corners[m_edges[e].second];
            const Vec3 middle = 0.5 * (from + to), there = nodes[m_corners.size() + e];
            m_middles[e] = there.allFinite() ? there : middle;
            m_fits = m_fits && (m_middles[e] - middle).norm() <= farthest * (to - from).norm() + 1e-12 * middle.norm();
        }
        // Sizes do not depend on the place; far away they would lose digits.
        const Vec3 origin = m_corners.front();
        for (std::vector<Vec3>* list : {&m_corners, &m_middles}) {
            for (Vec3& node : *list) {
                node -= origin;
            }
        }
    }

    bool fits() const { return m_fits; }
    double straightSize() const { return std::abs(elementVolume(m_shape, m_corners, 1.0)); }

    double size() const {
        if (m_shape == ElementShape::Beam) {
            return length();
        }
        double sum = 0.0;
        for (const auto& face : facesOf(m_shape)) {
            const std::vector<Vec3> nodes = nodesOf(face);
            if (isShell(m_shape)) {
                sum += overFace(nodes, [](const FacePoint& p) { return p.alongR.cross(p.alongS).norm(); });
            } else {
                sum += overFace(nodes, [](const FacePoint& p) { return p.place.dot(p.alongR.cross(p.alongS)) / 3.0; });
            }
        }
        return std::abs(sum);
    }

private:
    double length() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < gaussPoints; ++i) {
            const double r = gaussPlaces[i];
            const Vec3 along = (r - 0.5) * m_corners[0] + (r + 0.5) * m_corners[1] - 2.0 * r * m_middles[0];
            sum += gaussWeights[i] * along.norm();
        }
        return sum;
    }

    std::vector<Vec3> nodesOf(const std::array<std::int8_t, 4>& face) const {
        const std::size_t corners = face[3] < 0 ? 3 : 4;
        std::vector<Vec3> nodes;
        for (std::size_t c = 0; c < corners; ++c) {
            nodes.push_back(m_corners[static_cast<std::uint8_t>(face[c])]);
        }
        for (std::size_t c = 0; c < corners; ++c) {
            const std::size_t a = static_cast<std::uint8_t>(face[c]), b = static_cast<std::uint8_t>(face[(c + 1) % corners]);
            const auto edge = std::find_if(m_edges.begin(), m_edges.end(),
                                           [&](const Edge& other) { return other == Edge{a, b} || other == Edge{b, a}; });
            nodes.push_back(m_middles[static_cast<std::size_t>(edge - m_edges.begin())]);
        }
        return nodes;
    }

    ElementShape m_shape;
    std::vector<Edge> m_edges;
    std::vector<Vec3> m_corners, m_middles;
    bool m_fits = true;
};

}  // namespace

void StraightEdges::add(ElementShape shape, EdgeOrder order, std::span<const Vec3> nodes, const std::string& name) {
    if (nodes.size() <= static_cast<std::size_t>(cornerCount(shape))) {
        return;
    }
    Sum& sum = m_sums[isSolid(shape) ? 0 : isShell(shape) ? 1 : 2];
    const std::size_t known = static_cast<std::size_t>(cornerCount(shape)) + edgesOf(shape, order).size();
    if (isQuadratic(shape, nodes.size())) {
        const CurvedElement element(shape, order, nodes.first(known));
        if (element.fits()) {
            const double straight = element.straightSize(), whole = element.size();
            const double difference = whole > 0.0 ? std::abs(straight / whole - 1.0) : 0.0;
            sum.straight += straight;
            sum.whole += whole;
            sum.curved += difference > leastDifference ? 1 : 0;
            if (difference > std::max(sum.worst, leastDifference)) {
                sum.worst = difference;
                sum.example = name;
            }
            return;
        }
    }
    if (onlyInMiddles(shape, nodes)) {
        return;
    }
    if (sum.unknown++ == 0) {
        sum.unknownExample = name;
    }
}

void StraightEdges::note(Findings& findings) const {
    constexpr std::array<std::array<const char*, 2>, 3> texts{
        {{"fe.straight_solids", "Curved edges of solids were taken straight, which changes their volume by {0} %"},
         {"fe.straight_shells", "Curved edges of shells were taken straight, which changes their area by {0} %"},
         {"fe.straight_beams", "Curved beams were taken straight, which changes their length by {0} %"}}};
    for (std::size_t kind = 0; kind < m_sums.size(); ++kind) {
        const Sum& sum = m_sums[kind];
        if (sum.curved > 0 && findings.count(texts[kind][0]) == 0) {
            const double ratio = sum.straight / sum.whole;
            const auto percent = [](double share) { return std::round(1e4 * share) / 100.0; };
            findings.add({texts[kind][0], texts[kind][1], {percent(ratio - 1.0)}},
                         {"fe.straight.remedy",
                          "Set component[NAME].density to {0} times its value to keep the mass, or mesh finer.",
                          {std::round(1e4 / ratio) / 1e4}},
                         sum.example + ": up to " + englishNumber(percent(sum.worst)) + " %", sum.curved);
        }
        if (sum.unknown > 0) {
            findings.add({"fe.straight_unknown",
                          "Nodes beside the corners were left out where nothing says whether edges or faces are curved",
                          {}},
                         {"fe.straight_unknown.remedy", "Compare the masses with the analysis, or write quadratic elements.", {}},
                         sum.unknownExample, sum.unknown);
        }
    }
}

std::vector<Vec3> placesOfNodes(std::span<const std::int64_t> numbers,
                                const std::unordered_map<std::int64_t, std::uint32_t>& places, const std::vector<Vec3>& listed) {
    std::vector<Vec3> list;
    for (const std::int64_t number : numbers) {
        const auto found = places.find(number);
        list.push_back(found != places.end() ? listed[found->second] : Vec3(Vec3::Constant(unknown)));
    }
    return list;
}

void putMiddleLast(std::array<std::int64_t, 3>& nodes, const std::array<Vec3, 3>& places) {
    std::size_t middle = 2;
    double longest = (places[1] - places[0]).norm();
    for (const std::size_t other : {std::size_t{1}, std::size_t{0}}) {
        const double apart = (places[2] - places[1 - other]).norm();
        if (apart > longest) {
            longest = apart;
            middle = other;
        }
    }
    std::rotate(nodes.begin() + static_cast<std::ptrdiff_t>(middle), nodes.begin() + static_cast<std::ptrdiff_t>(middle) + 1,
                nodes.end());
}

}  // namespace rubble::io
