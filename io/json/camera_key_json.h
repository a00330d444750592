#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/scenario/case.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// The camera keys of a case as they stand in its file, and back. Reading throws ParseError with the place.
nlohmann::json cameraKeysJson(const std::vector<CameraKey>& keys);
std::vector<CameraKey> cameraKeysFromJson(const JsonCursor& list);

}  // namespace rubble::io
