#include "io/fe/med/med_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "core/base/error.h"

namespace rubble::io {

namespace {

std::optional<ElementShape> shapeOfMed(int type) {
    switch (type) {
        case 102:
        case 103:
        case 104:
            return ElementShape::Beam;
        case 203:
        case 206:
        case 207:
            return ElementShape::Triangle;
        case 204:
        case 208:
        case 209:
            return ElementShape::Quadrilateral;
        case 304:
        case 310:
            return ElementShape::Tetrahedron;
        case 305:
        case 313:
            return ElementShape::Pyramid;
        case 306:
        case 315:
        case 318:
            return ElementShape::Wedge;
        case 308:
        case 320:
        case 327:
            return ElementShape::Hexahedron;
        default:
            return std::nullopt;
    }
}

// MED counts the corners of a solid's first face the other way round than Exodus II and VTK do.
std::span<const std::uint8_t> orderOf(ElementShape shape) {
    static constexpr std::array<std::uint8_t, 8> hexahedron{0, 3, 2, 1, 4, 7, 6, 5}, plain{0, 1, 2, 3};
    static constexpr std::array<std::uint8_t, 6> wedge{0, 2, 1, 3, 5, 4};
    static constexpr std::array<std::uint8_t, 5> pyramid{0, 3, 2, 1, 4};
    static constexpr std::array<std::uint8_t, 4> tetrahedron{0, 2, 1, 3};
    switch (shape) {
        case ElementShape::Hexahedron:
            return hexahedron;
        case ElementShape::Wedge:
            return wedge;
        case ElementShape::Pyramid:
            return pyramid;
        case ElementShape::Tetrahedron:
            return tetrahedron;
        default:
            return std::span(plain).first(static_cast<std::size_t>(cornerCount(shape)));
    }
}

std::string typeName(int type) {
    static const std::map<int, std::string> names{{1, "POINT1"}, {312, "OCTA12"}, {400, "POLYGON"}, {500, "POLYHEDRON"}};
    const auto found = names.find(type);
    return found == names.end() ? "type " + std::to_string(type) : found->second;
}

/// Finds cells that are a face or an edge of a cell of more dimensions.
class Skin {
public:
    explicit Skin(const MedMesh& mesh) {
        std::size_t cell = 0;
        for (const MedCells& block : mesh.cells) {
            const auto shape = shapeOfMed(block.type);
            const std::size_t width = block.nodes.empty() ? 0 : block.nodes.size() / block.count;
            for (std::size_t c = 0; c < block.count; ++c, ++cell) {
                for (int i = 0; shape && i < cornerCount(*shape); ++i) {
                    m_cells[block.nodes[c * width + static_cast<std::size_t>(i)]].emplace_back(block.type / 100, cell);
                }
            }
        }
    }

    bool covers(int dimension, std::span<const std::int64_t> corners) const {
        const auto first = m_cells.find(corners[0]);
        if (first == m_cells.end()) {
            return false;
        }
        return std::any_of(first->second.begin(), first->second.end(), [&](const auto& candidate) {
            return candidate.first > dimension && std::all_of(corners.begin() + 1, corners.end(), [&](std::int64_t corner) {
                       const auto others = m_cells.find(corner);
                       return others != m_cells.end() &&
                              std::find(others->second.begin(), others->second.end(), candidate) != others->second.end();
                   });
        });
    }

private:
    std::map<std::int64_t, std::vector<std::pair<int, std::size_t>>> m_cells;  // dimension and place, by node
};

/// Takes over one cell after the other.
class ElementTaker {
public:
    ElementTaker(const MedMesh& mesh, const std::string& path, Findings& findings)
        : m_source(mesh), m_path(path), m_findings(findings), m_skin(mesh), m_byNumber(numbered(mesh)) {
        result.mesh.nodes = mesh.nodes;
        result.mesh.nodeIds = mesh.nodeNumbers;
        result.mesh.offsets.push_back(0);
        countKinds();
    }

    void take(const MedCells& block, std::size_t c, std::size_t cell, bool carries, const std::vector<bool>& reached) {
        const auto shape = shapeOfMed(block.type);
        if (!shape) {
            m_findings.add({"med.skipped_cell", "Cells of a type that makes no fragment were left out", {}},
                           {"med.skipped_cell.remedy", "Nothing to do if they are masses, springs or points.", {}},
                           typeName(block.type));
            return;
        }
        // Cells without a shape need no numbers where all others have them.
        const std::int64_t number = m_byNumber ? block.numbers[c] : static_cast<std::int64_t>(cell) + 1;
        const std::size_t width = block.nodes.size() / block.count;
        const auto corners = std::span(block.nodes).subspan(c * width, static_cast<std::size_t>(cornerCount(*shape)));
        requireNodes(corners, number);
        if (!carries && m_skin.covers(block.type / 100, corners)) {
            m_findings.add({"med.skin", "Faces and edges of other elements that carry no results were left out", {}},
                           {"med.skin.remedy",
                            "If they are shells or bars of the structure, let the analysis write a field on them (SIEF_ELGA).",
                            {}},
                           "element " + englishInteger(number));
            return;
        }
        if (!reached.empty() && std::any_of(corners.begin(), corners.end(),
                                            [&](std::int64_t corner) { return !reached[static_cast<std::size_t>(corner - 1)]; })) {
            m_findings.add({"med.outside", "Elements at nodes that the displacement never reaches were left out", {}},
                           {"med.outside.remedy", "Nothing to do if the model does not have them.", {}},
                           "element " + englishInteger(number));
            return;
        }
        add(*shape, corners, number, block.families.empty() ? 0 : block.families[c]);
        result.cell.push_back(static_cast<std::uint32_t>(cell));
    }

    MedElements result;

private:
    static bool numbered(const MedMesh& mesh) {
        std::set<std::int64_t> seen;
        for (const MedCells& block : mesh.cells) {
            if (shapeOfMed(block.type) && block.numbers.empty()) {
                return false;
            }
            for (const std::int64_t number : block.numbers) {
                if (!seen.insert(number).second) {
                    return false;
                }
            }
        }
        return true;
    }

    // A group of bricks and shells makes two parts.
    void countKinds() {
        for (const MedCells& block : m_source.cells) {
            for (std::size_t c = 0; c < block.count && shapeOfMed(block.type); ++c) {
                m_kinds[groupsOf(block.families.empty() ? 0 : block.families[c])].insert(block.type / 100);
            }
        }
    }

    void requireNodes(std::span<const std::int64_t> corners, std::int64_t number) const {
        for (const std::int64_t node : corners) {
            if (node < 1 || static_cast<std::size_t>(node) > m_source.nodes.size()) {
                throw ParseError(
                    {"med.bad_node", "{0}: element {1} uses node {2} of {3}", {m_path, number, node, m_source.nodes.size()}},
                    {"med.unreadable.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
            }
        }
    }

    void add(ElementShape shape, std::span<const std::int64_t> corners, std::int64_t number, std::int64_t family) {
        Mesh& mesh = result.mesh;
        mesh.shapes.push_back(shape);
        mesh.elementIds.push_back(number);
        for (const std::uint8_t place : orderOf(shape)) {
            mesh.corners.push_back(static_cast<std::uint32_t>(corners[place] - 1));
        }
        mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.part.push_back(partOf(family, isSolid(shape) ? 3 : isShell(shape) ? 2 : 1));
    }

    // Families that name the same groups are one.
    std::string groupsOf(std::int64_t family) const {
        std::string name;
        if (const auto groups = m_source.groups.find(family); groups != m_source.groups.end()) {
            for (const std::string& group : groups->second) {
                name += (name.empty() ? "" : " + ") + group;
            }
        }
        return name.empty() ? "no group" : name;
    }

    std::uint32_t partOf(std::int64_t family, int kind) {
        std::string name = groupsOf(family);
        if (m_kinds[name].size() > 1) {
            name += kind == 3 ? "" : kind == 2 ? " shells" : " beams";
        }
        const auto [place, added] = m_parts.try_emplace(name, static_cast<std::uint32_t>(result.mesh.parts.size()));
        if (added) {
            result.mesh.parts.push_back({name, family});
        }
        return place->second;
    }

    const MedMesh& m_source;
    const std::string& m_path;
    Findings& m_findings;
    const Skin m_skin;
    const bool m_byNumber;
    std::map<std::string, std::set<int>> m_kinds;  // dimensions, by groups
    std::map<std::string, std::uint32_t> m_parts;  // by name
};

}  // namespace

std::vector<std::size_t> firstCells(const MedMesh& mesh) {
    std::vector<std::size_t> first{0};
    for (const MedCells& block : mesh.cells) {
        first.push_back(first.back() + block.count);
    }
    return first;
}

MedElements medElements(const MedMesh& mesh, const std::vector<bool>& carries, const std::vector<bool>& reached,
                        const std::string& path, Findings& findings) {
    ElementTaker taker(mesh, path, findings);
    std::size_t cell = 0;
    for (const MedCells& block : mesh.cells) {
        for (std::size_t c = 0; c < block.count; ++c, ++cell) {
            taker.take(block, c, cell, carries[cell], reached);
        }
    }
    return std::move(taker.result);
}

}  // namespace rubble::io
