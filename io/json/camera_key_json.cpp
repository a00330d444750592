#include "io/json/camera_key_json.h"

#include <nlohmann/json.hpp>

namespace rubble::io {

namespace {

constexpr double angleMax = 179.0;  // degrees

CameraKey cameraKeyFrom(const JsonCursor& entry) {
    entry.allowOnly({"time", "position_m", "focal_point_m", "up", "view_angle_deg", "parallel", "parallel_scale_m"});
    CameraKey key;
    key.time = entry["time"].number();
    key.position = entry["position_m"].vector();
    key.focalPoint = entry["focal_point_m"].vector();
    key.up = entry["up"].vector();
    key.viewAngle = entry["view_angle_deg"].number();
    key.parallel = entry["parallel"].flag();
    key.parallelScale = entry["parallel_scale_m"].number();
    if (key.position == key.focalPoint) {
        entry["focal_point_m"].fail("a point that is not the position");
    }
    if (!(key.up.norm() > 0.0)) {
        entry["up"].fail("a direction");
    }
    if (!(key.viewAngle > 0.0 && key.viewAngle <= angleMax)) {
        entry["view_angle_deg"].fail("an angle above 0 and up to 179 degrees");
    }
    if (!(key.parallelScale > 0.0)) {
        entry["parallel_scale_m"].fail("a length above 0");
    }
    return key;
}

}  // namespace

nlohmann::json cameraKeysJson(const std::vector<CameraKey>& keys) {
    nlohmann::json list = nlohmann::json::array();
    for (const CameraKey& key : keys) {
        list.push_back({{"time", key.time},
                        {"position_m", jsonVector(key.position)},
                        {"focal_point_m", jsonVector(key.focalPoint)},
                        {"up", jsonVector(key.up)},
                        {"view_angle_deg", key.viewAngle},
                        {"parallel", key.parallel},
                        {"parallel_scale_m", key.parallelScale}});
    }
    return list;
}

std::vector<CameraKey> cameraKeysFromJson(const JsonCursor& list) {
    std::vector<CameraKey> keys;
    for (const JsonCursor& entry : list.elements()) {
        keys.push_back(cameraKeyFrom(entry));
        if (keys.size() > 1 && !(keys[keys.size() - 2].time < keys.back().time)) {
            entry["time"].fail("a time after that of the key before");
        }
    }
    return keys;
}

}  // namespace rubble::io
