#include "io/site/surveys/run_section.h"

#include "io/site/clouds/run_distance.h"

namespace rubble::io {

RunSection cutRun(SiteShape site, const SiteSurface& ground, const SectionLine& line, std::span<const MeasuredSet> measured,
                  const Execution& execution) {
    RunSection made;
    Aabb around;
    for (const Eigen::Vector2d& end : {line.from, line.to}) {
        around.extend(Vec3(end.x() - line.width, end.y() - line.width, 0.0));
        around.extend(Vec3(end.x() + line.width, end.y() + line.width, 0.0));
    }
    addCoarseGround(made.findings, addGround(site, ground, around, scannedTriangles));
    made.section = siteSection(site, SurfaceTree(site.points, site.triangles), ground, line, measured, execution);
    made.time = site.time;
    const auto missing = made.section.agreement.points - made.section.agreement.compared;
    if (missing > 0) {
        made.findings.add({"section.no_surface", "points lie where the simulated site has no surface; they were not compared", {}},
                          {"section.no_surface.remedy", "check where the terrain ends", {}}, {}, missing);
    }
    for (std::size_t k = 0; k < measured.size(); ++k) {
        if (!measured[k].places.empty() && made.section.sources[k].agreement.points == 0) {
            made.findings.add(
                {"section.no_points", "none of {0} points lies within the width of the line", {measured[k].places.size()}},
                {"section.no_points.remedy", "check the ends of the line, or give a greater width", {}}, measured[k].name);
        }
    }
    return made;
}

}  // namespace rubble::io
