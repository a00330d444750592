#include "io/fe/abaqus/fil_model.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "core/base/error.h"
#include "io/fe/abaqus/abaqus_elements.h"
#include "io/fe/straight_edges.h"

namespace rubble::io {

namespace {

enum Key {
    nodeSetKey = 1931,
    nodeKey = 1901,
    elementKey = 1900,
    moreNodesKey = 1990,
    freedomsKey = 1902,
    elementSetKey = 1933,
    moreMembersKey = 1934,
    labelKey = 1940
};

class ModelReader {
public:
    ModelReader(const std::string& path, FilRecords& records) : m_path(path), m_records(records) {}

    FilModel read(FilRecord& record) {
        while (m_records.next(record)) {
            if (record.key == filIncrementKey) {
                finish();
                return std::move(m_model);
            }
            take(record);
        }
        record = {};
        finish();
        return std::move(m_model);
    }

private:
    struct Element {
        std::int64_t number;
        ElementShape shape;
        bool quadratic;  // of beams: there is a node between the ends
        std::vector<std::int64_t> nodes;
    };

    void take(const FilRecord& record) {
        switch (record.key) {
            case nodeKey:
                m_model.mesh.nodeIds.push_back(record.integer(0));
                m_model.mesh.nodes.emplace_back(record.real(1), record.real(2), record.size() > 3 ? record.real(3) : 0.0);
                break;
            case elementKey:
                takeElement(record);
                break;
            case moreNodesKey:
                for (std::size_t i = 0; m_last && i < record.size(); ++i) {
                    m_elements.back().nodes.push_back(record.integer(i));
                }
                break;
            case freedomsKey:
                for (std::size_t axis = 0; axis < 3 && axis < record.size(); ++axis) {
                    m_model.freedoms[axis] = static_cast<std::size_t>(std::max<std::int64_t>(record.integer(axis), 0));
                }
                break;
            case elementSetKey:
                m_model.sets.push_back({record.text(0), {}});
                addMembers(record, 1);
                break;
            case moreMembersKey:
                if (!m_model.sets.empty()) {
                    addMembers(record, 0);
                }
                break;
            case labelKey:
                m_labels[record.integer(0)] = record.textFrom(1);
                break;
            default:
                break;
        }
    }

    void takeElement(const FilRecord& record) {
        const std::string type = record.text(1).substr(0, record.text(1).find(' '));
        if (isFlatAbaqus(type)) {
            throw ParseError({"fil.flat", "{0} is a flat analysis: element {1} is of type {2}", {m_path, record.integer(0), type}},
                             {"fil.flat.remedy", "Give a three-dimensional analysis.", {}});
        }
        const auto shape = shapeOfAbaqus(type);
        m_last = shape.has_value();
        if (!shape) {
            m_model.findings.add(
                {"fe.skipped", "Elements of a type that makes no fragment were left out", {}},
                {"fe.skipped.remedy", "Nothing to do if they are masses, springs, contacts or rigid surfaces.", {}},
                "element " + englishInteger(record.integer(0)) + " of type " + type);
            return;
        }
        const bool quadratic = type.starts_with("B32") || type.starts_with("T3D3") || type.starts_with("PIPE32");
        Element& element = m_elements.emplace_back(Element{record.integer(0), *shape, quadratic, {}});
        for (std::size_t i = 2; i < record.size(); ++i) {
            element.nodes.push_back(record.integer(i));
        }
    }

    void addMembers(const FilRecord& record, std::size_t first) {
        for (std::size_t i = first; i < record.size(); ++i) {
            m_model.sets.back().members.push_back(record.integer(i));
        }
    }

    void finish() {
        Mesh& mesh = m_model.mesh;
        std::unordered_map<std::int64_t, std::uint32_t> places;
        for (std::size_t n = 0; n < mesh.nodeIds.size(); ++n) {
            places.emplace(mesh.nodeIds[n], static_cast<std::uint32_t>(n));
        }
        mesh.offsets.push_back(0);
        StraightEdges straight;
        for (Element& element : m_elements) {
            orderBeam(element, places);
            straight.add(element.shape, EdgeOrder::TopBeforeSides, placesOfNodes(element.nodes, places, mesh.nodes),
                         "element " + englishInteger(element.number));
            const auto corners = static_cast<std::size_t>(cornerCount(element.shape));
            for (std::size_t c = 0; c < corners; ++c) {
                const auto found = c < element.nodes.size() ? places.find(element.nodes[c]) : places.end();
                if (found == places.end()) {
                    throw ParseError(
                        {"fil.bad_node",
                         "{0}: element {1} uses the node {2}, which is not there",
                         {m_path, element.number, c < element.nodes.size() ? element.nodes[c] : std::int64_t{0}}},
                        {"fil.broken.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
                }
                mesh.corners.push_back(found->second);
            }
            mesh.elementIds.push_back(element.number);
            mesh.shapes.push_back(element.shape);
            mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        }
        straight.note(m_model.findings);
        for (NamedSet& set : m_model.sets) {
            nameSet(set);
        }
    }

    // Quadratic beams and trusses have the node between the ends second; a further one gives a direction.
    void orderBeam(Element& element, const std::unordered_map<std::int64_t, std::uint32_t>& places) const {
        if (element.shape != ElementShape::Beam) {
            return;
        }
        element.nodes.resize(std::min<std::size_t>(element.nodes.size(), element.quadratic ? 3 : 2));
        const std::vector<Vec3> at = placesOfNodes(element.nodes, places, m_model.mesh.nodes);
        if (at.size() == 3 && std::all_of(at.begin(), at.end(), [](const Vec3& place) { return place.allFinite(); })) {
            std::array<std::int64_t, 3> nodes{element.nodes[0], element.nodes[1], element.nodes[2]};
            putMiddleLast(nodes, {at[0], at[1], at[2]});
            element.nodes.assign(nodes.begin(), nodes.end());
        }
    }

    // Names of more than eight letters stand as a number, whose label comes later.
    void nameSet(NamedSet& set) const {
        std::string name = set.name;
        name.erase(0, name.find_first_not_of(' ') == std::string::npos ? name.size() : name.find_first_not_of(' '));
        name.erase(name.find_last_not_of(' ') + 1);
        const bool number = !name.empty() && name.size() < 9 && name.find_first_not_of("0123456789") == std::string::npos;
        const auto label = number ? m_labels.find(std::stoll(name)) : m_labels.end();
        set.name = label != m_labels.end() && !label->second.empty() ? label->second : name.empty() ? "set" : name;
    }

    const std::string& m_path;
    FilRecords& m_records;
    FilModel m_model;
    std::vector<Element> m_elements;
    bool m_last = false;  // the newest element was kept
    std::map<std::int64_t, std::string> m_labels;
};

}  // namespace

FilModel readFilModel(const std::string& path, FilRecords& records, FilRecord& record) {
    return ModelReader(path, records).read(record);
}

}  // namespace rubble::io
