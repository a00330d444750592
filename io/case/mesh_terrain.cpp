#include "io/case/mesh_terrain.h"

#include <algorithm>
#include <cmath>

#include "io/base/file_words.h"
#include "io/site/site_mesh_file.h"

namespace rubble::io {

namespace {

/// Nodes of a terrain that is made of a mesh, at most.
constexpr double meshNodesMax = 4e6;
/// m. Surfaces that lie farther apart than this above each other are two.
constexpr double twoSurfaces = 0.05;
/// m, by which the empty ground below a mesh lies lower than its lowest point.
constexpr double emptyBelow = 1000.0;

Aabb boundsOf(const SiteMesh& mesh) {
    Aabb bounds;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            bounds.extend(mesh.points[corner]);
        }
    }
    return bounds;
}

/// Nodes that lie wholly within the outline of the mesh, with the highest surface over each; where there is none not a number.
HeightGrid highestSurface(const SiteMesh& mesh, const Aabb& bounds, double cell, const Execution& execution) {
    const Vec3 size = bounds.sizes();
    const auto nodes = [cell](double length) { return static_cast<std::size_t>(std::floor(length / cell + 1e-9)) + 1; };
    const double floor = bounds.min().z() - emptyBelow;
    HeightGrid grid{bounds.min().x(), bounds.min().y(), cell, cell, nodes(size.x()), nodes(size.y()), {}};
    grid.heights.assign(grid.nx * grid.ny, floor);
    grid.heights = terrainUnder(TerrainGrid(grid), {mesh}, cell, 4.0 * meshNodesMax, execution)->grid().heights;
    for (double& height : grid.heights) {
        if (height < floor + 0.5 * emptyBelow) {
            height = std::nan("");
        }
    }
    return grid;
}

SiteMesh upsideDown(SiteMesh mesh) {
    for (Vec3& point : mesh.points) {
        point.z() = -point.z();
    }
    return mesh;
}

void noteLayers(const HeightGrid& high, const HeightGrid& low, const std::string& path, Findings& findings) {
    std::int64_t layered = 0;
    double most = 0.0;
    for (std::size_t k = 0; k < std::min(high.heights.size(), low.heights.size()); ++k) {
        const double apart = high.heights[k] + low.heights[k];
        if (apart > twoSurfaces) {
            ++layered;
            most = std::max(most, apart);
        }
    }
    if (layered > 0) {
        addFinding(findings, path,
                   {"terrain.mesh_layers",
                    "at {0} of {1} places the mesh has surfaces above each other, up to {2} apart; the highest is taken",
                    {layered, high.heights.size(), {most, "m"}}},
                   "cut away roofs and overhangs if bodies are to fall below them", layered);
    }
}

}  // namespace

HeightReading heightsOfMesh(const std::string& path, const Frame& frame, const Site& site, const Execution& execution) {
    SiteMeshReading read = readSiteMesh(path, frame, site, execution);
    const Aabb bounds = boundsOf(read.mesh);
    const double area = bounds.sizes().x() * bounds.sizes().y();
    const double triangle = std::sqrt(2.0 * area / static_cast<double>(read.mesh.triangles.size()));
    const double cell = std::max(0.5 * triangle, std::sqrt(area / meshNodesMax));
    if (!(cell > 0.0) || !(std::min(bounds.sizes().x(), bounds.sizes().y()) > cell)) {
        refuseContent({"terrain.mesh_upright", "{0} is no surface that bodies could fall on: it has no area from above", {path}},
                      "Give a mesh of the ground with z up.");
    }
    HeightReading heights;
    heights.findings = std::move(read.findings);
    heights.raster = highestSurface(read.mesh, bounds, cell, execution);
    const SiteMesh turned = upsideDown(read.mesh);
    noteLayers(heights.raster, highestSurface(turned, boundsOf(turned), cell, execution), path, heights.findings);
    addFinding(heights.findings, path,
               {"terrain.mesh_cells",
                "the mesh of {0} triangles was taken as heights on cells of {1}",
                {read.mesh.triangles.size(), {cell, "m"}}},
               "none is needed; walls and overhangs are steep slopes");
    return heights;
}

}  // namespace rubble::io
