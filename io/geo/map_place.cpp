#include "io/geo/map_place.h"

#include <ogr_spatialref.h>

#include "core/base/error.h"
#include "io/fragment_places.h"
#include "io/geo/gdal_memory.h"

namespace rubble::io {

MapPlace::MapPlace(const Frame& frame) : m_system(std::make_unique<OGRSpatialReference>()) {
    const GdalCalls calls;
    const Vec3 offset = WorldOffset(frame).offset();
    m_offset = offset.head<2>();
    m_zeroHeight = offset.z();
    if (frame.crs.empty()) {
        m_name = "local, metres";
        m_system->SetLocalCS("Local frame of the case");
        m_system->SetLinearUnits(SRS_UL_METER, 1.0);
        return;
    }
    const auto limits = OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get();
    if (m_system->SetFromUserInput(frame.crs.c_str(), limits) != OGRERR_NONE) {
        throw UsageError({"map.unknown_crs", "The coordinate system \"{0}\" of the case is not known.", {frame.crs}},
                         {"map.unknown_crs.remedy", "Give the case an EPSG code, EPSG:25832 for example, or none.", {}});
    }
    if (m_system->IsGeographic() || m_system->IsGeocentric()) {
        throw UsageError(
            {"map.crs_in_degrees", "The coordinate system \"{0}\" of the case is not one of eastings and northings.", {frame.crs}},
            {"map.crs_in_degrees.remedy", "Give the case a projected system, such as the UTM zone of the site.", {}});
    }
    m_system->StripVertical();
    m_system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    m_metresPerUnit = m_system->GetLinearUnits();
    const char* name = m_system->GetName();
    m_name = name != nullptr ? name : frame.crs;
}

MapPlace::~MapPlace() = default;

}  // namespace rubble::io
