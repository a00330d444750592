#include "io/site/map_place.h"

#include <ogr_spatialref.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/message.h"
#include "io/site/gdal_session.h"
#include "io/site/system_way.h"

namespace rubble::io {

MapPlace::MapPlace(const Frame& frame, const Site& site) : m_site(frame, site), m_system(std::make_unique<OGRSpatialReference>()) {
    const GdalSession session;
    if (frame.crs.empty()) {
        setLocal();
        return;
    }
    if (!setFromText(*m_system, frame.crs)) {
        throw UsageError({"map.unknown_crs", "The coordinate system \"{0}\" of the case is not known.", {frame.crs}},
                         {"map.unknown_crs.remedy", "Give the case an EPSG code, EPSG:25832 for example, or none.", {}});
    }
    if (m_system->IsGeographic() || m_system->IsGeocentric()) {
        throw UsageError(
            {"map.crs_in_degrees", "The coordinate system \"{0}\" of the case is not one of eastings and northings.", {frame.crs}},
            {"map.crs_in_degrees.remedy", "Give the case a projected system, such as the UTM zone of the site.", {}});
    }
    if (m_site.system().empty()) {
        m_system->Clear();
        setLocal();
        return;
    }
    m_system->StripVertical();
    m_system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    m_metresPerUnit = m_system->GetLinearUnits();
    const char* name = m_system->GetName();
    m_name = name != nullptr ? name : frame.crs;
}

MapPlace::~MapPlace() = default;

std::string MapPlace::words() const {
    if (m_metresPerUnit == 1.0) {
        return std::string(m_site.words());
    }
    constexpr std::string_view metres = "metres, ";
    return "easting and northing in units of the coordinate system, " + englishNumber(m_metresPerUnit) +
           " m each, heights in metres; " + std::string(m_site.words().substr(metres.size()));
}

void MapPlace::setLocal() {
    m_name = m_site.upright() ? "local, metres" : "that of the control points, metres";
    m_system->SetLocalCS(m_site.upright() ? "Local frame of the case" : "Frame of the control points");
    m_system->SetLinearUnits(SRS_UL_METER, 1.0);
}

std::array<double, 6> MapPlace::pixels(const Eigen::Vector2d& corner, double side) const {
    const SiteFit& site = m_site.transform();
    const Eigen::Vector2d at = (*this)(corner);
    // Pixels of an upright map have no turn of rounding.
    const double step = site.scale * side / m_metresPerUnit;
    const double along = site.angle == 0.0 ? step : step * std::cos(site.angle);
    const double across = site.angle == 0.0 ? 0.0 : step * std::sin(site.angle);
    return {at.x(), along, across, at.y(), across, -along};
}

}  // namespace rubble::io
