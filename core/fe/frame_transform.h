#pragma once

#include "core/base/geometry.h"
#include "core/fe/frame.h"

namespace rubble {

/// Takes coordinates of a file into the local frame of a case (m, z up) and back: p = R (metresPerUnit q - origin), where R is a
/// right-handed rotation that turns the file's up axis to z.
class FrameTransform {
public:
    /// Throws UsageError for a unit that is not positive or an up axis other than x, y, z, -x, -y, -z.
    explicit FrameTransform(const Frame& frame);

    Vec3 point(const Vec3& inFile) const { return m_rotation * (m_metresPerUnit * inFile - m_origin); }
    /// Displacement or velocity; not moved by the origin.
    Vec3 vector(const Vec3& inFile) const { return m_rotation * (m_metresPerUnit * inFile); }
    Vec3 pointInFile(const Vec3& local) const { return (m_rotation.transpose() * local + m_origin) / m_metresPerUnit; }
    /// m, the zero of the local frame along its own axes: added to local places it gives those of the file, z up.
    Vec3 localZero() const { return m_rotation * m_origin; }
    double metresPerUnit() const { return m_metresPerUnit; }

private:
    Mat3 m_rotation;
    Vec3 m_origin;  // m, axes of the file
    double m_metresPerUnit;
};

}  // namespace rubble
