#include <algorithm>
#include <cmath>

#include "widgets/render/pane_geometry.h"
#include "widgets/render/shapes/vertex_cells.h"

namespace rubble::render {
namespace {

constexpr int triesForDetail = 4;
/// A multiple of the faces wanted that is taken; rubble leaves more of them than smooth surfaces do.
constexpr double enoughLeft = 1.5;
constexpr std::size_t facesOfBox = 6;

/// Mean length of the first edge of faces, m; of every so many of them.
template <class Faces, class Length>
double meanEdge(const Faces& faces, Length length) {
    constexpr std::size_t samples = 10000;
    const std::size_t stride = std::max<std::size_t>(1, faces.size() / samples);
    double sum = 0.0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < faces.size(); i += stride) {
        sum += length(faces[i]);
        ++counted;
    }
    return counted > 0 ? sum / static_cast<double>(counted) : 0.0;
}

/// Edge of cells that leave about as many faces as wanted, m; 0 where there are no more than that.
/// @param edge  mean edge of the faces, m
double cellFor(std::size_t faces, double edge) {
    // A surface of n faces with edges a has about n (a / c)^2 corners of cells with edges c.
    const double share = static_cast<double>(faces) / static_cast<double>(PaneGeometry::simplifiedFaces);
    return share > 1.0 ? edge * std::sqrt(share) : 0.0;
}

}  // namespace

void PaneGeometry::setSimplified(bool simplified) {
    m_simplify = simplified;
}

PaneGeometry::Cells PaneGeometry::cellsWanted() const {
    const std::vector<Vec3>& nodes = m_data.fe->mesh().nodes;
    const auto ofStructure = [&](const StructureFaces::Face& face) { return (nodes[face.nodes[1]] - nodes[face.nodes[0]]).norm(); };
    Cells cells;
    cells.structure = cellFor(m_structure->visible(0).size(), meanEdge(m_structure->faces(), ofStructure));
    // Boxes of whole clusters would hide which of their fragments are left.
    if (m_debris && m_filter.empty()) {
        const auto vertices = m_debris->vertices();
        const auto ofDebris = [&](const DebrisGeometry::Face& face) {
            return static_cast<double>((vertices[face.vertices[1]].local - vertices[face.vertices[0]].local).norm());
        };
        cells.debris = cellFor(m_debris->faces().size(), meanEdge(m_debris->faces(), ofDebris));
    }
    return cells;
}

/// Makes the fragments with less detail, in larger cells while that leaves too many faces.
void PaneGeometry::makeCoarse() {
    double& cell = m_cellsWanted->debris;
    for (int tried = 0; tried < triesForDetail; ++tried) {
        m_coarse = std::make_unique<DebrisGeometry>(m_debris->simplified(cell));
        const std::size_t left = m_coarse->faces().size();
        const double share = static_cast<double>(left) / static_cast<double>(simplifiedFaces);
        if (share <= enoughLeft || left <= facesOfBox * m_coarse->groups().size()) {
            return;
        }
        cell *= std::sqrt(share);
    }
}

/// Brings what is drawn to the detail that is wanted. True if that has changed.
bool PaneGeometry::settleDetail() {
    if (m_simplify && !m_cellsWanted) {
        m_cellsWanted = cellsWanted();
    }
    const bool wanted = m_simplify && m_cellsWanted->join();
    const bool changed = wanted != m_cells.join();
    if (changed && wanted && m_cellsWanted->debris > 0.0 && !m_coarse) {
        makeCoarse();
    }
    if (changed) {
        m_cells = wanted ? *m_cellsWanted : Cells();
    }
    // A box is as wide as two cells where it takes the place of a cluster.
    m_status.simplifiedTo = std::max(m_cells.structure, 2.0 * m_cells.debris);
    return changed;
}

/// Settles for each node that is seen the one that is drawn in its place: the first of those seen that lie in its cell now. Nodes
/// at rest would not do, since what lay together may have parted.
void PaneGeometry::joinNodes() {
    std::vector<std::uint32_t> nodes;
    std::vector<Eigen::Vector3f> places;
    m_joined.assign(m_data.fe->mesh().nodeCount(), none);
    for (const std::uint32_t index : m_visible) {
        for (const std::uint32_t node : m_structure->faces()[index].nodes) {
            if (node != StructureFaces::none && m_joined[node] == none) {
                m_joined[node] = node;
                nodes.push_back(node);
                places.push_back(placeOf(node));
            }
        }
    }
    const std::vector<std::uint32_t> first = VertexCells(m_cells.structure).join(places);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        m_joined[nodes[i]] = nodes[first[i]];
    }
}

}  // namespace rubble::render
