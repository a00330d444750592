#include "io/site/system_way.h"

#include <ogr_spatialref.h>
#include <proj.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "io/base/file_words.h"

namespace rubble::io {

namespace {

/// m. Places are good to this without a word.
constexpr double quietAccuracy = 0.1;

/// Own handles of PROJ, apart from those of GDAL.
struct ProjSession {
    ProjSession() : context(proj_context_create()) { proj_log_level(context, PJ_LOG_NONE); }
    ~ProjSession() { proj_context_destroy(context); }
    ProjSession(const ProjSession&) = delete;
    ProjSession& operator=(const ProjSession&) = delete;
    PJ_CONTEXT* context;
};
struct ProjRelease {
    void operator()(PJ* object) const { proj_destroy(object); }
    void operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
    void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const { proj_operation_factory_context_destroy(factory); }
};
template <class T>
using ProjHandle = std::unique_ptr<T, ProjRelease>;

ProjHandle<PJ> projSystem(const ProjSession& session, const OGRSpatialReference& system) {
    char* text = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    const bool written = system.exportToWkt(&text, options) == OGRERR_NONE;
    ProjHandle<PJ> made(written ? proj_create(session.context, text) : nullptr);
    CPLFree(text);
    return made;
}

/// Operations between two systems that cover a place, the best first.
ProjHandle<PJ_OBJ_LIST> operationsAt(const ProjSession& session, const PJ& from, const PJ& to, const Eigen::Vector2d& degrees,
                                     PROJ_GRID_AVAILABILITY_USE grids) {
    const ProjHandle<PJ_OPERATION_FACTORY_CONTEXT> factory(proj_create_operation_factory_context(session.context, nullptr));
    proj_operation_factory_context_set_spatial_criterion(session.context, factory.get(),
                                                         PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
    proj_operation_factory_context_set_grid_availability_use(session.context, factory.get(), grids);
    if (degrees.allFinite()) {
        constexpr double half = 1e-3;  // degrees
        proj_operation_factory_context_set_area_of_interest(session.context, factory.get(), degrees.x() - half, degrees.y() - half,
                                                            degrees.x() + half, degrees.y() + half);
    }
    return ProjHandle<PJ_OBJ_LIST>(proj_create_operations(session.context, &from, &to, factory.get()));
}

void takeUsed(const ProjSession& session, const PJ_OBJ_LIST& list, SystemWay& way) {
    if (proj_list_get_count(&list) < 1) {
        return;
    }
    const ProjHandle<PJ> used(proj_list_get(session.context, &list, 0));
    const char* name = proj_get_name(used.get());
    way.operation = name != nullptr ? name : "";
    // A projection is exact by definition, and has no accuracy of its own.
    const bool projects = proj_get_type(used.get()) == PJ_TYPE_CONVERSION;
    way.accuracy = projects ? 0.0 : proj_coordoperation_get_accuracy(session.context, used.get());
    if (proj_coordoperation_has_ballpark_transformation(session.context, used.get()) != 0) {
        way.accuracy = -1.0;
    }
}

void takeBest(const ProjSession& session, const PJ_OBJ_LIST& list, SystemWay& way) {
    if (proj_list_get_count(&list) < 1) {
        return;
    }
    const ProjHandle<PJ> best(proj_list_get(session.context, &list, 0));
    way.bestAccuracy = proj_coordoperation_get_accuracy(session.context, best.get());
    for (int g = 0; g < proj_coordoperation_get_grid_used_count(session.context, best.get()); ++g) {
        const char* name = nullptr;
        int available = 1;
        if (proj_coordoperation_get_grid_used(session.context, best.get(), g, &name, nullptr, nullptr, nullptr, nullptr, nullptr,
                                              &available) != 0 &&
            available == 0 && name != nullptr) {
            way.missingGrids.emplace_back(name);
        }
    }
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

std::string nameOf(const OGRSpatialReference& system) {
    return system.GetName() != nullptr ? system.GetName() : "unnamed";
}

void addAccuracy(Findings& findings, const std::string& path, const SystemWay& way, const std::string& from,
                 const std::string& to) {
    constexpr std::string_view fetch = "fetch the grid with projsync --file NAME (package proj-bin), then open the case again";
    const bool better =
        !way.missingGrids.empty() && (way.accuracy < 0.0 || (way.bestAccuracy >= 0.0 && way.bestAccuracy < way.accuracy));
    if (better && way.accuracy < 0.0) {
        addFinding(
            findings, path,
            {"site.grid_needed",
             "the grid {0} is not here, and without it no way from \"{1}\" to \"{2}\" is known well; places may be metres or more "
             "off",
             {listed(way.missingGrids), from, to}},
            fetch);
    } else if (better) {
        addFinding(findings, path,
                   {"site.grid_missing",
                    "the grid {0} is not here, so places are good to {1} only: the way from \"{2}\" to \"{3}\" is {4}",
                    {listed(way.missingGrids), {way.accuracy, "m"}, from, to, way.operation}},
                   fetch);
    } else if (way.accuracy < 0.0) {
        addFinding(findings, path,
                   {"site.way_unknown",
                    "how well places in \"{0}\" are known in \"{1}\" is not known to PROJ; they may be metres or more off",
                    {from, to}},
                   "bring the file to the system of the case with a program that knows the way between the two");
    } else if (way.accuracy > quietAccuracy) {
        addFinding(findings, path,
                   {"site.way_accuracy",
                    "places are good to {0} only: so accurate is the way from \"{1}\" to \"{2}\", {3}",
                    {{way.accuracy, "m"}, from, to, way.operation}},
                   "give the file in the system of the case if that is too coarse");
    }
}

}  // namespace

bool setFromText(OGRSpatialReference& system, const std::string& text) {
    return !text.empty() &&
           system.SetFromUserInput(text.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) == OGRERR_NONE;
}

std::string wktOf(const OGRSpatialReference& system) {
    char* text = nullptr;
    std::string wkt;
    if (system.exportToWkt(&text) == OGRERR_NONE) {
        wkt = text;
    }
    CPLFree(text);
    return wkt;
}

OGRSpatialReference inPlan(const OGRSpatialReference& system) {
    OGRSpatialReference plan(system);
    plan.StripVertical();
    if (plan.GetAxesCount() == 3) {
        plan.DemoteTo2D(nullptr);
    }
    plan.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return plan;
}

std::string heightSystemOf(const OGRSpatialReference& system) {
    if (const char* name = system.GetAttrValue("VERT_CS")) {
        return name;
    }
    const char* ellipsoid = system.GetAxesCount() == 3 ? system.GetAttrValue("SPHEROID") : nullptr;
    return ellipsoid != nullptr ? "ellipsoid " + std::string(ellipsoid) : "";
}

Eigen::Vector2d degreesOf(const OGRSpatialReference& system, const Eigen::Vector2d& place) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    OGRSpatialReference plan = inPlan(system);
    const std::unique_ptr<OGRSpatialReference> angles(plan.CloneGeogCS());
    if (angles == nullptr) {
        return {nothing, nothing};
    }
    angles->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&plan, angles.get()));
    double x = place.x();
    double y = place.y();
    const bool done = way != nullptr && way->Transform(1, &x, &y) != FALSE && std::isfinite(x) && std::isfinite(y);
    const double unit = angles->GetAngularUnits() * 180.0 / M_PI;
    return done ? Eigen::Vector2d(x * unit, y * unit) : Eigen::Vector2d(nothing, nothing);
}

SystemWay systemWay(const OGRSpatialReference& from, const OGRSpatialReference& to, const Eigen::Vector2d& degrees) {
    const ProjSession session;
    const ProjHandle<PJ> source = projSystem(session, inPlan(from));
    const ProjHandle<PJ> target = projSystem(session, inPlan(to));
    SystemWay way;
    way.changes = true;
    if (source == nullptr || target == nullptr) {
        return way;
    }
    const auto usable = operationsAt(session, *source, *target, degrees, PROJ_GRID_AVAILABILITY_DISCARD_OPERATION_IF_MISSING_GRID);
    const auto all = operationsAt(session, *source, *target, degrees, PROJ_GRID_AVAILABILITY_IGNORED);
    if (usable != nullptr) {
        takeUsed(session, *usable, way);
    }
    if (all != nullptr) {
        takeBest(session, *all, way);
    }
    way.changes = way.accuracy != 0.0;
    return way;
}

void addWayFindings(Findings& findings, const std::string& path, const OGRSpatialReference* own, const std::string& crs,
                    const Eigen::Vector2d& degrees) {
    OGRSpatialReference of;
    if (own == nullptr || own->IsEmpty() || own->IsLocal()) {
        return;
    }
    if (crs.empty()) {
        addFinding(findings, path,
                   {"site.system_assumed",
                    "the file lies in \"{0}\", and the case names no coordinate system; that of the file is taken for it",
                    {nameOf(*own)}},
                   "name the coordinate system of the case; or check that its coordinates are those of the file");
        return;
    }
    if (!setFromText(of, crs) || of.IsGeographic() || of.IsGeocentric() || of.IsLocal()) {
        return;
    }
    const SystemWay way = systemWay(*own, of, degrees);
    if (way.changes) {
        addAccuracy(findings, path, way, nameOf(*own), nameOf(of));
    }
}

}  // namespace rubble::io
