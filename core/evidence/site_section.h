#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/unknown.h"
#include "core/evidence/clouds/surface_tree.h"
#include "core/evidence/photographs/site_picture.h"
#include "core/evidence/surveys/survey.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// A straight cut through a site, upright. Lengths in m, places local.
struct SectionLine {
    Eigen::Vector2d from = Eigen::Vector2d::Zero();
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    double width = 1.0;  ///< measured points within half of it to either side belong to the section
    double step = 0.25;  ///< along the line: what is drawn, and what areas are summed over

    double length() const { return (to - from).norm(); }
    /// m, along the line from its start and to its left.
    Eigen::Vector2d onLine(const Eigen::Vector2d& place) const;
};

/// A piece of the line.
struct SectionStep {
    double along = 0.0;                    ///< m, its middle
    double ground = unknown;               ///< m, local height
    double simulated = unknown;            ///< m, the highest surface there; NaN: nothing is met
    SiteThing thing = SiteThing::Nothing;  ///< what that is
    std::int64_t points = 0;               ///< measured there
    double measured = unknown;             ///< m, their mean height; NaN without any
    double simulatedAtPoints = unknown;    ///< m, the mean of the simulated surface where they lie
};

/// Heights of one survey, cloud or set of measured points.
struct MeasuredSet {
    std::string name;          ///< for people
    std::vector<Vec3> places;  ///< m, local
};

/// How measured and simulated heights agree at points of a section.
struct SectionAgreement {
    std::int64_t points = 0;
    std::int64_t compared = 0;  ///< of them, where the simulation has a surface
    double mean = unknown;      ///< m, simulated less measured height at them
    double rms = unknown;       ///< m
};

/// What one set has in a section.
struct SectionSource {
    std::string name;
    SectionAgreement agreement;
};

/// A measured point beside the line, with what the simulation has there.
struct SectionPoint {
    Vec3 place = Vec3::Zero();  ///< m
    double along = 0.0;
    double across = 0.0;         ///< m, to the left of the line
    double simulated = unknown;  ///< m, highest surface at its own place; NaN: nothing is met
    SiteThing thing = SiteThing::Nothing;
    std::size_t source = 0;  ///< index into SiteSection::sources
};

/// A section through the simulated site and what was measured of the real one.
struct SiteSection {
    SectionLine line;
    double water = unknown;  ///< m, local height of still water at the site; NaN: there is none
    std::vector<SectionStep> steps;
    std::vector<SectionPoint> points;    ///< along the line
    std::vector<SectionSource> sources;  ///< [set] as given, also those without a point beside the line
    SectionAgreement agreement;          ///< of all points
    double covered = 0.0;                ///< m of the line with measured points
    double measuredArea = 0.0;  ///< m2 between ground and measured heights, where there are any; below the ground it counts against
    double simulatedArea = 0.0;  ///< m2, the same of the simulated surface at the same points
};

/// The line that measured points follow: the main axis of their places in plan, to half a width beyond the outermost of them. It
/// goes eastwards, or northwards where it is nearer to that. @param line  whose width and step are kept
/// Throws UsageError (all places in one spot, or fewer than two).
SectionLine lineAlong(std::span<const MeasuredSet> measured, SectionLine line);

/// Cuts the site from above: a ray straight down for each step and each point.
/// @param site      with ground; @param tree  of it
/// Throws UsageError (no length, width or step, more steps than 100,000), Cancelled.
SiteSection siteSection(const SiteShape& site, const SurfaceTree& tree, const SiteSurface& ground, const SectionLine& line,
                        std::span<const MeasuredSet> measured, const Execution& execution);

/// Heights of a survey within the width of a line, as measured points, m, local. Those above the ground are set upon it.
std::vector<Vec3> heightsBeside(const SurveyHeights& heights, const SiteSurface& ground, const SectionLine& line);

}  // namespace rubble
