#include "io/fe/pieces/duplicate_cells.h"

#include <algorithm>
#include <map>

#include "io/fe/pieces/place_index.h"

namespace rubble::io {

namespace {

using Key = std::vector<std::uint32_t>;

// Piece of each element or node.
std::vector<std::uint32_t> pieceOf(const std::vector<MeshPiece>& pieces, std::size_t count, std::size_t MeshPiece::* end) {
    std::vector<std::uint32_t> piece(count);
    std::uint32_t p = 0;
    for (std::size_t i = 0; i < count; ++i) {
        while (p + 1 < pieces.size() && i >= pieces[p].*end) {
            ++p;
        }
        piece[i] = p;
    }
    return piece;
}

template <class T>
void removeMarked(std::vector<T>& values, const std::vector<bool>& marked) {
    if (values.size() != marked.size()) {
        return;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (!marked[i]) {
            values[kept++] = values[i];
        }
    }
    values.resize(kept);
}

Mesh without(const Mesh& mesh, const std::vector<bool>& left) {
    Mesh rest = mesh;
    rest.corners.clear();
    rest.offsets = {0};
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        if (!left[e]) {
            const auto corners = mesh.cornersOf(idAt<ElementIndex>(e));
            rest.corners.insert(rest.corners.end(), corners.begin(), corners.end());
            rest.offsets.push_back(static_cast<std::uint32_t>(rest.corners.size()));
        }
    }
    removeMarked(rest.shapes, left);
    removeMarked(rest.part, left);
    removeMarked(rest.elementIds, left);
    removeMarked(rest.density, left);
    removeMarked(rest.section, left);
    return rest;
}

}  // namespace

void DuplicateCells::leaveOut(SeriesStep& step, Findings& findings) {
    if (step.mesh) {
        m_left = step.pieces.size() > 1 ? find(step, findings) : std::vector<bool>{};
        if (!m_left.empty()) {
            step.mesh = without(*step.mesh, m_left);
            removeMarked(step.cells, m_left);
        }
    }
    if (!m_left.empty()) {
        removeMarked(step.flags, m_left);
    }
}

// Only elements whose corners all lie where several pieces have nodes can be copies.
std::vector<bool> DuplicateCells::find(const SeriesStep& step, Findings& findings) {
    const Mesh& mesh = *step.mesh;
    PlaceIndex places(placeTolerance(mesh.nodes));
    const auto pieceOfNode = pieceOf(step.pieces, mesh.nodeCount(), &MeshPiece::nodes);
    const auto pieceOfElement = pieceOf(step.pieces, mesh.elementCount(), &MeshPiece::elements);
    std::vector<std::uint32_t> placeOf(mesh.nodeCount());
    std::vector<bool> shared(mesh.nodeCount(), false);
    for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
        placeOf[n] = places.put(mesh.nodes[n], static_cast<std::uint32_t>(n));
        if (pieceOfNode[placeOf[n]] != pieceOfNode[n]) {
            shared[placeOf[n]] = true;
        }
    }
    std::map<Key, std::vector<std::uint32_t>> atPlaces;
    std::int64_t alone = 0;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        Key key;
        for (const std::uint32_t corner : mesh.cornersOf(idAt<ElementIndex>(e))) {
            key.push_back(placeOf[corner]);
        }
        if (std::all_of(key.begin(), key.end(), [&](std::uint32_t place) { return shared[place]; })) {
            std::sort(key.begin(), key.end());
            key.push_back(static_cast<std::uint32_t>(mesh.shapes[e]));
            atPlaces[key].push_back(static_cast<std::uint32_t>(e));
        } else {
            alone += e < step.ghosts.size() && step.ghosts[e] ? 1 : 0;
        }
    }
    std::vector<bool> left(mesh.elementCount(), false);
    std::int64_t count = 0;
    const auto isGhost = [&](std::uint32_t e) { return e < step.ghosts.size() && step.ghosts[e]; };
    for (const auto& [key, elements] : atPlaces) {
        const auto own = std::find_if_not(elements.begin(), elements.end(), isGhost);
        const std::uint32_t kept = own == elements.end() ? elements.front() : *own;
        for (const std::uint32_t e : elements) {
            const bool sameNumber = mesh.elementIds.empty() ? isSolid(mesh.shapes[e]) : mesh.elementIds[e] == mesh.elementIds[kept];
            left[e] = e != kept && pieceOfElement[e] != pieceOfElement[kept] && (isGhost(e) || sameNumber);
            count += left[e] ? 1 : 0;
        }
    }
    if (alone > 0 && !m_noted) {
        findings.add(
            {"pieces.ghost_alone", "Elements are marked as copies of another piece that does not hold them: they were kept", {}},
            {"pieces.ghost_alone.remedy", "Check that all pieces of the result are there.", {}}, {}, alone);
    }
    if (count > 0 && !m_noted) {
        findings.add({"pieces.duplicates", "Elements that several pieces hold were taken once", {}},
                     {"pieces.duplicates.remedy", "Nothing to do: pieces overlap by a layer of copies (ghosts).", {}}, {}, count);
    }
    m_noted = true;
    return count > 0 ? left : std::vector<bool>{};
}

}  // namespace rubble::io
