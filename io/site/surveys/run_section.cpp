#include "io/site/surveys/run_section.h"

#include <cmath>

#include "core/evidence/no_evidence.h"
#include "io/site/clouds/run_distance.h"
#include "io/site/surveys/evidence_origin.h"

namespace rubble::io {

void addMeasuredFile(RunSection& made, const RunSection::File& file, const CloudRequest& read, const std::string& cut) {
    made.files.push_back(file);
    noteOrigin(made.findings, file.path, surveyOriginOf(file.path, read), cut);
    made.findings = noEvidenceFirst(made.findings);
}

SectionLine lineAlongPoints(std::span<const MeasuredSet> measured, const SectionLine& line, Findings& findings) {
    const SectionLine found = lineAlong(measured, line);
    for (const MeasuredSet& set : measured) {
        std::int64_t beside = 0;
        for (const Vec3& place : set.places) {
            beside += std::abs(found.onLine(place.head<2>()).y()) > 0.5 * found.width ? 1 : 0;
        }
        if (beside > 0) {
            findings.add({"section.beside",
                          "of {0} points some lie farther from the line along them than half its width; they were left out",
                          {set.places.size()}},
                         {"section.beside.remedy", "give a greater width, or the ends of another line", {}}, set.name, beside);
        }
    }
    return found;
}

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
