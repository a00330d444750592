#include "app/cli/evidence/camera_output.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/cli/frame/text_output.h"

namespace rubble::cli {

namespace {

constexpr std::string_view numberNames[] = {"place_x_m",      "place_y_m",  "place_z_m", "turn_x_rad",
                                            "turn_y_rad",     "turn_z_rad", "focal_px",  "principal_x_px",
                                            "principal_y_px", "radial_1",   "radial_2"};

std::string_view verdictName(MatchVerdict verdict) {
    return verdict == MatchVerdict::Good ? "good" : verdict == MatchVerdict::Usable ? "usable" : "poor";
}

/// Compass bearing and elevation of where a camera looks, degrees.
std::pair<double, double> directionOf(const CameraModel& camera) {
    const Vec3 ahead = camera.toCamera.conjugate() * Vec3::UnitZ();
    const double degree = 180.0 / std::numbers::pi;
    const double bearing = std::atan2(ahead.x(), ahead.y()) * degree;
    return {bearing < 0.0 ? bearing + 360.0 : bearing, std::asin(std::clamp(ahead.z(), -1.0, 1.0)) * degree};
}

}  // namespace

TextTable residualTable(const CameraMatch& match, const std::vector<PointPair>& pairs) {
    TextTable table({{"pair", "name"},
                     {"right [px]", "residual_x_px"},
                     {"down [px]", "residual_y_px"},
                     {"length [px]", "length_px"},
                     {"used", "used"}});
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const Eigen::Vector2d& r = match.residuals[k];
        table.add({textCell(pairs[k].name), numberCell(r.x()), numberCell(r.y()), numberCell(r.norm()),
                   textCell(match.used[k] ? "yes" : "no, looks wrong")});
    }
    return table;
}

Json matchJson(const CameraMatch& match, const std::vector<PointPair>& pairs) {
    const CameraModel& camera = match.camera;
    const auto [bearing, elevation] = directionOf(camera);
    Json object;
    object["place_m"] = {camera.place.x(), camera.place.y(), camera.place.z()};
    object["rotation"] = {camera.toCamera.w(), camera.toCamera.x(), camera.toCamera.y(), camera.toCamera.z()};
    object["bearing_deg"] = bearing;
    object["elevation_deg"] = elevation;
    object["focal_px"] = camera.focal;
    object["principal_px"] = {camera.principal.x(), camera.principal.y()};
    object["radial"] = {camera.radial[0], camera.radial[1]};
    object["rms_px"] = match.rms;
    object["sigma_px"] = match.sigma;
    object["freedom"] = match.freedom;
    object["distance_m"] = match.distance;
    object["place_radius_95_m"] = match.placeRadius;
    object["turn_radius_95_deg"] = match.turnRadius * 180.0 / std::numbers::pi;
    object["verdict"] = verdictName(match.verdict);
    object["words"] = englishText(match.words);
    object["found"] = Json::array();
    for (const int number : match.found) {
        object["found"].push_back(numberNames[number]);
    }
    object["covariance"] = Json::array();
    for (Eigen::Index row = 0; row < match.covariance.rows(); ++row) {
        Json values = Json::array();
        for (Eigen::Index column = 0; column < match.covariance.cols(); ++column) {
            values.push_back(match.covariance(row, column));
        }
        object["covariance"].push_back(values);
    }
    object["pairs"] = Json::array();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        object["pairs"].push_back({{"name", pairs[k].name},
                                   {"residual_px", {match.residuals[k].x(), match.residuals[k].y()}},
                                   {"used", bool(match.used[k])}});
    }
    return object;
}

void printMatch(std::ostream& out, const CameraMatch& match, const std::vector<PointPair>& pairs) {
    const CameraModel& camera = match.camera;
    const auto found = [&](double value, std::size_t of) {
        const auto at = static_cast<Eigen::Index>(of);
        return spreadText(value, std::sqrt(match.covariance(at, at)));
    };
    FactList facts;
    static constexpr const char* axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        facts.add(std::string("place ") + axes[axis], found(camera.place[axis], static_cast<std::size_t>(axis)) + " m");
    }
    const auto [bearing, elevation] = directionOf(camera);
    facts.add("looks towards", englishNumber(bearing) + " degrees from y over x, " + englishNumber(elevation) + " degrees up");
    for (std::size_t k = 6; k < match.found.size(); ++k) {
        const int number = match.found[k];
        const double value = number == 6 ? camera.focal : number < 9 ? camera.principal[number - 7] : camera.radial[number - 9];
        facts.add(std::string(numberNames[number]), found(value, k));
    }
    facts.add("residuals", englishNumber(match.rms) + " px RMS, " + englishNumber(match.sigma) + " px of one coordinate");
    facts.print(out);
    residualTable(match, pairs).print(out);
    out << englishText(match.words) << '\n';
    for (const std::size_t k : match.wrong()) {
        out << "The pair " << pairs[k].name << " looks wrong: it lies " << englishNumber(match.residuals[k].norm()) << " px off.\n";
    }
}

}  // namespace rubble::cli
