#include "io/site/clouds/cloud_system.h"

#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <limits>

#include "io/base/file_words.h"
#include "io/site/gdal_session.h"
#include "io/site/system_way.h"

namespace rubble::io {

namespace {

bool setSystem(OGRSpatialReference& system, const std::string& text) {
    return setFromText(system, text) && !system.IsEmpty();
}

void takeAskedSystem(const std::string& path, const std::string& asked, CloudHead& head, Findings& findings) {
    if (asked.empty()) {
        return;
    }
    OGRSpatialReference system;
    if (!setSystem(system, asked)) {
        throw UsageError({"cloud.no_system", "\"{0}\" names no coordinate system", {asked}},
                         {"cloud.no_system.remedy", "Give an EPSG code such as EPSG:25832, WKT or PROJ.", {}});
    }
    if (knowsSystem(head.crs)) {
        addFinding(findings, path, {"cloud.system_kept", "the file names its coordinate system, so {0} was not taken", {asked}},
                   "leave the system away, or have the file written anew with the right one");
        return;
    }
    head.crs = asked;
    head.crsFrom = "asked for";
}

void assumeHeightUnit(const std::string& path, CloudUnits& units, Findings& findings) {
    units.heightMetres = units.degrees ? 1.0 : units.metres;
    if (units.degrees || units.metres != 1.0) {
        addFinding(findings, path,
                   {"cloud.height_unit_assumed",
                    "the file does not say the unit of its heights; one is taken as {0}",
                    {Argument(units.heightMetres, "m")}},
                   "compare the range of heights with what is known of the place; have the file written with a vertical system");
    }
}

/// Throws ParseError unless a unit of a heading is that of the system. @param own  not a number: degrees
void requireUnit(const std::string& path, const std::optional<double>& headed, double own) {
    // Two feet that are told apart by two millionths go by one name.
    constexpr double alike = 1e-5;
    if (headed && !(std::abs(*headed / own - 1.0) < alike)) {
        refuseContent({"cloud.unit_differs",
                       "{0}: its headings name a unit of {1}, and its coordinate system has another one",
                       {path, Argument(*headed, "m")}},
                      "Correct the heading, or name the system that the numbers are in.");
    }
}

/// The unit of heights: of the vertical part, or that of x and y, or metres over degrees, else of the heading.
void takeHeightUnit(const std::string& path, const OGRSpatialReference& system, const std::optional<double>& headed,
                    CloudUnits& units, Findings& findings) {
    if (system.IsVertical() != 0) {
        units.heightMetres = system.GetTargetLinearUnits("VERT_CS", nullptr);
        units.heightStated = true;
        requireUnit(path, headed, units.heightMetres);
        return;
    }
    if (system.GetAxesCount() == 3 || units.geocentric) {
        units.heightMetres = units.degrees ? 1.0 : units.metres;
        units.heightStated = true;
        requireUnit(path, headed, units.heightMetres);
        return;
    }
    if (headed) {
        units.heightMetres = *headed;
        units.heightStated = true;
        return;
    }
    assumeHeightUnit(path, units, findings);
}

/// The units of a table without a system, as its headings name them.
void takeHeadedUnits(const std::string& path, CloudHead& head, Findings& findings) {
    CloudUnits& units = head.units;
    if (head.planMetres) {
        units.metres = *head.planMetres;
        units.metresStated = true;
    }
    if (head.heightMetres) {
        units.heightMetres = *head.heightMetres;
        units.heightStated = true;
    } else if (head.planMetres) {
        assumeHeightUnit(path, units, findings);
    }
}

void tellUnknownSystem(const std::string& path, const CloudHead& head, Findings& findings) {
    if (!head.crs.empty()) {
        addFinding(findings, path,
                   {"cloud.system_unread", "the coordinate system of the file cannot be read; its numbers are taken as metres", {}},
                   "name the system, such as EPSG:25832");
    } else if (!head.metresByFormat && !head.planMetres) {
        addFinding(findings, path,
                   {"cloud.system_unknown", "the file names no coordinate system; its numbers are taken as metres", {}},
                   "name the system, such as EPSG:25832, or check the bounds against something whose length is known");
    }
}

}  // namespace

bool knowsSystem(const std::string& text) {
    const GdalSession session;
    OGRSpatialReference system;
    return setSystem(system, text);
}

bool sameSystem(const std::string& one, const std::string& other) {
    const GdalSession session;
    OGRSpatialReference a;
    OGRSpatialReference b;
    if (!setSystem(a, one) || !setSystem(b, other)) {
        return true;
    }
    const std::array<const char*, 3> options{"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT", nullptr};
    return a.IsSame(&b, options.data()) != 0;
}

std::string systemInPlan(const std::string& text) {
    const GdalSession session;
    OGRSpatialReference system;
    return setSystem(system, text) ? wktOf(inPlan(system)) : std::string();
}

void describeUnits(const std::string& path, const std::string& asked, CloudHead& head, Findings& findings) {
    const GdalSession session;
    takeAskedSystem(path, asked, head, findings);
    CloudUnits& units = head.units;
    units.metresStated = units.heightStated = head.metresByFormat;
    OGRSpatialReference system;
    if (!setSystem(system, head.crs)) {
        tellUnknownSystem(path, head, findings);
        takeHeadedUnits(path, head, findings);
        return;
    }
    if (system.IsLocal() != 0) {
        units.metres = system.GetLinearUnits();
        units.metresStated = true;
        requireUnit(path, head.planMetres, units.metres);
        addFinding(findings, path,
                   {"cloud.system_local",
                    "the coordinate system of the file is no place on Earth; a unit of it is {0}",
                    {Argument(units.metres, "m")}},
                   "place the cloud by points that are known in it and in the case");
        takeHeightUnit(path, system, head.heightMetres, units, findings);
        return;
    }
    units.name = system.GetName() != nullptr ? system.GetName() : "unnamed";
    units.heightSystem = heightSystemOf(system);
    units.degrees = system.IsGeographic() != 0;
    units.geocentric = system.IsGeocentric() != 0;
    units.metres = units.degrees ? std::numeric_limits<double>::quiet_NaN() : system.GetLinearUnits();
    units.metresStated = true;
    requireUnit(path, head.planMetres, units.metres);
    takeHeightUnit(path, system, head.heightMetres, units, findings);
    if (units.degrees) {
        addFinding(
            findings, path,
            {"cloud.degrees", "x and y are degrees of longitude and latitude, no lengths: the cloud has no size in metres", {}},
            "bring it to a projected system, such as the UTM zone of the place, before it is used with a case");
    } else if (units.geocentric) {
        addFinding(findings, path, {"cloud.geocentric", "places count from the centre of the Earth: z is not up", {}},
                   "bring it to a projected system, such as the UTM zone of the place, before it is used with a case");
    }
}

}  // namespace rubble::io
