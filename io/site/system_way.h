#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/geometry.h"

class OGRSpatialReference;

namespace rubble::io {

/// Sets a system from what a user may write: EPSG code, WKT, PROJ. Files and hosts are not asked. @return false if it names none
bool setFromText(OGRSpatialReference& system, const std::string& text);

/// A system as WKT; empty if it cannot be written so.
std::string wktOf(const OGRSpatialReference& system);

/// The part of a system that eastings and northings are in.
OGRSpatialReference inPlan(const OGRSpatialReference& system);

/// What heights of a system count from: its vertical datum, or its ellipsoid in three dimensions; empty if it says nothing.
std::string heightSystemOf(const OGRSpatialReference& system);

/// How places of one coordinate system become those of another, in the words and numbers of PROJ.
struct SystemWay {
    bool changes = false;                   ///< another datum; else only the projection differs, which is exact
    double accuracy = -1.0;                 ///< m; below zero: PROJ does not know it
    std::string operation;                  ///< that is used, empty: none is known
    double bestAccuracy = -1.0;             ///< m, of the best that there would be
    std::vector<std::string> missingGrids;  ///< that the best takes and that are not here
};

/// Asks PROJ at a place.
/// @param degrees  longitude and latitude of the place
SystemWay systemWay(const OGRSpatialReference& from, const OGRSpatialReference& to, const Eigen::Vector2d& degrees);

/// Says what bringing places from the system of a file into that of a case costs: the accuracy of the operation in metres where it
/// is worse than a decimetre or not known, and grids that are missing. A file whose system is taken for that of a case which names
/// none is said as well. Call it in a GdalSession.
/// @param own    of the file; null or empty: it names none
/// @param crs    of the case; empty: it names none
/// @param degrees  longitude and latitude of the site or of what is read; not a number: not known
void addWayFindings(Findings& findings, const std::string& path, const OGRSpatialReference* own, const std::string& crs,
                    const Eigen::Vector2d& degrees);

/// Longitude and latitude of a place in a system, on its own datum; not a number where it has none.
/// @param place  in units of the system
Eigen::Vector2d degreesOf(const OGRSpatialReference& system, const Eigen::Vector2d& place);

}  // namespace rubble::io
