#pragma once

#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/evidence/photographs/camera_match.h"
#include "core/scenario/photograph.h"

namespace rubble {

/// What speaks against resting a conclusion on a photograph, by its camera.
struct MatchDoubt {
    std::string_view key;  ///< "poor_camera", "stated_camera"
    Message what;
};

std::vector<MatchDoubt> matchDoubts(const Photograph& photograph, const CameraMatch& match);

}  // namespace rubble
