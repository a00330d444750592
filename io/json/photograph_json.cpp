#include "io/json/photograph_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace rubble::io {

using nlohmann::json;

namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::int64_t sideMax = 100000;  // px

json optionalJson(const std::optional<double>& value) {
    return value ? jsonNumber(*value) : json();
}

std::optional<double> optionalNumber(const JsonCursor& cursor) {
    return cursor.value().is_null() ? std::nullopt : std::optional(cursor.number());
}

json pointJson(const Vec2& point) {
    return json::array({point.x(), point.y()});
}

Vec2 pointFrom(const JsonCursor& cursor) {
    const auto numbers = cursor.elements();
    if (numbers.size() != 2) {
        cursor.fail("two numbers");
    }
    return {numbers[0].number(), numbers[1].number()};
}

json factsJson(const PhotoFacts& facts) {
    json object{{"width_px", facts.width},
                {"height_px", facts.height},
                {"orientation", facts.orientation},
                {"focal_length_mm", optionalJson(facts.focalLength)},
                {"focal_length_35_mm", optionalJson(facts.focalLength35)},
                {"camera", facts.camera},
                {"taken", facts.taken},
                {"altitude_m", optionalJson(facts.altitude)}};
    object["recorded_px"] = facts.recorded ? json::array({(*facts.recorded)[0], (*facts.recorded)[1]}) : json();
    object["position_deg"] = facts.position ? json::array({(*facts.position)[0], (*facts.position)[1]}) : json();
    return object;
}

int intFrom(const JsonCursor& cursor, std::int64_t least, std::int64_t most) {
    const std::int64_t number = cursor.integer();
    if (number < least || number > most) {
        cursor.fail("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return static_cast<int>(number);
}

PhotoFacts factsFrom(const JsonCursor& cursor) {
    cursor.allowOnly({"width_px", "height_px", "orientation", "recorded_px", "focal_length_mm", "focal_length_35_mm", "camera",
                      "taken", "position_deg", "altitude_m"});
    PhotoFacts facts;
    facts.width = intFrom(cursor["width_px"], 1, sideMax);
    facts.height = intFrom(cursor["height_px"], 1, sideMax);
    facts.orientation = intFrom(cursor["orientation"], 1, 8);
    if (const JsonCursor recorded = cursor["recorded_px"]; !recorded.value().is_null()) {
        const auto sides = recorded.elements();
        if (sides.size() != 2) {
            recorded.fail("width and height");
        }
        facts.recorded = {intFrom(sides[0], 1, sideMax), intFrom(sides[1], 1, sideMax)};
    }
    facts.focalLength = optionalNumber(cursor["focal_length_mm"]);
    facts.focalLength35 = optionalNumber(cursor["focal_length_35_mm"]);
    facts.camera = cursor["camera"].text();
    facts.taken = cursor["taken"].text();
    facts.altitude = optionalNumber(cursor["altitude_m"]);
    if (const JsonCursor place = cursor["position_deg"]; !place.value().is_null()) {
        const Vec2 point = pointFrom(place);
        facts.position = {point.x(), point.y()};
    }
    return facts;
}

json cameraJson(const CameraKnowledge& camera) {
    return {{"focal_px", optionalJson(camera.focal)},
            {"principal_px", camera.principal ? pointJson(*camera.principal) : json()},
            {"principal_free", camera.freePrincipal},
            {"radial_terms", camera.radialTerms ? json(*camera.radialTerms) : json()},
            {"radial", pointJson(camera.radial)}};
}

CameraKnowledge cameraFrom(const JsonCursor& cursor, const PhotoFacts& facts) {
    cursor.allowOnly({"focal_px", "principal_px", "principal_free", "radial_terms", "radial"});
    CameraKnowledge camera;
    camera.width = facts.width;
    camera.height = facts.height;
    camera.focal = optionalNumber(cursor["focal_px"]);
    if (camera.focal && !(*camera.focal > 0.0)) {
        cursor["focal_px"].fail("a focal length above zero");
    }
    if (const JsonCursor principal = cursor["principal_px"]; !principal.value().is_null()) {
        camera.principal = pointFrom(principal);
    }
    camera.freePrincipal = cursor["principal_free"].flag();
    if (const JsonCursor terms = cursor["radial_terms"]; !terms.value().is_null()) {
        camera.radialTerms = intFrom(terms, 0, 2);
    }
    camera.radial = pointFrom(cursor["radial"]);
    return camera;
}

json masksJson(const std::vector<PhotoMask>& masks) {
    json list = json::array();
    for (const PhotoMask& mask : masks) {
        json corners = json::array();
        for (const Vec2& corner : mask.corners) {
            corners.push_back(pointJson(corner));
        }
        list.push_back({{"class", maskName(mask.kind)}, {"corners_px", std::move(corners)}});
    }
    return list;
}

PhotoMask maskFrom(const JsonCursor& cursor) {
    cursor.allowOnly({"class", "corners_px"});
    PhotoMask mask;
    const std::string name = cursor["class"].text();
    const auto kind = std::find_if(maskClasses.begin(), maskClasses.end(), [&](MaskClass each) { return maskName(each) == name; });
    if (kind == maskClasses.end()) {
        cursor["class"].fail("debris, moved, hidden or not_debris");
    }
    mask.kind = *kind;
    for (const JsonCursor& corner : cursor["corners_px"].elements()) {
        mask.corners.push_back(pointFrom(corner));
    }
    if (mask.corners.size() < 3) {
        cursor["corners_px"].fail("three corners or more");
    }
    return mask;
}

Photograph photographFrom(const JsonCursor& cursor) {
    cursor.allowOnly({"input", "note", "facts", "time_s", "time_uncertainty_s", "camera", "pairs", "masks"});
    Photograph photograph;
    photograph.input = cursor["input"].text();
    photograph.note = cursor["note"].text();
    photograph.facts = factsFrom(cursor["facts"]);
    photograph.time = optionalNumber(cursor["time_s"]);
    photograph.timeUncertainty = cursor["time_uncertainty_s"].number();
    if (photograph.timeUncertainty < 0.0) {
        cursor["time_uncertainty_s"].fail("a number of seconds, not below zero");
    }
    photograph.camera = cameraFrom(cursor["camera"], photograph.facts);
    for (const JsonCursor& pair : cursor["pairs"].elements()) {
        pair.allowOnly({"name", "picture_px", "model_m"});
        photograph.pairs.push_back({pair["name"].text(), pointFrom(pair["picture_px"]), pair["model_m"].vector()});
    }
    for (const JsonCursor& mask : cursor["masks"].elements()) {
        photograph.masks.push_back(maskFrom(mask));
    }
    return photograph;
}

}  // namespace

json photographsJson(const std::vector<Photograph>& photographs) {
    json list = json::array();
    for (const Photograph& photograph : photographs) {
        json pairs = json::array();
        for (const PointPair& pair : photograph.pairs) {
            pairs.push_back({{"name", pair.name}, {"picture_px", pointJson(pair.picture)}, {"model_m", jsonVector(pair.model)}});
        }
        list.push_back({{"input", photograph.input},
                        {"note", photograph.note},
                        {"facts", factsJson(photograph.facts)},
                        {"time_s", optionalJson(photograph.time)},
                        {"time_uncertainty_s", photograph.timeUncertainty},
                        {"camera", cameraJson(photograph.camera)},
                        {"pairs", std::move(pairs)},
                        {"masks", masksJson(photograph.masks)}});
    }
    return list;
}

std::vector<Photograph> photographsFromJson(const JsonCursor& list) {
    std::vector<Photograph> photographs;
    for (const JsonCursor& entry : list.elements()) {
        photographs.push_back(photographFrom(entry));
    }
    return photographs;
}

}  // namespace rubble::io
