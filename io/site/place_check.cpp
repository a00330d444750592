#include "io/site/place_check.h"

#include <ogr_spatialref.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "io/base/file_words.h"
#include "io/site/gdal_session.h"
#include "io/site/site_place.h"
#include "io/site/system_way.h"

namespace rubble::io {

namespace {

/// Where a system is made for, in degrees.
struct AreaOfUse {
    double west, south, east, north;
    std::string name;

    bool holds(const Eigen::Vector2d& degrees) const {
        constexpr double edge = 0.05;
        const double x = degrees.x();
        const bool between =
            west <= east ? x >= west - edge && x <= east + edge : x >= west - edge || x <= east + edge;  // across the date line
        return between && degrees.y() >= south - edge && degrees.y() <= north + edge;
    }
};

std::optional<AreaOfUse> areaOf(const OGRSpatialReference& system) {
    AreaOfUse area{};
    const char* name = nullptr;
    if (!system.GetAreaOfUse(&area.west, &area.south, &area.east, &area.north, &name) || area.west < -360.0) {
        return std::nullopt;
    }
    area.name = name != nullptr ? name : "";
    return area;
}

/// @param place  m
Eigen::Vector2d degreesAt(const OGRSpatialReference& system, const Eigen::Vector2d& place) {
    return degreesOf(system, place / system.GetLinearUnits());
}

/// Lengths in a system by lengths on the ground at a place, the geometric mean over directions; 1 where it has no place there.
double stretchAt(const OGRSpatialReference& system, const Eigen::Vector2d& place) {
    constexpr double step = 500.0;  // m
    constexpr double radians = std::numbers::pi / 180.0;
    const Eigen::Vector2d from = degreesAt(system, place);
    const Eigen::Vector2d east = degreesAt(system, place + Eigen::Vector2d(step, 0.0)) - from;
    const Eigen::Vector2d north = degreesAt(system, place + Eigen::Vector2d(0.0, step)) - from;
    const double flat = system.GetInvFlattening() > 0.0 ? 1.0 / system.GetInvFlattening() : 0.0;
    const double squared = flat * (2.0 - flat);
    const double sine = std::sin(from.y() * radians);
    const double bend = 1.0 - squared * sine * sine;
    // Metres in a degree to the east and to the north.
    const Eigen::Vector2d metres(system.GetSemiMajor() / std::sqrt(bend) * std::cos(from.y() * radians) * radians,
                                 system.GetSemiMajor() * (1.0 - squared) / (bend * std::sqrt(bend)) * radians);
    const Eigen::Vector2d a = east.cwiseProduct(metres);
    const Eigen::Vector2d b = north.cwiseProduct(metres);
    const double area = std::abs(a.x() * b.y() - a.y() * b.x());
    const double stretch = step / std::sqrt(area);
    return std::isfinite(stretch) && stretch > 1e-3 && stretch < 1e3 ? stretch : 1.0;
}

/// Checks one case.
class PlaceCheck {
public:
    PlaceCheck(const Frame& frame, const Site& site) : m_frame(frame), m_site(site), m_place(frame, site) {}

    Findings check() {
        const double stretch = checkSystem();
        if (m_place.upright() && std::abs(stretch - 1.0) > 0.005) {
            find({"site.stretched",
                  "lengths in \"{0}\" are {1} times those on the ground at the site, and the model is laid into it as it is",
                  {m_frame.crs, stretch}},
                 "choose a system made for the site, such as its UTM zone, or tie the model to this one by control points");
        }
        m_findings.append(checkControlPoints(m_site.controlPoints, stretch));
        return std::move(m_findings);
    }

private:
    /// @return lengths in the system by lengths on the ground; 1 where nothing is known
    double checkSystem() {
        if (m_frame.crs.empty()) {
            return 1.0;
        }
        const GdalSession session;
        OGRSpatialReference system;
        if (!setFromText(system, m_frame.crs)) {
            find({"site.system_unknown", "the coordinate system \"{0}\" of the case is not known", {m_frame.crs}},
                 "give the case an EPSG code, EPSG:25832 for example, or none");
            return 1.0;
        }
        if (system.IsLocal()) {
            return 1.0;
        }
        if (!system.IsProjected()) {
            find({"site.system_in_degrees",
                  "the coordinate system \"{0}\" of the case has no eastings and northings",
                  {m_frame.crs}},
                 "give the case a projected system, such as the UTM zone of the site");
            return 1.0;
        }
        system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        if (m_place.system().empty()) {
            find({"site.untied",
                  "the case names the coordinate system \"{0}\", but nothing says where in it the model stands",
                  {m_frame.crs}},
                 "tie the model to it by two control points or more (Site… in the Case menu), or leave the system out");
            return 1.0;
        }
        const Eigen::Vector2d place = m_place.planToWorld(middle());
        return checkArea(system, place) ? stretchAt(system, place) : 1.0;
    }

    /// Of the control points that are used, else the local zero.
    Eigen::Vector2d middle() const {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const ControlPoint& point : m_site.controlPoints) {
            if (point.used && !m_place.upright()) {
                sum += point.local.head<2>() / static_cast<double>(usedPoints(m_site.controlPoints));
            }
        }
        return sum;
    }

    /// @return whether the place lies where the system is made for, or that is not known
    bool checkArea(const OGRSpatialReference& system, const Eigen::Vector2d& place) {
        const std::optional<AreaOfUse> area = areaOf(system);
        const Eigen::Vector2d degrees = degreesAt(system, place);
        if (!area || area->holds(degrees)) {
            return true;
        }
        const double unit = system.GetLinearUnits();
        const bool swapped = area->holds(degreesAt(system, place.reverse()));
        const bool inUnit = unit != 1.0 && area->holds(degreesAt(system, place * unit));
        std::vector<Argument> arguments{m_frame.crs, area->name, {place.x(), "m"}, {place.y(), "m"}};
        if (swapped) {
            find({"site.swapped",
                  "the site lies outside the area of use of \"{0}\" ({1}) at easting {2}, northing {3}; changed for each other "
                  "they lie "
                  "in it",
                  arguments},
                 "change easting and northing of the control points for each other");
        } else if (inUnit) {
            const char* name = nullptr;
            system.GetLinearUnits(&name);
            arguments.emplace_back(name != nullptr ? name : "its unit");
            find({"site.not_metres",
                  "the site lies outside the area of use of \"{0}\" ({1}) at easting {2}, northing {3}; in {4} they lie in it",
                  arguments},
                 "give easting and northing of the case in metres; what is written for others is in the unit of the system");
        } else if (degrees.allFinite()) {
            arguments.insert(arguments.end(), {degrees.y(), degrees.x()});
            find(
                {"site.outside_area",
                 "the site lies outside the area of use of \"{0}\" ({1}) at easting {2}, northing {3}: latitude {4}, longitude {5}",
                 arguments},
                "check system and control points of the case");
        } else {
            find({"site.nowhere", "easting {2}, northing {3} of the site is no place on Earth in \"{0}\" ({1})", arguments},
                 "check system and control points of the case");
        }
        return false;
    }

    void find(Message what, std::string_view remedy) { addFinding(m_findings, {}, std::move(what), remedy); }

    const Frame& m_frame;
    const Site& m_site;
    SitePlace m_place;
    Findings m_findings;
};

}  // namespace

Findings checkPlace(const Frame& frame, const Site& site) {
    return PlaceCheck(frame, site).check();
}

}  // namespace rubble::io
