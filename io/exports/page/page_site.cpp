#include "io/exports/page/page_site.h"

namespace rubble::io {

void addSite(PageScene& scene, const std::vector<SiteMesh>* meshes) {
    scene.about["site"] = nullptr;
    if (meshes == nullptr) {
        return;
    }
    std::size_t triangles = 0;
    for (const SiteMesh& mesh : *meshes) {
        triangles += mesh.triangles.size();
    }
    scene.siteLeftOut = triangles > pageSiteTrianglesMost;
    if (triangles == 0 || scene.siteLeftOut) {
        return;
    }
    const double step = PagePrecision().nodeStep;
    PackedPlaces places(step);
    std::vector<std::int64_t> corners;
    std::int64_t first = 0;
    for (const SiteMesh& mesh : *meshes) {
        for (const Vec3& point : mesh.points) {
            places.add(point);
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
    scene.data.add("sitePoints", places.numbers());
    scene.data.add("siteCorners", steps);
    scene.siteTriangles = triangles;
    scene.siteError = places.largestError();
    scene.about["site"] = {{"step", step}};
}

}  // namespace rubble::io
