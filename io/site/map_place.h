#pragma once

#include <array>
#include <memory>
#include <string>

#include "io/site/site_place.h"

class OGRSpatialReference;

namespace rubble::io {

/// Where a map of a case lies: its coordinate system, and how local coordinates become those of the system.
class MapPlace {
public:
    /// Throws UsageError if the case names a coordinate system that is not known or whose coordinates are angles, and as SitePlace.
    MapPlace(const Frame& frame, const Site& site);
    ~MapPlace();
    MapPlace(const MapPlace&) = delete;
    MapPlace& operator=(const MapPlace&) = delete;

    /// The system of the case; without one, or without a place of the model in it, a local system in metres.
    const OGRSpatialReference& system() const { return *m_system; }
    /// Easting and northing in units of the system from local metres.
    Eigen::Vector2d operator()(const Eigen::Vector2d& local) const { return m_site.planToWorld(local) / m_metresPerUnit; }
    /// Local metres from easting and northing in units of the system.
    Eigen::Vector2d toLocal(const Eigen::Vector2d& place) const { return m_site.planToLocal(place * m_metresPerUnit); }
    /// The affine terms of GDAL for square pixels along the local axes, rows against y.
    /// @param corner  m, local, where x of the pixels is least and y greatest; @param side  m
    std::array<double, 6> pixels(const Eigen::Vector2d& corner, double side) const;
    /// m, height of the local zero.
    double zeroHeight() const { return m_site.transform().height; }
    const SitePlace& site() const { return m_site; }
    /// How places of a file came to be, for people: as SitePlace has it, but in units of the system.
    std::string words() const;
    /// Name of the system, for people.
    const std::string& name() const { return m_name; }

private:
    void setLocal();

    SitePlace m_site;
    std::unique_ptr<OGRSpatialReference> m_system;
    double m_metresPerUnit = 1.0;
    std::string m_name;
};

}  // namespace rubble::io
