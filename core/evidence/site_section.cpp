#include "core/evidence/site_section.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"

namespace rubble {

namespace {

constexpr double stepsMost = 100'000.0;
constexpr double spotMost = 1e-3;  // m, places that spread over less are one

struct Met {
    double height = unknown;
    SiteThing thing = SiteThing::Nothing;
};

/// Adds up the differences at points.
struct AgreementSums {
    std::int64_t points = 0, compared = 0;
    double sum = 0.0, squares = 0.0;

    void add(const SectionPoint& point) {
        ++points;
        if (std::isfinite(point.simulated)) {
            const double difference = point.simulated - point.place.z();
            ++compared;
            sum += difference;
            squares += difference * difference;
        }
    }

    SectionAgreement agreement() const {
        SectionAgreement made{points, compared};
        if (compared > 0) {
            made.mean = sum / static_cast<double>(compared);
            made.rms = std::sqrt(squares / static_cast<double>(compared));
        }
        return made;
    }
};

class SectionCut {
public:
    SectionCut(const SiteShape& site, const SurfaceTree& tree, const SiteSurface& ground, const SectionLine& line)
        : m_site(site), m_tree(tree), m_ground(ground) {
        m_made.line = line;
        const auto steps = static_cast<std::size_t>(std::ceil(line.length() / line.step - 1e-9));
        m_side = line.length() / static_cast<double>(steps);
        const Eigen::Vector2d way = (line.to - line.from) / line.length();
        for (std::size_t k = 0; k < steps; ++k) {
            SectionStep step;
            step.along = (static_cast<double>(k) + 0.5) * m_side;
            const Eigen::Vector2d at = line.from + step.along * way;
            const Met met = below(at);
            step.ground = m_ground.height(at.x(), at.y());
            step.simulated = met.height;
            step.thing = met.thing;
            m_made.steps.push_back(step);
        }
    }

    /// The points that follow are of this set.
    void begin(const std::string& name) { m_made.sources.push_back({name, {}}); }

    void take(const Vec3& place) {
        const Eigen::Vector2d at = m_made.line.onLine(place.head<2>());
        if (!place.allFinite() || at.x() < 0.0 || at.x() > m_made.line.length() || std::abs(at.y()) > 0.5 * m_made.line.width) {
            return;
        }
        const Met met = below(place.head<2>());
        m_made.points.push_back({place, at.x(), at.y(), met.height, met.thing, m_made.sources.size() - 1});
    }

    SiteSection conclude() {
        std::sort(m_made.points.begin(), m_made.points.end(),
                  [](const SectionPoint& a, const SectionPoint& b) { return a.along < b.along; });
        struct Sums {
            double measured = 0.0, simulated = 0.0, both = 0.0;
        };
        std::vector<Sums> sums(m_made.steps.size());
        AgreementSums all;
        std::vector<AgreementSums> bySource(m_made.sources.size());
        for (const SectionPoint& point : m_made.points) {
            const std::size_t k = std::min(sums.size() - 1, static_cast<std::size_t>(point.along / m_side));
            sums[k].measured += point.place.z();
            ++m_made.steps[k].points;
            if (std::isfinite(point.simulated)) {
                sums[k].simulated += point.simulated;
                sums[k].both += 1.0;
            }
            all.add(point);
            bySource[point.source].add(point);
        }
        for (std::size_t k = 0; k < sums.size(); ++k) {
            addStep(m_made.steps[k], sums[k].measured, sums[k].simulated, sums[k].both);
        }
        m_made.agreement = all.agreement();
        for (std::size_t k = 0; k < bySource.size(); ++k) {
            m_made.sources[k].agreement = bySource[k].agreement();
        }
        return std::move(m_made);
    }

private:
    Met below(const Eigen::Vector2d& at) const {
        const Aabb& box = m_tree.box();
        if (box.isEmpty()) {
            return {};
        }
        const double top = box.max().z() + 1.0;
        const std::optional<RayHit> hit = m_tree.firstHit(Vec3(at.x(), at.y(), top), -Vec3::UnitZ(), top - box.min().z() + 1.0);
        return hit ? Met{top - hit->range, m_site.things[hit->triangle]} : Met{};
    }

    /// Both areas are taken over the steps that have points and a surface at all of them, so that they are of one place.
    void addStep(SectionStep& step, double measured, double simulated, double both) {
        if (step.points == 0) {
            return;
        }
        step.measured = measured / static_cast<double>(step.points);
        m_made.covered += m_side;
        if (both == static_cast<double>(step.points)) {
            step.simulatedAtPoints = simulated / both;
            m_made.measuredArea += m_side * (step.measured - step.ground);
            m_made.simulatedArea += m_side * (step.simulatedAtPoints - step.ground);
        }
    }

    const SiteShape& m_site;
    const SurfaceTree& m_tree;
    const SiteSurface& m_ground;
    double m_side = 0.0;
    SiteSection m_made;
};

}  // namespace

Eigen::Vector2d SectionLine::onLine(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d way = (to - from) / length();
    return {way.dot(place - from), planeCross(way, place - from)};
}

SectionLine lineAlong(std::span<const MeasuredSet> measured, SectionLine line) {
    std::vector<Eigen::Vector2d> places;
    for (const MeasuredSet& set : measured) {
        for (const Vec3& place : set.places) {
            if (place.allFinite()) {
                places.emplace_back(place.head<2>());
            }
        }
    }
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places) {
        middle += place / static_cast<double>(places.size());
    }
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector2d& place : places) {
        spread += (place - middle) * (place - middle).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    if (places.size() < 2 || !(axes.eigenvalues()[1] > spotMost * spotMost)) {
        throw UsageError({"section.one_spot", "The measured points lie in one spot: no line goes along them", {}},
                         {"section.one_spot.remedy", "Give both ends of the line.", {}});
    }
    Eigen::Vector2d way = axes.eigenvectors().col(1);
    const bool east = std::abs(way.x()) >= std::abs(way.y());
    way *= (east ? way.x() : way.y()) < 0.0 ? -1.0 : 1.0;
    double first = 0.0;
    double last = 0.0;
    for (const Eigen::Vector2d& place : places) {
        first = std::min(first, way.dot(place - middle));
        last = std::max(last, way.dot(place - middle));
    }
    line.from = middle + (first - 0.5 * line.width) * way;
    line.to = middle + (last + 0.5 * line.width) * way;
    return line;
}

SiteSection siteSection(const SiteShape& site, const SurfaceTree& tree, const SiteSurface& ground, const SectionLine& line,
                        std::span<const MeasuredSet> measured, const Execution& execution) {
    const bool sound = line.length() > 0.0 && line.width > 0.0 && line.step > 0.0 && std::isfinite(line.length() + line.width);
    if (!sound || line.length() / line.step > stepsMost) {
        throw UsageError({"section.no_line", "A section needs a line with a length, a width, and at most {0} steps", {stepsMost}},
                         {"section.no_line.remedy", "Give two places apart from each other, or a greater step.", {}});
    }
    SectionCut cut(site, tree, ground, line);
    std::size_t taken = 0;
    for (const MeasuredSet& set : measured) {
        cut.begin(set.name);
        for (const Vec3& place : set.places) {
            if (taken++ % 4096 == 0) {
                execution.check();
            }
            cut.take(place);
        }
    }
    return cut.conclude();
}

std::vector<Vec3> heightsBeside(const SurveyHeights& heights, const SiteSurface& ground, const SectionLine& line) {
    std::vector<Vec3> places;
    for (std::size_t row = 0; row < heights.ny; ++row) {
        for (std::size_t column = 0; column < heights.nx; ++column) {
            const double height = heights.heights[row * heights.nx + column];
            if (!std::isfinite(height)) {
                continue;
            }
            const Eigen::Vector2d place = heights.placeOf(static_cast<double>(column), static_cast<double>(row));
            const Eigen::Vector2d at = line.onLine(place);
            if (at.x() >= 0.0 && at.x() <= line.length() && std::abs(at.y()) <= 0.5 * line.width) {
                const double base = heights.aboveGround ? ground.height(place.x(), place.y()) : 0.0;
                places.emplace_back(place.x(), place.y(), base + height);
            }
        }
    }
    return places;
}

}  // namespace rubble
