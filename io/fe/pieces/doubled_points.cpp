#include "io/fe/pieces/doubled_points.h"

#include <algorithm>
#include <numeric>

#include "io/fe/pieces/place_index.h"

namespace rubble::io {

namespace {

using Group = std::vector<std::uint32_t>;

bool severalPieces(const std::vector<std::uint32_t>& pieceOfNode) {
    return std::any_of(pieceOfNode.begin(), pieceOfNode.end(), [&](std::uint32_t piece) { return piece != pieceOfNode.front(); });
}

// Each cell has points of its own.
bool sharesNothing(const Mesh& mesh) {
    std::vector<bool> used(mesh.nodeCount(), false);
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const auto corners = mesh.cornersOf(idAt<ElementIndex>(e));
        for (const std::uint32_t corner : corners) {
            if (used[corner]) {
                return false;
            }
        }
        for (const std::uint32_t corner : corners) {
            used[corner] = true;
        }
    }
    return mesh.elementCount() > 1;
}

/// Finds groups of points at one place and parts those that part.
class PointGroups {
public:
    explicit PointGroups(const WrittenPoints& points) : m_points(points), m_tolerance(placeTolerance(points.mesh.nodes)) {}

    /// @param anywhere  points of one piece as well
    void find(bool anywhere) {
        PlaceIndex places(m_tolerance);
        std::vector<Group> at(m_points.mesh.nodeCount());
        for (std::uint32_t n = 0; n < m_points.mesh.nodeCount(); ++n) {
            at[places.put(m_points.mesh.nodes[n], n)].push_back(n);
        }
        for (Group& group : at) {
            const bool wanted = std::any_of(group.begin(), group.end(), [&](std::uint32_t n) {
                return n != group.front() && (anywhere || m_points.pieceOfNode[n] != m_points.pieceOfNode[group.front()]);
            });
            if (wanted) {
                m_groups.push_back(std::move(group));
            }
        }
    }

    bool empty() const { return m_groups.empty(); }
    std::int64_t parted() const { return m_parted; }

    /// Parts what does not lie at one place at a state. A point that is not there cannot tell.
    void partAt(const std::vector<Vec3>& places) {
        std::vector<Group> groups;
        for (const Group& group : m_groups) {
            const std::size_t before = groups.size();
            for (const std::uint32_t n : group) {
                const auto own = std::find_if(groups.begin() + static_cast<std::ptrdiff_t>(before), groups.end(),
                                              [&](const Group& other) { return together(places[n], placeOf(other, places)); });
                if (own == groups.end()) {
                    groups.push_back({n});
                } else {
                    own->push_back(n);
                }
            }
            m_parted += groups.size() > before + 1 ? 1 : 0;
        }
        std::erase_if(groups, [](const Group& group) { return group.size() < 2; });
        m_groups = std::move(groups);
    }

    /// Leaves corners of one element apart.
    std::vector<std::uint32_t> join() const {
        const Mesh& mesh = m_points.mesh;
        std::vector<std::uint32_t> standsFor(mesh.nodeCount());
        std::iota(standsFor.begin(), standsFor.end(), 0u);
        for (const Group& group : m_groups) {
            for (const std::uint32_t n : group) {
                standsFor[n] = group.front();
            }
        }
        std::vector<bool> flat(mesh.nodeCount(), false);
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            const auto corners = mesh.cornersOf(idAt<ElementIndex>(e));
            for (std::size_t a = 0; a < corners.size(); ++a) {
                for (std::size_t b = 0; b < a; ++b) {
                    if (corners[a] != corners[b] && standsFor[corners[a]] == standsFor[corners[b]]) {
                        flat[standsFor[corners[a]]] = true;
                    }
                }
            }
        }
        for (const Group& group : m_groups) {
            for (const std::uint32_t n : group) {
                if (flat[group.front()]) {
                    standsFor[n] = n;
                }
            }
        }
        return standsFor;
    }

private:
    bool together(const Vec3& a, const Vec3& b) const {
        return !a.allFinite() || !b.allFinite() || (a - b).cwiseAbs().maxCoeff() <= m_tolerance;
    }

    static Vec3 placeOf(const Group& group, const std::vector<Vec3>& places) {
        const auto there = std::find_if(group.begin(), group.end(), [&](std::uint32_t n) { return places[n].allFinite(); });
        return places[there == group.end() ? group.front() : *there];
    }

    const WrittenPoints& m_points;
    double m_tolerance;
    std::vector<Group> m_groups;
    std::int64_t m_parted = 0;
};

void noteTouching(const WrittenPoints& points, Findings& findings) {
    PlaceIndex places(placeTolerance(points.mesh.nodes));
    std::int64_t count = 0;
    std::string example;
    for (std::uint32_t n = 0; n < points.mesh.nodeCount(); ++n) {
        if (places.put(points.mesh.nodes[n], n) != n && count++ == 0) {
            example = "point " + englishInteger(static_cast<std::int64_t>(n) + 1);
        }
    }
    if (count > 0) {
        findings.add(
            {"pieces.touching", "Points lie where others lie and are nodes of their own: what they belong to is not connected", {}},
            {"pieces.touching.remedy",
             "Nothing to do for surfaces in contact and cracks; else write the grid without repeated points.",
             {}},
            example, count);
    }
}

}  // namespace

std::vector<std::uint32_t> doubledPoints(const WrittenPoints& points, const Execution& execution, Findings& findings) {
    const bool pieces = !points.sharedByNumber && severalPieces(points.pieceOfNode);
    const bool cells = !points.numbered && sharesNothing(points.mesh);
    if (!pieces && !cells) {
        if (!points.numbered) {
            noteTouching(points, findings);
        }
        return {};
    }
    PointGroups groups(points);
    groups.find(cells);
    const Message stage{"pieces.points", "Looking for repeated points", {}};
    for (std::size_t k = 0; k < points.states && !groups.empty(); ++k) {
        execution.report(stage, static_cast<double>(k) / static_cast<double>(points.states));
        groups.partAt(points.placesAt(k));
    }
    if (groups.parted() > 0) {
        findings.add({"pieces.parted", "Points at one place part at a later state: they stay nodes of their own", {}},
                     {"pieces.parted.remedy", "Nothing to do for surfaces in contact and cracks.", {}}, {}, groups.parted());
    }
    std::vector<std::uint32_t> standsFor = groups.join();
    std::int64_t joined = 0;
    for (std::size_t n = 0; n < standsFor.size(); ++n) {
        joined += standsFor[n] != n ? 1 : 0;
    }
    if (joined == 0) {
        return {};
    }
    findings.add({"pieces.doubled", "Points that pieces or cells repeat at every state were taken for one node", {}},
                 {"pieces.doubled.remedy", "Nothing to do; surfaces in contact stay apart where nodes have numbers (NODE_ID).", {}},
                 {}, joined);
    return standsFor;
}

}  // namespace rubble::io
