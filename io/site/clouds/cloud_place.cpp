#include "io/site/clouds/cloud_place.h"

#include <ogr_spatialref.h>

#include <cmath>

#include "core/base/unknown.h"
#include "io/base/file_words.h"
#include "io/site/clouds/cloud_system.h"
#include "io/site/gdal_session.h"
#include "io/site/system_way.h"

namespace rubble::io {

CloudPlace::CloudPlace(const PointCloud& cloud, const Frame& frame, const Site& site, Findings& findings)
    : m_place(frame, site), m_heightShift(site.heightShift) {
    const CloudUnits& units = cloud.head().units;
    if (units.geocentric) {
        refuseContent({"cloud.no_plan", "{0} counts its places from the centre of the Earth", {cloud.path()}},
                      "Bring it to a projected system, such as the UTM zone of the place.");
    }
    m_metres = units.metres;
    m_heightMetres = units.heightMetres;
    findWay(cloud, frame, site, findings);
    if (units.degrees && !m_way) {
        refuseContent({"cloud.degrees_alone",
                       "{0} lies in degrees ({1}), and the case does not say where on Earth it is",
                       {cloud.path(), units.name}},
                      "Give the case the coordinate system of its site, such as EPSG:25832.");
    }
}

CloudPlace::~CloudPlace() = default;

void CloudPlace::findWay(const PointCloud& cloud, const Frame& frame, const Site& site, Findings& findings) {
    const CloudHead& head = cloud.head();
    const GdalSession session;
    OGRSpatialReference own;
    OGRSpatialReference other;
    const bool ownKnown = setFromText(own, head.crs) && own.IsLocal() == 0;
    const bool otherKnown = setFromText(other, frame.crs) && other.IsLocal() == 0;
    if (!ownKnown && otherKnown) {
        addFinding(findings, cloud.path(),
                   {"cloud.unplaced", "the cloud names no coordinate system; it is taken to be that of the case", {}},
                   "make sure that both are in the same one, or name that of the cloud (rubble-cli cloud --crs)");
    }
    if (!ownKnown) {
        return;
    }
    const std::string datum = heightSystemOf(own);
    const std::string ofCase = otherKnown ? heightSystemOf(other) : "";
    if (!datum.empty() && datum != ofCase && site.heightShift == 0.0) {
        addFinding(findings, cloud.path(),
                   ofCase.empty()
                       ? Message{"cloud.datum_kept",
                                 "heights of the cloud count from \"{0}\", and the case names no vertical datum; they were "
                                 "not converted",
                                 {datum}}
                       : Message{"cloud.other_datum",
                                 "heights of the cloud count from \"{0}\", those of the case from \"{1}\"; they were not "
                                 "converted",
                                 {datum, ofCase}},
                   "set the height shift of the site to the difference there");
    }
    const Vec3 middle = m_place.toWorld(Vec3::Zero());
    addWayFindings(findings, cloud.path(), &own, frame.crs,
                   otherKnown ? degreesOf(other, middle.head<2>() / other.GetLinearUnits()) : Eigen::Vector2d(unknown, unknown));
    if (!otherKnown || sameSystem(head.crs, frame.crs)) {
        return;
    }
    own.StripVertical();
    other.StripVertical();
    own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    other.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (own.IsSame(&other) != FALSE) {
        return;
    }
    m_way.reset(OGRCreateCoordinateTransformation(&own, &other));
    m_metres = other.GetLinearUnits();
    if (!m_way) {
        refuseContent({"cloud.no_way", "There is no way from the system of {0} to that of the case", {cloud.path()}},
                      "Project the cloud to the system of the case first.");
    }
    addFinding(findings, cloud.path(),
               {"cloud.projected", "the points were projected from \"{0}\" to the system of the case", {head.units.name}},
               "none is needed");
}

void CloudPlace::toLocal(std::vector<Vec3>& places) const {
    if (m_way && !places.empty()) {
        const GdalSession session;
        std::vector<double> x(places.size());
        std::vector<double> y(places.size());
        std::vector<int> done(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            x[i] = places[i].x();
            y[i] = places[i].y();
        }
        m_way->Transform(places.size(), x.data(), y.data(), nullptr, done.data());
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i].head<2>() = done[i] != 0 ? Eigen::Vector2d(x[i], y[i]) : Eigen::Vector2d(unknown, unknown);
        }
    }
    for (Vec3& place : places) {
        const Vec3 world(place.x() * m_metres, place.y() * m_metres, place.z() * m_heightMetres + m_heightShift);
        place = m_place.toLocal(world);
    }
}

}  // namespace rubble::io
