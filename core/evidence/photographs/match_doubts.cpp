#include "core/evidence/photographs/match_doubts.h"

namespace rubble {

std::vector<MatchDoubt> matchDoubts(const Photograph& photograph, const CameraMatch& match) {
    std::vector<MatchDoubt> doubts;
    if (match.verdict == MatchVerdict::Poor) {
        doubts.push_back({"poor_camera", {"caution.poor_camera", "poor match of the camera: do not rest a conclusion on it", {}}});
    }
    if (cameraStated(photograph)) {
        doubts.push_back({"stated_camera",
                          {"caution.stated_camera",
                           "the camera is the one that the cloud states for its picture: how well it is known nobody said, and no "
                           "spread here holds it",
                           {}}});
    }
    return doubts;
}

}  // namespace rubble
