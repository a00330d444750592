#include "io/site/meshes/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/base/file_words.h"
#include "io/site/meshes/gltf_extensions.h"
#include "io/site/meshes/gltf_file.h"

namespace rubble::io {

namespace {

using Place = Eigen::Transform<double, 3, Eigen::Affine>;

std::vector<double> listIn(const JsonCursor& list, std::size_t count) {
    std::vector<double> numbers;
    for (const JsonCursor& entry : list.elements()) {
        numbers.push_back(entry.number());
    }
    if (numbers.size() != count) {
        list.fail("a list of " + std::to_string(count) + " numbers");
    }
    return numbers;
}

/// Where a node puts what hangs on it, seen from its parent.
Place placeOf(const JsonCursor& node) {
    Place place = Place::Identity();
    if (node.has("matrix")) {
        const std::vector<double> m = listIn(node["matrix"], 16);
        place.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
        place.makeAffine();
        return place;
    }
    if (node.has("translation")) {
        const std::vector<double> by = listIn(node["translation"], 3);
        place.translate(Vec3(by[0], by[1], by[2]));
    }
    if (node.has("rotation")) {
        const std::vector<double> q = listIn(node["rotation"], 4);
        const Eigen::Quaterniond turn(q[3], q[0], q[1], q[2]);
        if (!(turn.norm() > 1e-6)) {
            node["rotation"].fail("a quaternion of length 1");
        }
        place.rotate(turn.normalized());
    }
    if (node.has("scale")) {
        const std::vector<double> by = listIn(node["scale"], 3);
        place.scale(Vec3(by[0], by[1], by[2]));
    }
    return place;
}

/// Reads one file.
class GltfReading {
public:
    GltfReading(const std::string& path, const Execution& execution)
        : m_path(path), m_execution(execution), m_file(path), m_gathering(m_path) {}

    RawMesh read() {
        refuseUnknown();
        for (const JsonCursor& root : roots()) {
            readNode(root, Place::Identity());
        }
        RawMesh mesh = std::move(m_gathering).finish(m_execution);
        mesh.findings.append(m_findings);
        return mesh;
    }

private:
    /// The nodes that stand by themselves: of the scene that is shown, or of a file without scenes all that hang on no other.
    std::vector<JsonCursor> roots() {
        const JsonCursor top = m_file.top();
        if (top.has("scenes")) {
            m_numbers.assign(1, 0);
            const JsonCursor first(m_numbers.front(), m_path, "/scene");
            const JsonCursor shown = m_file.entry("scenes", top.has("scene") ? top["scene"] : first);
            return shown.has("nodes") ? shown["nodes"].elements() : std::vector<JsonCursor>();
        }
        const std::vector<JsonCursor> nodes = top.has("nodes") ? top["nodes"].elements() : std::vector<JsonCursor>();
        std::vector<bool> hangs(nodes.size(), false);
        for (const JsonCursor& node : nodes) {
            for (const JsonCursor& child : node.has("children") ? node["children"].elements() : std::vector<JsonCursor>()) {
                m_file.entry("nodes", child);
                hangs[static_cast<std::size_t>(child.integer())] = true;
            }
        }
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            if (!hangs[n]) {
                m_numbers.emplace_back(n);
            }
        }
        std::vector<JsonCursor> list;
        for (const nlohmann::json& number : m_numbers) {
            list.emplace_back(number, m_path, "/nodes");
        }
        return list;
    }

    /// The extensions of a list of the document that may change the shape, in one text.
    std::string unknownOf(std::string_view list) const {
        std::string names;
        if (m_file.top().has(list)) {
            for (const JsonCursor& extension : m_file.top()[list].elements()) {
                const std::string name = extension.text();
                if (gltfExtension(name) == GltfExtension::Unknown) {
                    names += (names.empty() ? "" : ", ") + name;
                }
            }
        }
        return names;
    }

    void refuseUnknown() {
        if (const std::string required = unknownOf("extensionsRequired"); !required.empty()) {
            refuseContent(
                {"surroundings.gltf_extension", "{0} requires extensions of glTF that are not known: {1}", {m_path, required}},
                "Export the mesh without them, for example uncompressed and without instances.");
        }
        if (const std::string used = unknownOf("extensionsUsed"); !used.empty()) {
            addFinding(m_findings, m_path,
                       {"surroundings.gltf_left_out",
                        "the mesh uses extensions of glTF that are not known and were left out: {0}",
                        {used}},
                       "make sure that shape and place are right without them, or export the mesh anew without them");
        }
    }

    void readNode(const JsonCursor& index, const Place& above) {
        const JsonCursor node = m_file.entry("nodes", index);
        const auto number = static_cast<std::size_t>(index.integer());
        m_seen.resize(m_file.top()["nodes"].value().size(), false);
        if (m_seen[number]) {
            index.refuse("this node hangs in two places", "Export the mesh anew.");
        }
        m_seen[number] = true;
        constexpr int depthMax = 1000;
        if (++m_depth > depthMax) {
            index.refuse("nodes hang too deep below each other", "Export the mesh anew.");
        }
        const Place place = above * placeOf(node);
        if (node.has("mesh")) {
            if (node.has("skin")) {
                addFinding(m_findings, m_path, {"surroundings.gltf_skin", "a mesh follows a skeleton, which was left out", {}},
                           "apply the pose of the skeleton before the mesh is exported");
            }
            readMesh(m_file.entry("meshes", node["mesh"]), place);
        }
        if (node.has("children")) {
            for (const JsonCursor& child : node["children"].elements()) {
                readNode(child, place);
            }
        }
        --m_depth;
    }

    void readMesh(const JsonCursor& mesh, const Place& place) {
        for (const JsonCursor& primitive : mesh["primitives"].elements()) {
            m_execution.check();
            if (primitive.has("targets")) {
                addFinding(m_findings, m_path, {"surroundings.gltf_morph", "a mesh has morph targets, which were left out", {}},
                           "apply them before the mesh is exported");
            }
            readPrimitive(primitive, place);
        }
    }

    void readPrimitive(const JsonCursor& primitive, const Place& place) {
        constexpr int triangles = 4, strip = 5, fan = 6;
        const std::int64_t mode = primitive.has("mode") ? primitive["mode"].integer() : triangles;
        if (mode < 0 || mode > fan) {
            primitive["mode"].fail("a number from 0 to 6");
        }
        if (mode < triangles || !primitive["attributes"].has("POSITION")) {
            m_gathering.leaveOut(1);
            return;
        }
        const std::size_t first = m_gathering.points();
        const std::size_t count = addPoints(primitive["attributes"]["POSITION"], place);
        std::vector<double> order;
        if (primitive.has("indices")) {
            order = m_file.numbers(primitive["indices"]).values;
        }
        const std::size_t corners = primitive.has("indices") ? order.size() : count;
        // An index beyond the points of its own primitive names none of another.
        const auto corner = [&](std::size_t k) {
            const double at = order.empty() ? static_cast<double>(k) : order[k];
            return at >= 0.0 && at < static_cast<double>(count) ? static_cast<std::int64_t>(first + static_cast<std::size_t>(at))
                                                                : std::int64_t{-1};
        };
        const std::size_t step = mode == triangles ? 3 : 1;
        for (std::size_t k = 0; k + 3 <= corners; k += step) {
            const bool turned = mode == strip && k % 2 == 1;
            const std::size_t one = mode == fan ? 0 : k + (turned ? 1 : 0);
            const std::size_t two = mode == fan ? k + 1 : k + (turned ? 0 : 1);
            const std::array<std::int64_t, 3> face{corner(one), corner(two), corner(k + 2)};
            m_gathering.addFace(face);
        }
        if (mode == triangles && corners % 3 != 0) {
            m_gathering.leaveOut(1);
        }
    }

    /// @return how many
    std::size_t addPoints(const JsonCursor& index, const Place& place) {
        const GltfFile::Numbers positions = m_file.numbers(index);
        if (positions.width != 3) {
            index.fail("positions of three numbers");
        }
        double largest = 0.0;
        for (std::size_t k = 0; k + 3 <= positions.values.size(); k += 3) {
            const Vec3 own(positions.values[k], positions.values[k + 1], positions.values[k + 2]);
            const Vec3 at = place * own;
            m_gathering.addPoint(Vec3(at.x(), -at.z(), at.y()));
            largest = std::max(largest, own.cwiseAbs().maxCoeff());
        }
        if (positions.single) {
            m_gathering.noteStep(stepOfFloat(largest * place.linear().colwise().norm().maxCoeff()));
        }
        return positions.values.size() / 3;
    }

    const std::string& m_path;
    const Execution& m_execution;
    GltfFile m_file;
    MeshGathering m_gathering;
    Findings m_findings;
    std::vector<nlohmann::json> m_numbers;  ///< of nodes that no scene names
    std::vector<bool> m_seen;
    int m_depth = 0;
};

}  // namespace

RawMesh readGltfMesh(const std::string& path, const Execution& execution) {
    return GltfReading(path, execution).read();
}

}  // namespace rubble::io
