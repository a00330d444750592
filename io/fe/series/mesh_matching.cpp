#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/fe/components.h"
#include "io/fe/series/mesh_union.h"

namespace rubble::io {

namespace {

// Nodes that tell whether the points of a mesh keep their places at all.
constexpr std::size_t sampleSize = 1000;
// A node that is split off leaves an element as large as it was; a halved element is another one.
constexpr double leastOfVolume = 0.55, mostOfVolume = 1.8;

double volumeOf(const Mesh& mesh, ElementShape shape, std::span<const std::uint32_t> corners) {
    std::vector<Vec3> places;
    for (const std::uint32_t corner : corners) {
        places.push_back(mesh.nodes[corner]);
    }
    return std::abs(elementVolume(shape, places, 1.0));
}

}  // namespace

std::vector<std::uint32_t> MeshUnion::nodesByHint(const Mesh& mesh) const {
    std::vector<std::uint32_t> nodes(mesh.nodeCount(), none);
    const bool numbered = m_nodesNumbered && !mesh.nodeIds.empty();
    const bool counted = !numbered && mesh.nodeCount() == m_mesh.nodeCount();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (counted) {
            nodes[n] = static_cast<std::uint32_t>(n);
        } else if (numbered) {
            const auto found = m_nodes.find(mesh.nodeIds[n]);
            nodes[n] = found == m_nodes.end() ? none : found->second;
        }
    }
    return nodes;
}

void MeshUnion::indexPlaces() {
    if (!m_places) {
        m_places.emplace(placeTolerance(m_mesh.nodes));
    }
    while (m_placeOf.size() < m_mesh.nodeCount()) {
        const auto node = static_cast<std::uint32_t>(m_placeOf.size());
        m_placeOf.push_back(m_places->put(m_mesh.nodes[node], node));
    }
}

// Without numbers only the places can say which points are left, and only where all keep theirs. Of a state without points
// nothing is left.
void MeshUnion::requirePlaces(const Mesh& mesh, std::size_t state) {
    const bool placed =
        std::all_of(mesh.nodes.begin(), mesh.nodes.end(), [&](const Vec3& place) { return m_places->find(place) != none; });
    const bool kept = placed && (m_timed || mesh.nodes.empty());
    if (!kept && !m_timed) {
        throw ParseError({"fe.other_points",
                          "{0}: state {1} has {2} nodes instead of {3}, and neither numbers nor times that make it a later state",
                          {m_path, state, mesh.nodeCount(), m_mesh.nodeCount()}},
                         {"fe.other_points.remedy", "Set only_this_file=true, or give a .pvd or .series file with the times.", {}});
    }
    if (!kept) {
        throw ParseError({"fe.unnumbered_nodes",
                          "{0}: state {1} has {2} nodes instead of {3}, and no numbers that say which",
                          {m_path, state, mesh.nodeCount(), m_mesh.nodeCount()}},
                         {"fe.unnumbered_nodes.remedy",
                          "Write the series with node numbers (point data NODE_ID or GlobalNodeId), or keep all points.",
                          {}});
    }
}

// True where the points keep their places and the hints say otherwise.
bool MeshUnion::hintsRefuted(const Mesh& mesh, const std::vector<std::uint32_t>& hints, std::size_t state) {
    const bool numbered = m_nodesNumbered && !mesh.nodeIds.empty();
    if (!numbered && mesh.nodeCount() != m_mesh.nodeCount()) {
        indexPlaces();
        requirePlaces(mesh, state);
        return true;
    }
    const double tolerance = m_places ? m_places->tolerance() : placeTolerance(m_mesh.nodes);
    std::vector<bool> kept(m_mesh.nodeCount(), false);
    std::vector<std::size_t> others;
    for (std::size_t n = 0; n < hints.size(); ++n) {
        if (hints[n] != none && (m_mesh.nodes[hints[n]] - mesh.nodes[n]).cwiseAbs().maxCoeff() <= tolerance) {
            kept[hints[n]] = true;
        } else {
            others.push_back(n);
        }
    }
    if (others.empty()) {
        return false;
    }
    indexPlaces();
    if (others.size() > sampleSize && 2 * others.size() > hints.size()) {
        std::size_t found = 0;
        const std::size_t stride = others.size() / sampleSize;
        for (std::size_t i = 0; i < sampleSize; ++i) {
            found += m_places->find(mesh.nodes[others[i * stride]]) != none ? 1 : 0;
        }
        if (2 * found < sampleSize) {
            return false;
        }
    }
    const std::size_t elsewhere = countElsewhere(mesh, others, kept);
    const bool refuted = elsewhere > 0 && 2 * (hints.size() - others.size() + elsewhere) > hints.size();
    if (refuted) {
        m_findings.add(
            {"fe.renumbered_nodes", "Nodes have other numbers than before: they were told apart by their places", {}},
            {"fe.renumbered.remedy", "Let the analysis keep its numbers (libMesh, MOOSE: allow_renumbering = false).", {}},
            "state " + englishInteger(static_cast<std::int64_t>(state)), static_cast<std::int64_t>(elsewhere));
    }
    return refuted;
}

// Of these nodes, how many lie where a node was that no other takes.
std::size_t MeshUnion::countElsewhere(const Mesh& mesh, const std::vector<std::size_t>& nodes,
                                      const std::vector<bool>& kept) const {
    std::vector<std::int64_t> free(m_mesh.nodeCount(), 0);
    for (std::size_t u = 0; u < kept.size(); ++u) {
        free[m_placeOf[u]] += kept[u] ? 0 : 1;
    }
    std::size_t elsewhere = 0;
    for (const std::size_t n : nodes) {
        const std::uint32_t place = m_places->find(mesh.nodes[n]);
        if (place != none && free[place] > 0) {
            --free[place];
            ++elsewhere;
        }
    }
    return elsewhere;
}

MeshUnion::Tuple MeshUnion::sortedCorners(std::uint32_t element, bool places) const {
    const auto corners = m_mesh.cornersOf(idAt<ElementIndex>(element));
    Tuple tuple(corners.begin(), corners.end());
    for (std::uint32_t& corner : tuple) {
        corner = places ? m_placeOf[corner] : corner;
    }
    std::sort(tuple.begin(), tuple.end());
    return tuple;
}

const std::map<MeshUnion::Tuple, MeshUnion::Twins>& MeshUnion::sorted(bool places) {
    const std::size_t table = places ? 1 : 0;
    for (std::size_t& done = m_sortedDone[table]; done < m_mesh.elementCount(); ++done) {
        const auto element = static_cast<std::uint32_t>(done);
        m_sorted[table][sortedCorners(element, places)].push_back(element);
    }
    return m_sorted[table];
}

// By number where its nodes agree, else by the nodes alone.
void MeshUnion::matchByNodes(const Mesh& mesh, std::size_t state, std::size_t nodesBefore, const MeshEpoch& epoch,
                             std::vector<std::uint32_t>& elements) {
    std::vector<bool> taken(m_mesh.elementCount(), false);
    const auto take = [&](std::size_t e, std::uint32_t element) {
        elements[e] = element;
        taken[element] = true;
    };
    std::vector<std::size_t> open;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const std::uint32_t known = elementByNumber(mesh, e);
        Tuple key = cornersIn(mesh, e, epoch);
        std::sort(key.begin(), key.end());
        if (known != none && !taken[known] && m_mesh.shapes[known] == mesh.shapes[e] && sortedCorners(known, false) == key) {
            take(e, known);
        } else {
            open.push_back(e);
        }
    }
    for (const std::size_t e : open) {
        Tuple key = cornersIn(mesh, e, epoch);
        std::sort(key.begin(), key.end());
        const auto& table = sorted(false);
        const auto twins = table.find(key);
        const auto free = twins == table.end() ? Twins::const_iterator()
                                               : std::find_if(twins->second.begin(), twins->second.end(), [&](std::uint32_t twin) {
                                                     return !taken[twin] && m_mesh.shapes[twin] == mesh.shapes[e];
                                                 });
        if (twins != table.end() && free != twins->second.end()) {
            if (elementByNumber(mesh, e) != none || (m_byNumber && !mesh.elementIds.empty())) {
                noteRenumbered(mesh, e, *free);
            }
            take(e, *free);
        } else if (twins != table.end() && !m_byNumber) {
            throw ParseError(
                {"fe.element_twice", "{0}: two elements of state {1} cannot be told apart (entry {2})", {m_path, state, e}},
                {"fe.element_twice.remedy", "Write the series with a unique number for every element.", {}});
        }
    }
    for (const std::size_t e : open) {
        const std::uint32_t known = elements[e] == none ? elementByNumber(mesh, e) : none;
        if (known != none && !taken[known] && hasSplit(mesh, e, cornersIn(mesh, e, epoch), known, nodesBefore)) {
            take(e, known);
            m_findings.add({"fe.split_nodes", "Elements keep their numbers where nodes are split: they keep their first nodes", {}},
                           {"fe.split_nodes.remedy", "Nothing to do: the gap that opens is not shown.", {}},
                           "element " + englishInteger(mesh.elementIds[e]));
        }
    }
    noteReused(mesh, state, elements);
}

bool MeshUnion::hasSplit(const Mesh& mesh, std::size_t e, const Tuple& corners, std::uint32_t known,
                         std::size_t nodesBefore) const {
    const auto before = m_mesh.cornersOf(idAt<ElementIndex>(known));
    if (m_mesh.shapes[known] != mesh.shapes[e] || before.size() != corners.size()) {
        return false;
    }
    std::size_t stayed = 0;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        if (corners[c] == before[c]) {
            ++stayed;
        } else if (corners[c] < nodesBefore) {
            return false;
        }
    }
    const double was = volumeOf(m_mesh, m_mesh.shapes[known], before);
    const double is = volumeOf(mesh, mesh.shapes[e], mesh.cornersOf(idAt<ElementIndex>(e)));
    return stayed > 0 && is > leastOfVolume * was && is < mostOfVolume * was;
}

void MeshUnion::noteRenumbered(const Mesh& mesh, std::size_t e, std::uint32_t element) {
    m_renumbered = true;
    m_findings.add({"fe.renumbered", "Elements have other numbers than before: they were told apart by their nodes", {}},
                   {"fe.renumbered.remedy", "Let the analysis keep its numbers (libMesh, MOOSE: allow_renumbering = false).", {}},
                   "element " + englishInteger(elementNumber(element)) + " is " + englishInteger(mesh.elementIds[e]) + " later");
}

// A known number with nodes that nobody had: a new element, unless nearly all are, whom nobody can tell from those before.
void MeshUnion::noteReused(const Mesh& mesh, std::size_t state, const std::vector<std::uint32_t>& elements) {
    std::size_t reused = 0, example = 0;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (elements[e] == none && elementByNumber(mesh, e) != none) {
            example = reused++ == 0 ? e : example;
        }
    }
    if (reused == 0) {
        return;
    }
    m_renumbered = true;
    if (2 * reused > elements.size()) {
        throw ParseError(
            {m_timed ? "fe.other_elements" : "fe.other_points",
             "{0}: at state {1}, {2} of {3} elements have other nodes than the elements of their numbers had before",
             {m_path, state, reused, elements.size()}},
            {"fe.other_elements.remedy",
             "Let the analysis keep the numbers of nodes and elements (libMesh, MOOSE: allow_renumbering = false), or write "
             "the points at rest with a displacement.",
             {}});
    }
    m_findings.add({"fe.number_reused", "Numbers of elements stand for elements at other nodes: these count as new", {}},
                   {"fe.renumbered.remedy", "Let the analysis keep its numbers (libMesh, MOOSE: allow_renumbering = false).", {}},
                   "element " + englishInteger(mesh.elementIds[example]), static_cast<std::int64_t>(reused));
}

// By the places of their corners; a number decides between several at one place.
void MeshUnion::matchByPlaces(const Mesh& mesh, MeshEpoch& epoch, std::vector<std::uint32_t>& elements) {
    std::vector<std::uint32_t> places(mesh.nodeCount());
    std::transform(mesh.nodes.begin(), mesh.nodes.end(), places.begin(), [&](const Vec3& place) { return m_places->find(place); });
    const auto& table = sorted(true);
    std::vector<bool> taken(m_mesh.elementCount(), false);
    for (const bool byNumber : {true, false}) {
        for (std::size_t e = 0; e < elements.size(); ++e) {
            Tuple key;
            for (const std::uint32_t corner : mesh.cornersOf(idAt<ElementIndex>(e))) {
                key.push_back(places[corner]);
            }
            std::sort(key.begin(), key.end());
            const auto twins = elements[e] == none ? table.find(key) : table.end();
            const std::uint32_t known = elementByNumber(mesh, e);
            for (std::size_t t = 0; twins != table.end() && t < twins->second.size() && elements[e] == none; ++t) {
                const std::uint32_t twin = twins->second[t];
                if (!taken[twin] && m_mesh.shapes[twin] == mesh.shapes[e] && (!byNumber || twin == known)) {
                    elements[e] = twin;
                    taken[twin] = true;
                }
            }
            if (!byNumber && elements[e] != none && m_byNumber && !mesh.elementIds.empty() && elements[e] != known) {
                noteRenumbered(mesh, e, elements[e]);
            }
        }
    }
    matchNodesAtPlaces(mesh, elements, places, epoch);
}

// Nodes of known elements are theirs; others at a place are taken in their order.
void MeshUnion::matchNodesAtPlaces(const Mesh& mesh, const std::vector<std::uint32_t>& elements,
                                   const std::vector<std::uint32_t>& places, MeshEpoch& epoch) const {
    std::fill(epoch.nodes.begin(), epoch.nodes.end(), none);
    std::vector<bool> taken(m_mesh.nodeCount(), false);
    const auto take = [&](std::size_t n, std::uint32_t node) {
        epoch.nodes[n] = node;
        taken[node] = true;
    };
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (elements[e] == none) {
            continue;
        }
        for (const std::uint32_t n : mesh.cornersOf(idAt<ElementIndex>(e))) {
            for (const std::uint32_t node : m_mesh.cornersOf(idAt<ElementIndex>(elements[e]))) {
                if (epoch.nodes[n] == none && !taken[node] && m_placeOf[node] == places[n]) {
                    take(n, node);
                }
            }
        }
    }
    std::unordered_map<std::uint32_t, Twins> atPlace;
    for (std::uint32_t node = 0; node < m_mesh.nodeCount(); ++node) {
        if (!taken[node]) {
            atPlace[m_placeOf[node]].push_back(node);
        }
    }
    const bool numbered = m_nodesNumbered && !mesh.nodeIds.empty();
    std::unordered_map<std::int64_t, std::uint32_t> byNumber;
    for (std::size_t n = 0; numbered && n < mesh.nodeCount(); ++n) {
        if (epoch.nodes[n] != none) {
            byNumber.emplace(mesh.nodeIds[n], epoch.nodes[n]);
        }
    }
    for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
        if (epoch.nodes[n] != none || places[n] == none) {
            continue;
        }
        const auto shared = numbered ? byNumber.find(mesh.nodeIds[n]) : byNumber.end();
        const auto free = atPlace.find(places[n]);
        if (shared != byNumber.end()) {
            epoch.nodes[n] = shared->second;
        } else if (free != atPlace.end() && !free->second.empty()) {
            take(n, free->second.front());
            free->second.erase(free->second.begin());
            if (numbered) {
                byNumber.emplace(mesh.nodeIds[n], epoch.nodes[n]);
            }
        }
    }
}

}  // namespace rubble::io
