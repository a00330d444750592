#pragma once

#include <memory>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "io/site/clouds/point_cloud.h"
#include "io/site/site_place.h"

class OGRCoordinateTransformation;

namespace rubble::io {

/// Brings the points of a cloud into the local frame of a case: by the systems of both, the units of the cloud, the height shift of
/// the site, and its control points or the origin of the frame.
class CloudPlace {
public:
    /// What is assumed on the way is a counted finding.
    /// Throws ParseError (degrees in a case without a system, places from the centre of the Earth, no way between the systems).
    CloudPlace(const PointCloud& cloud, const Frame& frame, const Site& site, Findings& findings);
    ~CloudPlace();

    /// @param places  in units of the file; then m, local. What has no place in the system of the case is not a number then.
    void toLocal(std::vector<Vec3>& places) const;

private:
    void findWay(const PointCloud& cloud, const Frame& frame, const Site& site, Findings& findings);

    SitePlace m_place;
    double m_heightShift;
    double m_metres = 1.0;
    double m_heightMetres = 1.0;
    std::unique_ptr<OGRCoordinateTransformation> m_way;  ///< null: both are in one system
};

}  // namespace rubble::io
