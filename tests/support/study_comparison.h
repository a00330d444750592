#pragma once

#include <nlohmann/json.hpp>

namespace rubble::cli {

/// The JSON of a study without what a clock, a machine or a cache decides: two executors agree in all the rest, bit for bit.
nlohmann::json withoutTimes(const nlohmann::json& study);

}  // namespace rubble::cli
