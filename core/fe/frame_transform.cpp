#include "core/fe/frame_transform.h"

#include <cmath>

#include "core/base/error.h"

namespace rubble {

namespace {

// Rows are the local axes in axes of the file; the cyclic order keeps the hand.
Mat3 rotationFrom(const std::string& upAxis) {
    Mat3 rotation = Mat3::Identity();
    if (upAxis == "y") {
        rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    } else if (upAxis == "x") {
        rotation << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    } else if (upAxis == "-z") {
        rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;
    } else if (upAxis == "-y") {
        rotation << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    } else if (upAxis == "-x") {
        rotation << 0, 1, 0, 0, 0, -1, -1, 0, 0;
    } else if (upAxis != "z") {
        throw UsageError({"frame.up_axis", "\"{0}\" is not an axis that can point up", {upAxis}},
                         {"frame.up_axis.remedy", "Set the up axis of the case's frame to x, y, z, -x, -y or -z.", {}});
    }
    return rotation;
}

}  // namespace

FrameTransform::FrameTransform(const Frame& frame)
    : m_rotation(rotationFrom(frame.upAxis)), m_origin(frame.origin.cast<double>()), m_metresPerUnit(frame.metresPerUnit) {
    if (!std::isfinite(m_metresPerUnit) || m_metresPerUnit <= 0.0) {
        throw UsageError({"frame.unit", "The length unit of the frame is {0}", {{m_metresPerUnit, "m"}}},
                         {"frame.unit.remedy", "Give the length of the file's unit in metres, 0.001 for millimetres.", {}});
    }
}

}  // namespace rubble
