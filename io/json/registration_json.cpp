#include "io/json/registration_json.h"

#include <nlohmann/json.hpp>

#include "core/scenario/photograph.h"
#include "io/json/scope_json.h"

namespace rubble::io {

namespace {

double lengthFrom(const JsonCursor& number) {
    const double length = number.number();
    if (length < 0.0) {
        number.fail("metres, not below zero");
    }
    return length;
}

std::int64_t countFrom(const JsonCursor& number) {
    const std::int64_t count = number.integer();
    if (count < 0) {
        number.fail("a count");
    }
    return count;
}

}  // namespace

nlohmann::json registrationJson(const Registration& registration) {
    nlohmann::json object{{"turn_rad", jsonVector(registration.turn)},
                          {"about_m", jsonVector(registration.about)},
                          {"shift_m", jsonVector(registration.shift)},
                          {"pairs", registration.pairs},
                          {"pairs_rms_m", jsonNumber(registration.pairsLeft)},
                          {"fitted", registration.fitted},
                          {"fit_rms_before_m", jsonNumber(registration.fitBefore)},
                          {"fit_rms_m", jsonNumber(registration.fitLeft)}};
    if (registration.control) {
        object["control_error_m"] = jsonNumber(*registration.control);
    }
    if (registration.error) {
        object["error_m"] = jsonNumber(*registration.error);
    }
    return object;
}

Registration registrationFromJson(const JsonCursor& object) {
    object.allowOnly({"turn_rad", "about_m", "shift_m", "pairs", "pairs_rms_m", "fitted", "fit_rms_before_m", "fit_rms_m",
                      "control_error_m", "error_m"});
    Registration made;
    made.turn = object["turn_rad"].vector();
    made.about = object["about_m"].vector();
    made.shift = object["shift_m"].vector();
    made.pairs = countFrom(object["pairs"]);
    made.pairsLeft = lengthFrom(object["pairs_rms_m"]);
    made.fitted = countFrom(object["fitted"]);
    made.fitBefore = lengthFrom(object["fit_rms_before_m"]);
    made.fitLeft = lengthFrom(object["fit_rms_m"]);
    if (object.has("control_error_m")) {
        made.control = lengthFrom(object["control_error_m"]);
    }
    if (object.has("error_m")) {
        made.error = lengthFrom(object["error_m"]);
    }
    return made;
}

std::string clockTimeFromJson(const JsonCursor& text) {
    if (clockTime(text.text()) != text.text() || text.text().empty()) {
        text.fail("date and time, such as 2021-06-25 16:30:00");
    }
    return text.text();
}

nlohmann::json removalsJson(const std::vector<Removal>& removals) {
    nlohmann::json list = nlohmann::json::array();
    for (const Removal& removal : removals) {
        list.push_back({{"name", removal.name}, {"time", removal.time}, {"area_m", outlineJson(removal.area)}});
    }
    return list;
}

std::vector<Removal> removalsFromJson(const JsonCursor& list) {
    std::vector<Removal> removals;
    for (const JsonCursor& entry : list.elements()) {
        entry.allowOnly({"name", "time", "area_m"});
        removals.push_back({entry["name"].text(), clockTimeFromJson(entry["time"]), outlineFromJson(entry["area_m"])});
    }
    return removals;
}

}  // namespace rubble::io
