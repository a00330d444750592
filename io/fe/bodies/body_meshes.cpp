#include "io/fe/bodies/body_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "io/base/delimited_table.h"
#include "io/base/file_words.h"
#include "io/fe/bodies/body_columns.h"
#include "io/fe/meshes/raw_mesh_file.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t tableBytesMax = std::uintmax_t{256} << 20;
/// Share of its hull that a mesh fills at least to be taken as convex.
constexpr double convexShare = 0.98;
/// Of the size of a body, by which points may lie outside of its hull without a word.
constexpr double leftOutShare = 1e-3;

/// m3, of a mesh without a hole, whichever way its triangles turn; nothing for one that is not closed.
std::optional<double> closedVolume(const RawMesh& mesh) {
    std::map<std::array<double, 3>, std::uint32_t> places;
    std::vector<std::uint32_t> of;
    for (const Vec3& p : mesh.points) {
        of.push_back(places.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::uint32_t>(places.size())).first->second);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;  // ways along it less ways back
    const Vec3 origin = mesh.points.front();
    double volume = 0.0;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = of[triangle[k]], b = of[triangle[(k + 1) % 3]];
            edges[std::minmax(a, b)] += a < b ? 1 : -1;
        }
        const Vec3 p = mesh.points[triangle[0]] - origin, q = mesh.points[triangle[1]] - origin,
                   r = mesh.points[triangle[2]] - origin;
        volume += p.dot(q.cross(r)) / 6.0;
    }
    const bool closed = std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
    return closed ? std::optional(std::abs(volume)) : std::nullopt;
}

}  // namespace

std::string bodyMeshPath(const std::string& table, const std::string& name) {
    return (fs::path(table).parent_path() / name).lexically_normal().string();
}

std::shared_ptr<const ConvexBody> BodyMeshes::shape(const std::string& name, std::size_t line) {
    const std::string path = bodyMeshPath(m_table, name);
    if (const auto known = m_shapes.find(path); known != m_shapes.end()) {
        return known->second;
    }
    std::error_code ignored;
    if (!isMeshPath(path) || !fs::is_regular_file(path, ignored)) {
        refuseContent(
            {"bodies.no_mesh", "{0}: line {1} names the mesh {2}, which is no STL, OBJ or PLY there", {m_table, line, path}},
            "Give the name of such a file as seen from the folder of the table, or leave the field empty for a box.");
    }
    const RawMesh mesh = readTriangleMesh(path, Execution());
    if (mesh.triangles.size() > bodyTrianglesMax) {
        refuseContent({"bodies.mesh_large",
                       "{0}: line {1} names the mesh {2} of {3} triangles; a body may have {4}",
                       {m_table, line, path, mesh.triangles.size(), bodyTrianglesMax}},
                      "Make it simpler: only its hull of at most 32 corners is simulated.");
    }
    std::vector<Vec3> used;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            used.push_back(mesh.points[corner]);
        }
    }
    std::optional<ConvexBody> hull = convexBodyOf(used);
    if (!hull) {
        refuseContent({"bodies.mesh_flat", "{0}: line {1} names the mesh {2}, which spans no volume", {m_table, line, path}},
                      "Give the surface of a solid.");
    }
    m_findings.append(mesh.findings);
    const std::optional<double> volume = closedVolume(mesh);
    if (!volume) {
        addFinding(m_findings, path,
                   {"bodies.mesh_open", "the mesh of a body is not closed: how much of its hull it fills is not known", {}},
                   "close its holes; the hull is simulated, with the mass of the table");
    } else if (*volume < convexShare * hull->volume) {
        addFinding(m_findings, path,
                   {"bodies.mesh_hollow",
                    "the mesh of a body is not convex: it fills {0} % of its hull, which is simulated with the mass of the table",
                    {100.0 * *volume / hull->volume}},
                   "cut it into convex bodies if its hollows matter");
    }
    if (hull->leftOut > leftOutShare * hull->sides.norm()) {
        addFinding(m_findings, path,
                   {"bodies.mesh_corners",
                    "the mesh of a body has more than {0} corners: points lie up to {1} outside of what is simulated",
                    {hullCornersMax, {hull->leftOut, "m"}}},
                   "none is needed unless that is much of its size");
    }
    return m_shapes.emplace(path, std::make_shared<const ConvexBody>(std::move(*hull))).first->second;
}

std::vector<std::string> filesOfBodies(const std::string& table) {
    std::set<std::string> meshes;
    try {
        const auto isMesh = [](const std::string& heading) {
            const TableColumn* column = columnNamed(heading).column;
            return column != nullptr && column->name == "mesh";
        };
        const DelimitedTable start = readDelimitedStart(table, 1);
        if (start.rows.empty() || std::none_of(start.rows.front().fields.begin(), start.rows.front().fields.end(), isMesh)) {
            return {table};
        }
        const DelimitedTable whole = readDelimitedTable(table, tableBytesMax);
        const std::vector<std::string>& names = whole.rows.front().fields;
        const auto column = static_cast<std::size_t>(std::find_if(names.begin(), names.end(), isMesh) - names.begin());
        for (std::size_t row = 1; row < whole.rows.size(); ++row) {
            if (column < whole.rows[row].fields.size() && !whole.rows[row].fields[column].empty()) {
                std::error_code ignored;
                const std::string path = bodyMeshPath(table, whole.rows[row].fields[column]);
                if (isMeshPath(path) && fs::is_regular_file(path, ignored)) {
                    meshes.insert(path);
                }
            }
        }
    } catch (const Error&) {
        // Whoever reads the table says what is wrong with it.
        return {table};
    }
    std::vector<std::string> files{table};
    files.insert(files.end(), meshes.begin(), meshes.end());
    return files;
}

}  // namespace rubble::io
