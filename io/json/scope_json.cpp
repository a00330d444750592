#include "io/json/scope_json.h"

#include <nlohmann/json.hpp>

namespace rubble::io {

namespace {

OutlineRing ringFromJson(const JsonCursor& corners) {
    OutlineRing ring;
    for (const JsonCursor& corner : corners.elements()) {
        const auto numbers = corner.elements();
        if (numbers.size() != 2) {
            corner.fail("two numbers");
        }
        ring.emplace_back(numbers[0].number(), numbers[1].number());
    }
    if (ring.size() < 3) {
        corners.fail("three corners or more");
    }
    return ring;
}

}  // namespace

nlohmann::json outlineJson(const Outline& outline) {
    nlohmann::json polygons = nlohmann::json::array();
    for (const OutlinePolygon& polygon : outline.polygons) {
        nlohmann::json rings = nlohmann::json::array();
        for (const OutlineRing& ring : polygon) {
            nlohmann::json corners = nlohmann::json::array();
            for (const Eigen::Vector2d& corner : ring) {
                corners.push_back({jsonNumber(corner.x()), jsonNumber(corner.y())});
            }
            rings.push_back(std::move(corners));
        }
        polygons.push_back(std::move(rings));
    }
    return polygons;
}

Outline outlineFromJson(const JsonCursor& polygons) {
    Outline outline;
    for (const JsonCursor& polygon : polygons.elements()) {
        OutlinePolygon& read = outline.polygons.emplace_back();
        for (const JsonCursor& ring : polygon.elements()) {
            read.push_back(ringFromJson(ring));
        }
        if (read.empty()) {
            polygon.fail("one ring or more");
        }
    }
    return outline;
}

}  // namespace rubble::io
