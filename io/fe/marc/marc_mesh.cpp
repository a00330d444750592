#include "io/fe/marc/marc_mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

#include "core/base/error.h"
#include "io/fe/abaqus/deck_parts.h"
#include "io/fe/marc/marc_file.h"
#include "io/fe/straight_edges.h"

namespace rubble::io {

namespace {

struct MarcType {
    std::int64_t type;
    ElementShape shape;
};

// Element library (Marc Volume B): structural elements in space.
constexpr std::array<MarcType, 33> marcTypes{
    {{7, ElementShape::Hexahedron},      {84, ElementShape::Hexahedron},    {117, ElementShape::Hexahedron},
     {120, ElementShape::Hexahedron},    {21, ElementShape::Hexahedron},    {57, ElementShape::Hexahedron},
     {35, ElementShape::Hexahedron},     {61, ElementShape::Hexahedron},    {149, ElementShape::Hexahedron},
     {185, ElementShape::Hexahedron},    {136, ElementShape::Wedge},        {134, ElementShape::Tetrahedron},
     {157, ElementShape::Tetrahedron},   {127, ElementShape::Tetrahedron},  {130, ElementShape::Tetrahedron},
     {184, ElementShape::Tetrahedron},   {75, ElementShape::Quadrilateral}, {139, ElementShape::Quadrilateral},
     {140, ElementShape::Quadrilateral}, {18, ElementShape::Quadrilateral}, {22, ElementShape::Quadrilateral},
     {72, ElementShape::Quadrilateral},  {30, ElementShape::Quadrilateral}, {138, ElementShape::Triangle},
     {158, ElementShape::Triangle},      {49, ElementShape::Triangle},      {9, ElementShape::Beam},
     {52, ElementShape::Beam},           {98, ElementShape::Beam},          {14, ElementShape::Beam},
     {25, ElementShape::Beam},           {78, ElementShape::Beam},          {79, ElementShape::Beam}}};

std::optional<ElementShape> shapeOf(std::int64_t type) {
    const auto found =
        std::find_if(marcTypes.begin(), marcTypes.end(), [type](const MarcType& known) { return known.type == type; });
    return found == marcTypes.end() ? std::nullopt : std::optional(found->shape);
}

class MarcMeshReader {
public:
    MarcMeshReader(ByteWindow& window, Findings& findings) : m_window(window), m_findings(findings) {}

    Mesh read() {
        std::string line;
        while (m_window.line(line) && !line.starts_with("----") && !line.starts_with("****")) {
            std::int64_t code = 0;
            if (!line.starts_with("=beg=") || !toInteger(column(line, 5, 5), code)) {
                continue;
            }
            if (code == 50200) {
                readCounts();
            } else if (code / 100 == 507) {
                readElements();
            } else if (code / 100 == 508) {
                readNodes();
            } else if (code == 51301) {
                readSets();
            }
        }
        finish();
        return std::move(m_mesh);
    }

private:
    struct Element {
        std::int64_t number;
        ElementShape shape;
        std::vector<std::int64_t> nodes;
    };

    [[noreturn]] void fail(const std::string& what) const {
        throw ParseError(
            {"marc.broken", "{0}: before byte {1}: {2}", {m_window.path(), static_cast<std::int64_t>(m_window.place()), what}},
            {"marc.broken.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
    }

    void readCounts() {
        MarcFields fields(m_window);
        std::int64_t unused = 0;
        if (!fields.integer(unused) || !fields.integer(m_nodes) || !fields.integer(m_elements)) {
            fail("the verification data is not whole");
        }
    }

    void readElements() {
        for (std::int64_t e = 0; e < m_elements; ++e) {
            MarcFields fields(m_window);
            std::int64_t number = 0, type = 0, count = 0;
            if (!fields.integer(number) || !fields.integer(type) || !fields.integer(count) || count < 0 || count > 1000) {
                fail("the connectivity ends after " + std::to_string(e) + " of " + std::to_string(m_elements) + " elements");
            }
            std::vector<std::int64_t> nodes(static_cast<std::size_t>(count));
            for (std::int64_t& node : nodes) {
                if (!fields.integer(node)) {
                    fail("element " + std::to_string(number) + " does not have its " + std::to_string(count) + " nodes");
                }
            }
            const auto shape = shapeOf(type);
            if (shape) {
                m_list.push_back({number, *shape, std::move(nodes)});
            } else {
                m_findings.add({"fe.skipped", "Elements of a type that makes no fragment were left out", {}},
                               {"fe.skipped.remedy", "Nothing to do if they are masses, springs, contacts or rigid surfaces.", {}},
                               "element " + englishInteger(number) + " of type " + std::to_string(type));
            }
        }
    }

    void readNodes() {
        for (std::int64_t n = 0; n < m_nodes; ++n) {
            MarcFields fields(m_window);
            std::int64_t number = 0;
            Vec3 place;
            if (!fields.integer(number) || !fields.real(place.x()) || !fields.real(place.y()) || !fields.real(place.z())) {
                fail("the coordinates end after " + std::to_string(n) + " of " + std::to_string(m_nodes) + " nodes");
            }
            m_mesh.nodeIds.push_back(number);
            m_mesh.nodes.push_back(place);
        }
    }

    void readSets() {
        MarcFields head(m_window);
        std::int64_t sets = 0;
        if (!head.integer(sets)) {
            return;
        }
        for (std::int64_t s = 0; s < sets; ++s) {
            std::string name;
            const std::uint64_t before = m_window.place();
            if (!m_window.line(name) || name.starts_with("=")) {
                m_window.seek(before);
                return;
            }
            MarcFields fields(m_window);
            std::int64_t count = 0, kind = 0;
            if (!fields.integer(count) || !fields.integer(kind) || count < 0 ||
                static_cast<std::uint64_t>(count) > m_window.size() / 2) {
                fail("the set \"" + column(name, 0, 32) + "\" does not say how long it is");
            }
            fields.newLine();
            NamedSet set{column(name, 0, 32), {}};
            for (std::int64_t i = 0; i < count; ++i) {
                std::int64_t member = 0;
                if (!fields.integer(member)) {
                    fail("the set \"" + set.name + "\" ends after " + std::to_string(i) + " of " + std::to_string(count) +
                         " members");
                }
                set.members.push_back(member);
            }
            if (kind == 0) {
                m_sets.push_back(std::move(set));
            }
        }
    }

    void finish() {
        std::unordered_map<std::int64_t, std::uint32_t> places;
        for (std::size_t n = 0; n < m_mesh.nodeIds.size(); ++n) {
            places.emplace(m_mesh.nodeIds[n], static_cast<std::uint32_t>(n));
        }
        m_mesh.offsets.push_back(0);
        StraightEdges straight;
        for (const Element& element : m_list) {
            if (element.shape != ElementShape::Beam) {
                straight.add(element.shape, EdgeOrder::TopBeforeSides, placesOfNodes(element.nodes, places, m_mesh.nodes),
                             "element " + englishInteger(element.number));
            }
            for (std::size_t c = 0; c < static_cast<std::size_t>(cornerCount(element.shape)); ++c) {
                const auto found = c < element.nodes.size() ? places.find(element.nodes[c]) : places.end();
                if (found == places.end()) {
                    fail("element " + std::to_string(element.number) + " uses a node that is not there");
                }
                m_mesh.corners.push_back(found->second);
            }
            m_mesh.elementIds.push_back(element.number);
            m_mesh.shapes.push_back(element.shape);
            m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
        }
        straight.note(m_findings);
        assignParts(nullptr, m_sets, m_mesh, m_findings);
    }

    ByteWindow& m_window;
    Findings& m_findings;
    std::int64_t m_nodes = 0, m_elements = 0;
    std::vector<Element> m_list;
    std::vector<NamedSet> m_sets;
    Mesh m_mesh;
};

}  // namespace

Mesh readMarcMesh(ByteWindow& window, Findings& findings) {
    return MarcMeshReader(window, findings).read();
}

}  // namespace rubble::io
