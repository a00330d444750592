#include "tests/support/study_comparison.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace rubble::cli {

namespace {

constexpr std::array<std::string_view, 13> decidedByClocks{
    "wall_s", "ms_per_step_mean", "ms_per_step_worst", "fps",       "fps_worst", "others_share", "threads", "kept",
    "cache",  "machine",          "table_1",           "predicted", "exports"};

}  // namespace

nlohmann::json withoutTimes(const nlohmann::json& study) {
    if (study.is_array()) {
        nlohmann::json rows = nlohmann::json::array();
        for (const nlohmann::json& row : study) {
            rows.push_back(withoutTimes(row));
        }
        return rows;
    }
    if (!study.is_object()) {
        return study;
    }
    nlohmann::json rest = nlohmann::json::object();
    for (const auto& [key, value] : study.items()) {
        if (std::find(decidedByClocks.begin(), decidedByClocks.end(), key) == decidedByClocks.end()) {
            rest[key] = withoutTimes(value);
        }
    }
    return rest;
}

}  // namespace rubble::cli
