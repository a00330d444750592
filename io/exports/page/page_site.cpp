#include "io/exports/page/page_site.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble::io {

void addSite(PageScene& scene, const std::vector<SiteMesh>* meshes) {
    scene.about["site"] = nullptr;
    std::size_t triangles = 0;
    for (const SiteMesh& mesh : meshes != nullptr ? *meshes : std::vector<SiteMesh>()) {
        triangles += mesh.triangles.size();
    }
    scene.siteLeftOut = triangles > pageSiteTrianglesMost;
    if (triangles == 0 || scene.siteLeftOut) {
        return;
    }
    const double step = PagePrecision().nodeStep;
    PackedIntegers points;
    std::vector<std::int64_t> corners;
    std::array<std::int64_t, 3> before{};
    std::int64_t first = 0;
    for (const SiteMesh& mesh : *meshes) {
        for (const Vec3& point : mesh.points) {
            Vec3 shown;
            for (int c = 0; c < 3; ++c) {
                const std::int64_t now = std::llround(point[c] / step);
                std::int64_t& last = before[static_cast<std::size_t>(c)];
                points.add(now - last);
                last = now;
                shown[c] = step * static_cast<double>(now);
            }
            scene.siteError = std::max(scene.siteError, (shown - point).norm());
        }
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t corner : triangle) {
                corners.push_back(first + corner);
            }
        }
        first += static_cast<std::int64_t>(mesh.points.size());
    }
    PackedIntegers steps;
    steps.addSteps(corners);
    scene.data.add("sitePoints", points);
    scene.data.add("siteCorners", steps);
    scene.siteTriangles = triangles;
    scene.about["site"] = {{"points", first}, {"step", step}};
}

}  // namespace rubble::io
