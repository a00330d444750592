#include "io/terrain/site_place.h"

namespace rubble::io {

SitePlace::SitePlace(const Frame& frame, const Site& site) : m_shift(FrameTransform(frame).point(Vec3::Zero())) {
    if (usedPoints(site.controlPoints) >= 2) {
        m_fit = fitControlPoints(site.controlPoints);
    }
}

}  // namespace rubble::io
