#include "io/json/site_json.h"

#include <nlohmann/json.hpp>

namespace rubble::io {

nlohmann::json siteJson(const Site& site) {
    nlohmann::json points = nlohmann::json::array();
    for (const ControlPoint& point : site.controlPoints) {
        points.push_back({{"name", point.name},
                          {"local_m", jsonVector(point.local)},
                          {"world_m", jsonVector(point.world)},
                          {"used", point.used}});
    }
    nlohmann::json object{{"control_points", std::move(points)},
                          {"height_shift_m", jsonNumber(site.heightShift)},
                          {"collide_with_surroundings", site.collide}};
    if (!site.groundClasses.empty()) {
        object["ground_classes"] = site.groundClasses;
    }
    return object;
}

Site siteFromJson(const JsonCursor& object) {
    object.allowOnly({"control_points", "height_shift_m", "collide_with_surroundings", "ground_classes"});
    Site site;
    for (const JsonCursor& point : object["control_points"].elements()) {
        point.allowOnly({"name", "local_m", "world_m", "used"});
        site.controlPoints.push_back(
            {point["name"].text(), point["local_m"].vector(), point["world_m"].vector(), point["used"].flag()});
    }
    site.heightShift = object["height_shift_m"].number();
    site.collide = object["collide_with_surroundings"].flag();
    if (object.has("ground_classes")) {
        for (const JsonCursor& kind : object["ground_classes"].elements()) {
            if (kind.integer() < 0 || kind.integer() > groundClassMost) {
                kind.fail("a class from 0 to 255");
            }
            site.groundClasses.push_back(static_cast<std::uint16_t>(kind.integer()));
        }
    }
    return site;
}

void putCloudRequest(nlohmann::json& object, const CloudRequest& read, const std::string& of) {
    if (!read.crs.empty()) {
        object[of + "crs"] = read.crs;
    }
    if (!read.columns.empty()) {
        object[of + "columns"] = read.columns;
    }
}

CloudRequest cloudRequestFromJson(const JsonCursor& object, const std::string& of) {
    CloudRequest read;
    if (object.has(of + "crs")) {
        read.crs = object[of + "crs"].text();
    }
    if (object.has(of + "columns")) {
        for (const JsonCursor& column : object[of + "columns"].elements()) {
            read.columns.push_back(column.text());
        }
    }
    return read;
}

}  // namespace rubble::io
