#include "io/site/site_mesh_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/fe/meshes/raw_mesh_file.h"
#include "io/site/clouds/height_source.h"
#include "io/site/height_reading.h"
#include "io/site/meshes/gltf_mesh.h"
#include "io/site/meshes/mesh_offset.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t meshBytesMax = std::uintmax_t{2} << 30;
/// m. Coordinates that are kept less finely are a finding.
constexpr double coarseStep = 0.01;

void checkMeshFile(const std::string& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error) || !std::ifstream(path, std::ios::binary)) {
        throw WorldError({"surroundings.missing", "There is no mesh of surroundings {0} that may be read", {path}},
                         {"surroundings.missing.remedy", "Check the path, or leave the mesh out.", {}});
    }
    if (fs::file_size(path, error) == 0) {
        refuseContent({"surroundings.empty", "{0} is empty", {path}}, "Copy it again from where it came.");
    }
}

RawMesh readRawMesh(const std::string& path, const Execution& execution) {
    std::error_code error;
    if (fs::file_size(path, error) > meshBytesMax) {
        refuseContent({"surroundings.too_large", "{0} is too large for a mesh of surroundings", {path}},
                      "Make it simpler, to 5,000,000 triangles or fewer.");
    }
    if (isMeshPath(path)) {
        return readTriangleMesh(path, execution);
    }
    if (hasEnding(path, ".gltf") || hasEnding(path, ".glb")) {
        return readGltfMesh(path, execution);
    }
    refuseContent({"surroundings.ending", "{0} does not end in .obj, .ply, .stl, .gltf or .glb, and is no point cloud", {path}},
                  "Give a mesh in one of these formats, or a point cloud.");
}

/// A PLY whose head names no faces holds points.
bool plyOfPoints(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string line;
    for (int lines = 0; lines < 1000 && std::getline(file, line) && !line.starts_with("end_header"); ++lines) {
        if (line.starts_with("element face ") || line.starts_with("element tristrips ")) {
            return line.find_first_of("123456789") == std::string::npos;
        }
    }
    return line.starts_with("end_header");
}

bool isCloudOfSurroundings(const std::string& path, const CloudRequest& read) {
    if (hasEnding(path, ".ply")) {
        return plyOfPoints(path);
    }
    return !isMeshPath(path) && !hasEnding(path, ".gltf") && !hasEnding(path, ".glb") && holdsCloud(path, read);
}

/// The surface of a point cloud as a mesh: two triangles to each cell of its grid, none where points are missing.
class CloudSurface {
public:
    explicit CloudSurface(HeightGrid grid) : m_grid(std::move(grid)) {
        const double nodes = static_cast<double>(m_grid.nx) * static_cast<double>(m_grid.ny);
        m_step = static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(nodes / surfaceNodesMax))));
    }

    /// Nodes from one that is taken to the next.
    std::size_t step() const { return m_step; }
    double cell() const { return static_cast<double>(m_step) * std::max(m_grid.dx, m_grid.dy); }

    void addTo(SiteMesh& mesh) const {
        const std::size_t columns = (m_grid.nx + m_step - 1) / m_step;
        std::vector<std::uint32_t> before(columns, missing);
        std::vector<std::uint32_t> now(columns, missing);
        for (std::size_t row = 0; row < m_grid.ny; row += m_step) {
            for (std::size_t c = 0; c < columns; ++c) {
                const std::size_t column = c * m_step;
                const Vec3 place(m_grid.x0 + static_cast<double>(column) * m_grid.dx,
                                 m_grid.y0 + static_cast<double>(row) * m_grid.dy, m_grid.heights[row * m_grid.nx + column]);
                now[c] = std::isfinite(place.z()) ? static_cast<std::uint32_t>(mesh.points.size()) : missing;
                if (now[c] != missing) {
                    mesh.points.push_back(place);
                }
            }
            for (std::size_t c = 0; c + 1 < columns; ++c) {
                addTriangle(mesh, {before[c], before[c + 1], now[c]});
                addTriangle(mesh, {before[c + 1], now[c + 1], now[c]});
            }
            std::swap(before, now);
        }
    }

private:
    static constexpr std::uint32_t missing = std::numeric_limits<std::uint32_t>::max();
    static constexpr double surfaceNodesMax = 1e6;

    static void addTriangle(SiteMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
        if (std::find(triangle.begin(), triangle.end(), missing) == triangle.end()) {
            mesh.triangles.push_back(triangle);
        }
    }

    HeightGrid m_grid;
    std::size_t m_step = 1;
};

SiteMeshReading readCloudSurface(const std::string& path, const Frame& frame, const Site& site, const Execution& execution,
                                 const SiteMeshRequest& request) {
    HeightReading read = readHeights(path, frame, site, request.around.structure, execution,
                                     {.alongAxes = true, .surface = true, .read = request.read}, HeightReach::Window);
    SiteMeshReading made;
    made.findings = std::move(read.findings);
    made.mesh.name = fs::path(path).filename().string();
    if (request.offset && !request.offset->isZero()) {
        addFinding(made.findings, path,
                   {"surroundings.cloud_offset",
                    "the offset was not added, for this is a point cloud: it lies as its coordinates say",
                    {}},
                   "give the cloud in the system of the case, or a mesh of it");
    }
    const CloudSurface surface(std::move(read.raster));
    surface.addTo(made.mesh);
    addFinding(made.findings, path,
               {"surroundings.cloud_surface",
                "a point cloud of the surroundings is taken as a surface with a height every {0}, without vegetation and wires",
                {{surface.cell(), "m"}}},
               "none is needed; what hangs over the ground is not told from it");
    return made;
}

/// Brings a mesh to the local frame, with the offset that puts it at the site.
class MeshPlacing {
public:
    MeshPlacing(const std::string& path, const Frame& frame, const Site& site, const SiteWindow& window, RawMesh raw)
        : m_path(path),
          m_place(frame, site),
          m_shift(site.heightShift),
          m_window(window),
          m_around(window.structure),
          m_raw(std::move(raw)) {
        m_result.findings = std::move(m_raw.findings);
    }

    SiteMeshReading place(const std::optional<Vec3>& typed) {
        if (m_raw.step > coarseStep) {
            find({"surroundings.coarse", "the file keeps coordinates to {0} only", {{m_raw.step, "m"}}},
                 "write it in double precision, or about an origin near the site with that origin as its offset");
        }
        m_result.offset = typed ? *typed : offsetFromFile();
        m_result.mesh.name = fs::path(m_path).filename().string();
        m_result.mesh.points.reserve(m_raw.points.size());
        for (const Vec3& point : m_raw.points) {
            m_result.mesh.points.push_back(local(point, m_result.offset));
        }
        checkPlace();
        m_result.mesh.triangles = std::move(m_raw.triangles);
        return std::move(m_result);
    }

private:
    Vec3 local(const Vec3& point, const Vec3& offset) const { return m_place.toLocal(point + offset) + Vec3(0.0, 0.0, m_shift); }

    /// m, that surroundings may lie above or below the structure.
    double margin() const { return std::max(m_window.margin(), 1.0); }

    /// Where surroundings may lie in plan.
    Eigen::AlignedBox2d plan() const {
        const Eigen::AlignedBox2d plan = m_window.plan();
        const double more = margin() - m_window.margin();
        return {plan.min().array() - more, plan.max().array() + more};
    }

    Aabb boxOf(const std::array<std::uint32_t, 3>& triangle, const Vec3& offset) const {
        Aabb box;
        for (const std::uint32_t corner : triangle) {
            box.extend(local(m_raw.points[corner], offset));
        }
        return box;
    }

    /// Box around all triangles that lie in the window in plan; empty: none does.
    Aabb nearby(const Vec3& offset) const {
        Aabb all;
        const Eigen::AlignedBox2d within = plan();
        for (const std::array<std::uint32_t, 3>& triangle : m_raw.triangles) {
            const Aabb box = boxOf(triangle, offset);
            if (within.intersects(Eigen::AlignedBox2d(box.min().head<2>(), box.max().head<2>()))) {
                all.extend(box);
            }
        }
        return all;
    }

    Vec3 offsetFromFile() {
        const OffsetSearch search = offsetBeside(m_path);
        if (!search.unread.empty()) {
            find(
                {"surroundings.offset_unread", "{0} looks like the offset of the mesh, but cannot be read as one", {search.unread}},
                "state the offset of the mesh in the case, or remove the file");
        }
        if (!search.offset) {
            return Vec3::Zero();
        }
        const MeshOffset& found = *search.offset;
        const bool needed = m_around.isEmpty() || nearby(Vec3::Zero()).isEmpty();
        if (!needed) {
            find({"surroundings.offset_left",
                  "the offset in {0} was not added, for the mesh lies at the site without it",
                  {found.file}},
                 "state the offset of the mesh in the case if it is to be added");
            return Vec3::Zero();
        }
        find({"surroundings.offset_file",
              "{0}, {1}, {2} was added to the coordinates of the mesh, the offset in {3} (its system: {4})",
              {{found.by.x(), "m"},
               {found.by.y(), "m"},
               {found.by.z(), "m"},
               found.file,
               found.system.empty() ? "not named" : found.system}},
             "none is needed if it is of this mesh and of the system of the case; else state the offset in the case");
        return found.by;
    }

    void checkPlace() {
        if (m_around.isEmpty()) {
            return;
        }
        const Aabb close = nearby(m_result.offset);
        if (close.isEmpty()) {
            refuseElsewhere();
        }
        const double apart = std::max(close.min().z() - m_around.max().z(), m_around.min().z() - close.max().z());
        if (apart > margin()) {
            find({"surroundings.far_off",
                  "the mesh lies {0} {1} the whole structure",
                  {{apart, "m"}, close.min().z() > m_around.max().z() ? "above" : "below"}},
                 "check the heights of the mesh, its offset and the height shift of the site");
        }
    }

    [[noreturn]] void refuseElsewhere() const {
        Aabb all;
        for (const std::array<std::uint32_t, 3>& triangle : m_raw.triangles) {
            all.extend(boxOf(triangle, m_result.offset));
        }
        const Vec3 low = m_around.min();
        const Vec3 high = m_around.max();
        const Eigen::AlignedBox2d within = plan();
        refuseContent(
            {"surroundings.elsewhere",
             "{0} lies at x = {1} to {2}, y = {3} to {4} of the local frame; the structure stands at x = {5} to {6}, y = {7} to "
             "{8}, and surroundings count within x = {9} to {10}, y = {11} to {12}",
             {m_path,
              all.min().x(),
              {all.max().x(), "m"},
              all.min().y(),
              {all.max().y(), "m"},
              low.x(),
              {high.x(), "m"},
              low.y(),
              {high.y(), "m"},
              within.min().x(),
              {within.max().x(), "m"},
              within.min().y(),
              {within.max().y(), "m"}}},
            "Give the offset that was taken off its coordinates (--mesh-offset), put the offset file beside it, or check "
            "system and control points of the case.");
    }

    void find(Message what, std::string_view remedy) { addFinding(m_result.findings, m_path, std::move(what), remedy); }

    const std::string& m_path;
    SitePlace m_place;
    double m_shift;
    const SiteWindow& m_window;
    const Aabb& m_around;  ///< the structure
    RawMesh m_raw;
    SiteMeshReading m_result;
};

}  // namespace

SiteMeshReading readSiteMesh(const std::string& path, const Frame& frame, const Site& site, const Execution& execution,
                             const SiteMeshRequest& request) {
    checkMeshFile(path);
    execution.check();
    if (isCloudOfSurroundings(path, request.read)) {
        return readCloudSurface(path, frame, site, execution, request);
    }
    MeshPlacing placing(path, frame, site, request.around, readRawMesh(path, execution));
    return placing.place(request.offset);
}

}  // namespace rubble::io
