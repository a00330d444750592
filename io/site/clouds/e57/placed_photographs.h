#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/scenario/cloud_request.h"
#include "core/scenario/photograph.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// A picture that lies in a cloud with the camera that it states.
struct PlacedPhotograph {
    std::string name;  ///< for a file, with its ending
    std::vector<unsigned char> bytes;
    CameraKnowledge camera;  ///< lens as stated, without distortion, which an E57 has no place for
    /// Points on rays of the stated camera, m, local: a match of them is that camera. Their names begin as statedPairName.
    std::vector<PointPair> pairs;
};

/// A name for the file of a picture that no other of the cloud has. @param number  of it among them, from 0
std::string photographFileName(const CloudPhotograph& picture, std::size_t number);

/// Whether a picture has a pinhole and a pose.
bool hasPlace(const CloudPhotograph& picture);

/// The pictures of a cloud that have a pinhole and a pose, as they lie in a case. Others, and what is assumed on the way to the
/// case, are findings. Throws as openCloud() and CloudPlace, Cancelled.
/// @param read    how the cloud is read
/// @param placed  by which the cloud is moved once its coordinates were brought to the case; unset: not at all
std::vector<PlacedPhotograph> placedPhotographs(const std::string& cloud, const CloudRequest& read, const Frame& frame,
                                                const Site& site, const std::optional<Registration>& placed, Findings& findings,
                                                const Execution& execution = Execution());

}  // namespace rubble::io
