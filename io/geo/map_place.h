#pragma once

#include <memory>
#include <string>

#include "core/base/geometry.h"
#include "core/fe/frame.h"

class OGRSpatialReference;

namespace rubble::io {

/// Where a map of a case lies: its coordinate system, and how local coordinates become those of the system.
class MapPlace {
public:
    /// Throws UsageError if the case names a coordinate system that is not known or whose coordinates are angles.
    explicit MapPlace(const Frame& frame);
    ~MapPlace();
    MapPlace(const MapPlace&) = delete;
    MapPlace& operator=(const MapPlace&) = delete;

    /// The system of the case; without one a local system in metres.
    const OGRSpatialReference& system() const { return *m_system; }
    /// Easting and northing in units of the system from local metres.
    Eigen::Vector2d operator()(const Eigen::Vector2d& local) const { return (local + m_offset) / m_metresPerUnit; }
    double metresPerUnit() const { return m_metresPerUnit; }
    /// m, height of the local zero.
    double zeroHeight() const { return m_zeroHeight; }
    /// Name of the system, for people.
    const std::string& name() const { return m_name; }

private:
    std::unique_ptr<OGRSpatialReference> m_system;
    Eigen::Vector2d m_offset = Eigen::Vector2d::Zero();  ///< m
    double m_metresPerUnit = 1.0;
    double m_zeroHeight = 0.0;
    std::string m_name;
};

}  // namespace rubble::io
