#include "io/site/surveys/survey_reach.h"

#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/site/clouds/cloud_place.h"
#include "io/site/clouds/cloud_summary.h"
#include "io/site/clouds/height_source.h"
#include "io/site/height_reading.h"
#include "io/site/outline_file.h"
#include "io/site/surveys/measured_points.h"

namespace rubble::io {

namespace {

/// m. No site reaches as far; the first points of a cloud alone may lie at the end of a long one.
constexpr double kilometresAway = 10'000.0;

Eigen::AlignedBox2d placesPlan(const std::vector<Vec3>& places, const std::optional<Registration>& placed) {
    Eigen::AlignedBox2d plan;
    for (const Vec3& place : places) {
        if (place.allFinite()) {
            plan.extend((placed ? (*placed)(place) : place).head<2>().eval());
        }
    }
    return plan;
}

std::vector<Vec3> cornersOf(const Aabb& box) {
    std::vector<Vec3> corners;
    for (int corner = 0; corner < 8; ++corner) {
        corners.push_back(box.corner(static_cast<Aabb::CornerType>(corner)));
    }
    return corners;
}

/// Checks one survey.
class ReachCheck {
public:
    ReachCheck(const std::string& path, const std::optional<Registration>& placed, const Frame& frame, const Site& site,
               const Aabb& structure, const CloudRequest& read, const Execution& execution)
        : m_path(path),
          m_placed(placed),
          m_read(read),
          m_frame(frame),
          m_site(site),
          m_structure(structure),
          m_execution(execution) {}

    Findings check() {
        try {
            look();
        } catch (const ParseError& error) {
            const std::string& id = error.message().id;
            if (id != "terrain.elsewhere" && id != "terrain.nowhere" && id != "survey.corner") {
                throw;
            }
            m_findings.add(error.message(), error.remedy(), m_path);
        }
        return std::move(m_findings);
    }

private:
    void look() {
        if (holdsMeasuredPoints(m_path)) {
            const std::vector<Vec3> places = readMeasuredPoints({m_path, m_read, m_frame, m_site}, m_toldLater, m_execution);
            judge(placesPlan(places, m_placed), SiteWindow(m_structure).margin());
        } else if (const auto outline = readOutline(m_path, m_frame, m_site, true, m_execution)) {
            const auto [low, high] = outline->outline.bounds();
            const Aabb box(Vec3(low.x(), low.y(), 0.0), Vec3(high.x(), high.y(), 0.0));
            judge(placesPlan(cornersOf(box), m_placed), SiteWindow(m_structure).margin());
        } else if (holdsCloud(m_path, m_read)) {
            checkCloud();
        } else {
            const SiteWindow window(m_placed ? boxBack(*m_placed, m_structure) : m_structure);
            readHeights(m_path, m_frame, m_site, window, m_execution, {.surface = true, .read = m_read});
        }
    }

    void checkCloud() {
        const std::unique_ptr<PointCloud> cloud = openCloud(m_path, m_read);
        // Scans of other formats state bounds of their own frames.
        const bool stated = cloud->head().format.starts_with("LA") && !cloud->head().stated.isEmpty();
        std::vector<Vec3> places = stated ? cornersOf(cloud->head().stated) : std::vector<Vec3>();
        for (CloudBlock block; places.empty() && cloud->next(block, m_execution);) {
            places = block.places;
        }
        CloudPlace(*cloud, m_frame, m_site, m_toldLater).toLocal(places);
        judge(placesPlan(places, m_placed), stated ? SiteWindow(m_structure).margin() : kilometresAway);
    }

    void judge(const Eigen::AlignedBox2d& plan, double most) {
        const Eigen::AlignedBox2d structure(m_structure.min().head<2>(), m_structure.max().head<2>());
        const double away = plan.isEmpty() ? 0.0 : plan.exteriorDistance(structure);
        if (away > most) {
            m_findings.add(
                {"survey.far", "the survey lies {0} from the structure; debris of this site is not expected there", {{away, "m"}}},
                {"survey.far.remedy",
                 "check the coordinate systems of survey and case and the control points, or place the survey by pairs",
                 {}},
                m_path);
        }
    }

    const std::string& m_path;
    const std::optional<Registration>& m_placed;
    const CloudRequest& m_read;
    const Frame& m_frame;
    const Site& m_site;
    const Aabb& m_structure;
    const Execution& m_execution;
    Findings m_findings;
    Findings m_toldLater;  ///< where it is compared
};

}  // namespace

Findings checkSurveyReach(const std::string& path, const std::optional<Registration>& placed, const Frame& frame, const Site& site,
                          const Aabb& structure, const Execution& execution, const CloudRequest& read) {
    return ReachCheck(path, placed, frame, site, structure, read, execution).check();
}

Findings lookThroughCloud(const std::string& path, const CloudRequest& read, const Execution& execution) {
    if (!holdsCloud(path, read)) {
        return {};
    }
    const std::unique_ptr<PointCloud> cloud = openCloud(path, read);
    // Text does not say how many there are: so many bytes hold no more.
    constexpr std::uint64_t bytesOfALine = 6;
    std::error_code failed;
    const std::uintmax_t bytes = std::filesystem::file_size(path, failed);
    const std::uint64_t points = cloud->head().promised.value_or(failed ? 0 : bytes / bytesOfALine);
    if (points > lookedThroughMost) {
        return {};
    }
    const CloudSummary summary = summariseCloud(*cloud, execution);
    Findings findings = summary.findings;
    std::uint64_t left = 0;
    for (std::size_t fate = 1; fate < summary.fates.size(); ++fate) {
        left += summary.fates[fate];
    }
    if (left > 0) {
        addFinding(findings, path,
                   {"cloud.left_out",
                    "{0} of {1} points are left out: they have no echo, no number, or are marked as invalid, withheld or noise",
                    {static_cast<std::int64_t>(left), static_cast<std::int64_t>(left + summary.points())}},
                   "none is needed unless one was meant to count; rubble-cli cloud tells how many of each kind",
                   static_cast<std::int64_t>(left));
    }
    return findings;
}

}  // namespace rubble::io
